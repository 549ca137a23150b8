// flip_filters.h: the weights of FLIP's filters: contrast sensitivity, edges and points.
#pragma once

#include <vector>

namespace raster::flip {

/// One half of each filter: weights[k] is for the pixels k steps away on either side, weights[0] for the middle.
/// The filters of the paper are products of these along x and along y.
struct Filters {
    /// For this many pixels a degree of the visual angle.
    explicit Filters(float pixels_per_degree);

    /// The farthest pixel that any filter looks at.
    int radius() const;

    /// Contrast sensitivity of the achromatic, red-green and blue-yellow channels (section 4.1 and table 1), even.
    /// Blue-yellow is the sum of two products.
    std::vector<float> lightness, red_green, blue_yellow_1, blue_yellow_2;
    /// For features (section 4.2): a Gaussian, even; its first derivative, odd; its second derivative, even.
    std::vector<float> smooth, slope, bend;
};

}  // namespace raster::flip
