// diff_steps.h: the steps of diff_images, which are of no use to others.
#pragma once

#include <raster/image/diff.h>
#include <raster/image/metrics.h>

namespace raster::diff_steps {

/// Width, height and so on of a picture of any type.
struct Shape {
    int width, height, channels;
    int bits;  ///< 8, 16, or 32 for floats
    std::string size() const { return std::to_string(width) + "x" + std::to_string(height); }
};
Shape shape_of(const AnyImage& image);

/// 1 for each pixel that counts, else 0; empty if all do.
Result<Image8> pixels_that_count(const Shape& shape, const DiffOptions& options);

/// What there is to say of NaN in pixels that count, or "".
std::string nan_report(const AnyImage& image, const Image8& compared, const std::string& which);

/// The picture with this many bits and channels.
AnyImage adapted(const AnyImage& image, int bits, int channels);

/// `actual` with the colours of `expected` where pixels do not count.
AnyImage with_ignored_equal(const AnyImage& expected, AnyImage actual, const Image8& compared);

PlainMetrics plain(const AnyImage& expected, const AnyImage& actual, std::int64_t compared, std::vector<float> zeros);

/// diff_images with `zeros` for plain_metrics.
Result<Diff> diff_images(const AnyImage& expected, const AnyImage& actual, const DiffOptions& options,
                         std::vector<float> zeros);

/// Lowers each delta to what remains when pixels may shift by up to `radius`: the larger of the distance from the
/// actual colour to the nearest expected one around, and the other way round.
void allow_shift(const AnyImage& expected, const AnyImage& actual, int radius, ImageF& deltas);
/// Whether every delta above `max_delta` goes down to it with this shift.
bool shift_explains_all(const AnyImage& expected, const AnyImage& actual, int radius, float max_delta,
                        const ImageF& deltas);

/// Verdict, would_pass and warnings from the figures and deltas. `peak` is the largest sample.
void judge(const AnyImage& expected, const AnyImage& actual, const Gates& gates, double peak, Diff& diff);

void find_regions(Diff& diff);

}  // namespace raster::diff_steps
