// write.h: one call that writes a picture in the format its file name asks for.
#pragma once

#include <string>

#include <raster/image/image.h>
#include <raster/image/png.h>
#include <raster/result.h>

namespace raster {

enum class OutputFormat { png, ppm, pgm, pfm };

/// The format of an output by its extension, upper or lower case: .png, .ppm, .pgm, .pfm. `otherwise` is for
/// names that need none: "-" (standard output) and devices such as /dev/null. Anything else is a usage error,
/// to be told before rendering.
Result<OutputFormat> output_format(const std::string& path, OutputFormat otherwise);

/// Writes whole or not at all (write_file), samples as given. Whole numbers go into PNG, PPM and PGM, floats
/// into PFM; the other way is a usage error, since whether and how to apply gamma is the caller's to say, and
/// so is colour into a PGM. PPM, PGM and PFM keep no alpha: it is left out; grey in a .ppm is repeated in R,
/// G and B. "-" is a PNG, or a PFM of floats. PNGs of 8 bits are made by encode_png_fast, on all threads.
Status write_image(const std::string& path, const Image8& image);
Status write_image(const std::string& path, const PackedImage& image);
Status write_image(const std::string& path, const Image16& image);
Status write_image(const std::string& path, const ImageF& image);

}  // namespace raster
