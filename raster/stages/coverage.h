// coverage.h: stage 7, which pixel centres a triangle covers.
#pragma once

#include <raster/stages/setup.h>

namespace raster {

/// The edge function at the centre of pixel (px, py), exact.
inline std::int64_t edge_at(const Edge<float>& e, int px, int py) {
    return e.origin + (std::int64_t(e.step_x) * px + std::int64_t(e.step_y) * py) * subpixels;
}

/// Inside the edge, or on it when it owns its points. The bias stays here: folded into the edge function itself it
/// would tilt barycentric coordinates.
inline bool is_inside(const Edge<float>& e, std::int64_t value) { return e.inclusive ? value >= 0 : value > 0; }

/// The same test in steps of whole pixels: is_inside(e, edge_at(e, px, py)) equals
/// pixel_origin(e) + step_x px + step_y py >= 0, because 256 divides everything but the origin.
template <class F>
inline EdgeValue<F> pixel_origin(const Edge<F>& e) {
    using V = EdgeValue<F>;
    return (e.origin - select(e.inclusive, V(0), V(1))) >> subpixel_bits;
}

}  // namespace raster
