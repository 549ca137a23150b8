// apng.h: animated PNG files (PNG specification, third edition, 11.3.6): several pictures in one file that browsers play.
#pragma once

#include <span>

#include <raster/image/file.h>
#include <raster/image/image.h>

namespace raster {

/// The frames one after the other, each for that many milliseconds (1 to 65535), for ever. Programs that know PNG alone
/// show the first. Errors: usage for no frames, or frames of several sizes.
Result<Bytes> encode_apng(std::span<const Image8> frames, int milliseconds);

}  // namespace raster
