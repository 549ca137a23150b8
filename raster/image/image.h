// image.h: a rectangle of samples in memory: width, height, channels, and nothing hidden.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace raster {

/// Samples of type T, interleaved by channel, rows from top to bottom, no padding.
/// `samples.size() == width * height * channels`; channels is 1 to 4 (grey, grey+alpha, RGB, RGBA).
template <class T>
struct Image {
    int width = 0;
    int height = 0;
    int channels = 0;
    std::vector<T> samples;

    Image() = default;
    Image(int width, int height, int channels, T fill = T{})
        : width(width),
          height(height),
          channels(channels),
          samples(std::size_t(width) * std::size_t(height) * std::size_t(channels), fill) {}

    bool empty() const { return samples.empty(); }
    /// First sample of the pixel in column x, row y (row 0 is on top).
    T* pixel(int x, int y) { return samples.data() + offset(x, y); }
    const T* pixel(int x, int y) const { return samples.data() + offset(x, y); }

    friend bool operator==(const Image&, const Image&) = default;

private:
    std::size_t offset(int x, int y) const {
        return (std::size_t(y) * std::size_t(width) + std::size_t(x)) * std::size_t(channels);
    }
};

using Image8 = Image<std::uint8_t>;    ///< 0 to 255, sRGB encoded or linear as its user says
using Image16 = Image<std::uint16_t>;  ///< 0 to 65535
using ImageF = Image<float>;           ///< linear, unbounded

}  // namespace raster
