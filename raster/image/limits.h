// limits.h: the largest picture that is read or written, checked before any memory is taken.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include <raster/image/image.h>
#include <raster/result.h>

namespace raster {

/// Sizes above these are refused. Decoding takes up to 12 bytes a pixel (24 where samples have 16 bits), so
/// at most 1.6 GB (3.2 GB) with these defaults, whatever a file says.
struct ImageLimits {
    int max_side = 16384;                              ///< pixels, width and height each
    std::int64_t max_pixels = std::int64_t(1) << 27;   ///< width * height: 134,217,728
};

/// What is wrong with a picture of this size, in words, or "" when it is allowed.
inline std::string size_problem(std::int64_t width, std::int64_t height, const ImageLimits& limits = {}) {
    const std::string size = std::to_string(width) + "x" + std::to_string(height) + " pixels";
    if (width < 1 || height < 1) return size + ": a picture has at least one pixel";
    if (width > limits.max_side || height > limits.max_side)
        return size + ": more than " + std::to_string(limits.max_side) + " a side";
    if (width * height > limits.max_pixels)
        return size + ": more than " + std::to_string(limits.max_pixels) + " in all";
    return "";
}

/// Whether an image can be written: sizes within the default limits, 1 to 4 channels, all samples there.
/// Anything else is a mistake of the caller's (usage).
template <class T>
Status check_image(const Image<T>& image) {
    std::string problem = size_problem(image.width, image.height);
    if (problem.empty() && (image.channels < 1 || image.channels > 4))
        problem = std::to_string(image.channels) + " channels: 1 to 4 are possible";
    if (problem.empty() && image.samples.size() != std::size_t(image.width) * std::size_t(image.height) *
                                                       std::size_t(image.channels))
        problem = "the number of samples is not width * height * channels";
    if (!problem.empty()) return Error{ErrorKind::usage, "image: " + problem};
    return Done{};
}

}  // namespace raster
