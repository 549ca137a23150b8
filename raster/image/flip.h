// flip.h: FLIP, the difference a person sees when two pictures alternate in place.
#pragma once

#include <optional>

#include <raster/image/decode.h>
#include <raster/image/image.h>
#include <raster/image/metrics.h>

namespace raster {

/// How the pictures are looked at: a screen of 3840 pixels on 0.7 m, from 0.7 m away, as in the paper. That is
/// 0.7 / (0.7 / 3840) * pi / 180, about 67.
inline constexpr float default_pixels_per_degree = 67.0206433f;

/// The LDR-FLIP error of each pixel, 0 (equal) to 1, one channel. Andersson, Nilsson, Akenine-Moller, Oskarsson,
/// Astrom, Fairchild: FLIP: A Difference Evaluator for Alternating Images, Proc. ACM Comput. Graph. Interact.
/// Tech. 3(2), 2020. Both pictures have one size and no NaN. 8 and 16 bits are sRGB encoded; floats are taken as
/// linear light and clamped to 0..1 (HDR-FLIP is another metric). Where there is transparency, the larger of the
/// errors over black and over white counts. `cells` says where the pictures differ: elsewhere the error is 0 by
/// definition and is not computed. `pixels_per_degree` is 5 to 500. The same bits for every number of threads
/// and lanes.
ImageF flip_map(const AnyImage& expected, const AnyImage& actual, const DifferingCells& cells,
                float pixels_per_degree = default_pixels_per_degree);

/// mean_of(flip_map(...)), bit for bit, without the map, which takes long to write and read. Into `steps`, if given, go
/// the errors rounded up to 1/31: of one channel, 0 only where the error is 0. Nothing where the map is needed after
/// all: for transparent pictures, and if an error is so tiny that the order of the sum matters.
std::optional<double> flip_mean(const AnyImage& expected, const AnyImage& actual, const DifferingCells& cells,
                                float pixels_per_degree, Image8* steps = nullptr);

}  // namespace raster
