// coarse.h: depth tests of whole rectangles at once, exact, from the extremes of the depths on both sides.
#pragma once

#include <algorithm>
#include <limits>

#include <raster/stages/depth.h>
#include <raster/stages/setup.h>

namespace raster::tiles {

/// The smallest and the largest encoded depth in a rectangle of pixels, or bounds on them; one rectangle a lane.
template <class F>
struct DepthRange {
    Int<F> min = Int<F>(0);
    Int<F> max = Int<F>(std::numeric_limits<std::int32_t>::max());
};

/// Whether value_at stays a number for every pixel of a target: products and sums cannot overflow to inf - inf.
template <class F>
inline Mask<F> is_tame(const DepthPlane<F>& p) {
    const F limit(1e30f);
    const Mask<F> origin = abs(p.origin) < limit, dadx = abs(p.dadx) < limit, dady = abs(p.dady) < limit;
    const Mask<F> offset = abs(p.offset) < limit;
    return Mask<F>(origin & dadx & dady & offset);
}

/// The smallest and the largest depth of a plane over the pixels x0..x1, y0..y1, encoded. Each rounding in value_at and
/// encode_depth keeps order, so the extremes lie at corners, to the last bit.
template <class F>
inline DepthRange<F> depth_range(DepthFormat format, const DepthPlane<F>& plane, F x0, F y0, F x1, F y1) {
    const Mask<F> right = plane.dadx >= F(0), down = plane.dady >= F(0), tame = is_tame(plane);
    const Int<F> low = encode_depth(format, value_at(plane, select(right, x0, x1), select(down, y0, y1)));
    const Int<F> high = encode_depth(format, value_at(plane, select(right, x1, x0), select(down, y1, y0)));
    const DepthRange<F> anything;
    return {select(tame, low, anything.min), select(tame, high, anything.max)};
}
inline DepthRange<float> depth_range(DepthFormat format, const DepthPlane<float>& plane, int x0, int y0, int x1,
                                     int y1) {
    return depth_range<float>(format, plane, float(x0), float(y0), float(x1), float(y1));
}

/// Whether no pixel can pass.
template <class F>
inline Mask<F> none_passes(Compare compare, const DepthRange<F>& incoming, const DepthRange<F>& stored) {
    switch (compare) {
        case Compare::never: return Mask<F>(true);
        case Compare::less: return incoming.min >= stored.max;
        case Compare::less_equal: return incoming.min > stored.max;
        case Compare::greater: return incoming.max <= stored.min;
        case Compare::greater_equal: return incoming.max < stored.min;
        case Compare::equal: return Mask<F>((incoming.min > stored.max) | (incoming.max < stored.min));
        case Compare::not_equal:
        case Compare::always: break;
    }
    return Mask<F>(false);
}

/// Whether every pixel passes.
template <class F>
inline Mask<F> all_pass(Compare compare, const DepthRange<F>& incoming, const DepthRange<F>& stored) {
    switch (compare) {
        case Compare::less: return incoming.max < stored.min;
        case Compare::less_equal: return incoming.max <= stored.min;
        case Compare::greater: return incoming.min > stored.max;
        case Compare::greater_equal: return incoming.min >= stored.max;
        case Compare::not_equal: return Mask<F>((incoming.min > stored.max) | (incoming.max < stored.min));
        case Compare::always: return Mask<F>(true);
        case Compare::never:
        case Compare::equal: break;
    }
    return Mask<F>(false);
}

}  // namespace raster::tiles
