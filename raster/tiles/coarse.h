// coarse.h: depth tests of whole rectangles at once, exact, from the extremes of the depths on both sides.
#pragma once

#include <algorithm>
#include <limits>

#include <raster/stages/depth.h>
#include <raster/stages/setup.h>

namespace raster::tiles {

/// The smallest and the largest encoded depth in a rectangle of pixels, or bounds on them.
struct DepthRange {
    std::int32_t min = 0;
    std::int32_t max = std::numeric_limits<std::int32_t>::max();
};

/// Whether value_at stays a number for every pixel of a target: products and sums cannot overflow to inf - inf.
inline bool is_tame(const Plane<float>& p) {
    constexpr float limit = 1e30f;
    return abs(p.origin) < limit && abs(p.dadx) < limit && abs(p.dady) < limit;
}

/// The range of a depth plane over the pixels x0..x1, y0..y1. Each rounding in value_at and encode_depth keeps order,
/// so the extremes lie at corners, to the last bit.
inline DepthRange depth_range(DepthFormat format, const Plane<float>& plane, int x0, int y0, int x1, int y1) {
    if (!is_tame(plane)) return {};
    const float fx0 = float(x0), fx1 = float(x1), fy0 = float(y0), fy1 = float(y1);
    const float left = plane.dadx >= 0 ? fx0 : fx1, right = plane.dadx >= 0 ? fx1 : fx0;
    const float top = plane.dady >= 0 ? fy0 : fy1, bottom = plane.dady >= 0 ? fy1 : fy0;
    return {encode_depth(format, value_at(plane, left, top)), encode_depth(format, value_at(plane, right, bottom))};
}

/// Whether no pixel can pass.
inline bool none_passes(Compare compare, DepthRange incoming, DepthRange stored) {
    switch (compare) {
        case Compare::never: return true;
        case Compare::less: return incoming.min >= stored.max;
        case Compare::less_equal: return incoming.min > stored.max;
        case Compare::greater: return incoming.max <= stored.min;
        case Compare::greater_equal: return incoming.max < stored.min;
        case Compare::equal: return incoming.min > stored.max || incoming.max < stored.min;
        case Compare::not_equal:
        case Compare::always: break;
    }
    return false;
}

/// Whether every pixel passes.
inline bool all_pass(Compare compare, DepthRange incoming, DepthRange stored) {
    switch (compare) {
        case Compare::less: return incoming.max < stored.min;
        case Compare::less_equal: return incoming.max <= stored.min;
        case Compare::greater: return incoming.min > stored.max;
        case Compare::greater_equal: return incoming.min >= stored.max;
        case Compare::not_equal: return incoming.min > stored.max || incoming.max < stored.min;
        case Compare::always: return true;
        case Compare::never:
        case Compare::equal: break;
    }
    return false;
}

/// What a stored range becomes when some of its pixels are replaced by incoming ones that passed.
inline DepthRange merged(Compare compare, DepthRange incoming, DepthRange stored) {
    const bool only_lowers = compare == Compare::less || compare == Compare::less_equal;
    return {std::min(incoming.min, stored.min), only_lowers ? stored.max : std::max(incoming.max, stored.max)};
}

}  // namespace raster::tiles
