// data_url.h: a file inside a page: data URLs (RFC 2397) in base64 (RFC 4648).
#pragma once

#include <span>
#include <string>

#include <raster/image/file.h>

namespace raster {

/// "data:TYPE;base64,..." for a MIME type such as "image/png".
std::string data_url(const char* type, const Bytes& bytes);

/// base64 alone. Of a multiple of 3 bytes it has no padding: such pieces may be put one behind the other.
std::string base64(std::span<const std::byte> bytes);
/// The same into a string that is there, which need not grow then.
void base64(std::span<const std::byte> bytes, std::string& text);

}  // namespace raster
