// metrics.h: how far two pictures are apart, in figures: largest and mean difference, RMS, PSNR, count, SSIM.
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include <raster/image/decode.h>
#include <raster/image/image.h>

namespace raster {

/// The figures that need no model of the eye. Differences are in steps of the samples as stored: 0 to 255 for 8
/// bits, 0 to 65535 for 16 bits, of any size for floats; alpha is a channel like the others.
struct PlainMetrics {
    std::int64_t differing = 0;  ///< pixels in which at least one channel differs
    double max = 0;              ///< largest difference of a sample
    int max_x = 0, max_y = 0;    ///< the first pixel that has it, in reading order
    double mean = 0;             ///< mean absolute difference over all samples
    double rms = 0;              ///< root of the mean squared difference
    /// Peak signal to noise ratio in dB, 20 log10(peak / rms), with peak 255, 65535 or 1.0 (floats);
    /// infinite when nothing differs.
    double psnr = std::numeric_limits<double>::infinity();
    /// For each pixel the largest difference over its channels, one channel; empty when nothing differs.
    ImageF deltas;
};

/// Compares sample by sample. The pictures have one size and the same channels, and no NaN. -0 equals 0,
/// infinity equals itself and is infinitely far from all else. `compared` is the number of pixels the means are
/// taken over: all, unless some were made equal because they are ignored. The same for every number of threads.
/// `zeros`, if it has one for each pixel, becomes the deltas: large memory takes its time to get.
template <class T>
PlainMetrics plain_metrics(const Image<T>& expected, const Image<T>& actual, std::int64_t compared,
                           std::vector<float> zeros = {});

/// Where two pictures differ, coarsely: so that what is expensive is done only there.
class DifferingCells {
public:
    explicit DifferingCells(const ImageF& deltas);
    /// Whether a pixel of the rectangle differs, or one nearby. The rectangle may reach beyond the picture.
    bool any_in(int x0, int y0, int x1, int y1) const;

private:
    static constexpr int cell = 32;
    int columns_, rows_;
    std::vector<std::uint8_t> differs_;
};

/// Mean structural similarity (Wang, Bovik, Sheikh, Simoncelli: Image Quality Assessment, IEEE TIP 13(4), 2004)
/// of the luma (Rec. 601, of sRGB encoded values): Gaussian window of 11x11 pixels and a standard deviation of
/// 1.5, K1 = 0.01, K2 = 0.03, windows wholly inside the picture; a smaller picture is extended by its edge. 1
/// for equal pictures, -1 at the least. Floats are taken as linear light, clamped to 0..1
/// and sRGB encoded. Where there is transparency, the smaller of the values over black and over white counts.
/// `compared` is empty or has a nonzero sample for each pixel whose window counts.
double mean_ssim(const AnyImage& expected, const AnyImage& actual, const DifferingCells& cells,
                 const Image8& compared = {});

/// The mean of a map of one channel over the pixels whose sample in `compared` is nonzero (all, if it is empty).
double mean_of(const ImageF& map, const Image8& compared = {});

}  // namespace raster
