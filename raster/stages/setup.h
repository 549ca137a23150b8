// setup.h: stage 6, what is computed once a triangle: three edge functions, and a plane for each interpolated value.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>

#include <raster/stages/cull.h>
#include <raster/stages/depth.h>

namespace raster {

/// What holds an edge function's value: 64 bits for one triangle; 32 bits a lane for packs, whose caller measures
/// positions from nearby so that they suffice.
template <class F>
using EdgeValue = std::conditional_t<lanes<F> == 1, std::int64_t, Int<F>>;

/// An edge function (Pineda 1988): e(px, py) = origin + 256 (step_x px + step_y py) at the centre of pixel (px, py),
/// in square subpixels, exact. Positive on the inner side, 0 on the edge.
template <class F>
struct Edge {
    Int<F> step_x;         ///< change a subpixel to the right
    Int<F> step_y;         ///< change a subpixel down
    EdgeValue<F> origin;   ///< value at the centre of pixel (0, 0)
    Mask<F> inclusive;     ///< whether a centre exactly on this edge belongs to the triangle
};

/// The edge from a to b of a triangle that runs counter-clockwise on the picture, so that the inside is to its left.
template <class F>
inline Edge<F> make_edge(const SubpixelVertex<F>& a, const SubpixelVertex<F>& b, FillRule rule) {
    const Int<F> step_x = b.y - a.y;
    const Int<F> step_y = a.x - b.x;
    // Counter-clockwise, left edges go down; bottom edges go right and top edges left, along a row.
    const Mask<F> left = step_x > Int<F>(0);
    const Mask<F> owned = rule == FillRule::bottom_left ? step_y < Int<F>(0) : step_y > Int<F>(0);
    const Mask<F> owned_row = (step_x == Int<F>(0)) & owned;
    using V = EdgeValue<F>;
    return {step_x, step_y, V(0) - (V(step_x) * V(a.x) + V(step_y) * V(a.y)), Mask<F>(left | owned_row)};
}

/// A value that is linear over the window: value(px, py) = (dady py) + ((dadx px) + origin), at pixel centres.
template <class F>
struct Plane {
    F origin, dadx, dady;
};

/// What all planes of one triangle share: the first corner, and two edges divided by the area. From unsnapped positions.
template <class F>
struct PlaneBasis {
    F x0, y0;  ///< window position of corner 0 relative to the centre of pixel (0, 0)
    F dx01, dy01, dx20, dy20;
};

template <class F>
inline PlaneBasis<F> make_plane_basis(const WindowVertex<F>& v0, const WindowVertex<F>& v1, const WindowVertex<F>& v2) {
    const F dx01 = v0.x - v1.x, dy01 = v0.y - v1.y;
    const F dx20 = v2.x - v0.x, dy20 = v2.y - v0.y;
    const F ooa = F(1) / (dx01 * dy20 - dy01 * dx20);
    return {v0.x - F(0.5f), v0.y - F(0.5f), dx01 * ooa, dy01 * ooa, dx20 * ooa, dy20 * ooa};
}

/// The plane through a0, a1, a2 at the three corners.
template <class F>
inline Plane<F> make_plane(const PlaneBasis<F>& b, F a0, F a1, F a2) {
    const F d01 = a0 - a1, d20 = a2 - a0;
    const F dadx = d01 * b.dy20 - d20 * b.dy01;
    const F dady = d20 * b.dx01 - d01 * b.dx20;
    return {a0 - (dadx * b.x0 + dady * b.y0), dadx, dady};
}

/// A plane along one column of pixels: what value_at has left to do for each row.
template <class F>
struct Column {
    F start, dady;
};
template <class F>
inline Column<F> column_at(const Plane<F>& p, F px) {
    return {(p.dadx * px) + p.origin, p.dady};
}
template <class F>
inline F value_at(const Column<F>& c, F py) {
    return (c.dady * py) + c.start;
}

/// The value of a plane at the centre of pixel (px, py), given as floats. A closed form: no value depends on where a
/// loop began, so any split into tiles, lanes and threads gives the same bits.
template <class F>
inline F value_at(const Plane<F>& p, F px, F py) {
    return value_at(column_at(p, px), py);
}

/// The plane of a triangle's depth, and what is added after it.
template <class F>
struct DepthPlane : Plane<F> {
    F offset;
};
template <class F>
inline F value_at(const DepthPlane<F>& p, F px, F py) {
    return value_at(static_cast<const Plane<F>&>(p), px, py) + p.offset;
}

/// How much a triangle's depth is moved. For float depths the smallest step is that of the largest corner's exponent.
template <class F>
inline F depth_offset(const DepthOffset& offset, DepthFormat format, const WindowVertex<F>& v0,
                      const WindowVertex<F>& v1, const WindowVertex<F>& v2) {
    const F dx01 = v0.x - v1.x, dy01 = v0.y - v1.y, dz01 = v0.z - v1.z;
    const F dx20 = v2.x - v0.x, dy20 = v2.y - v0.y, dz20 = v2.z - v0.z;
    const F ooa = F(1) / (dx01 * dy20 - dy01 * dx20);
    const F slope_x = abs((dz20 * dy01 - dy20 * dz01) * ooa), slope_y = abs((dx20 * dz01 - dz20 * dx01) * ooa);
    const F slope = select(slope_x <= slope_y, slope_y, slope_x) * F(offset.factor);
    // Mesa's smallest step is two of the 2^24 - 1.
    if (format == DepthFormat::unorm24) return F(float(double(offset.units) * (2.0 / 16777215.0))) + slope;
    const Int<F> largest = as_int(max(max(abs(v0.z), abs(v1.z)), abs(v2.z)));
    const Int<F> exponent = (largest & Int<F>(0x7f800000)) - Int<F>(23 << 23);
    return as_float(select(exponent > Int<F>(0), exponent, Int<F>(0))) * F(offset.units) + slope;
}

/// The pixels whose centres lie in the triangle's bounding box; empty when min > max.
struct PixelBox {
    int min_x, min_y, max_x, max_y;  ///< both ends included

    bool empty() const { return min_x > max_x || min_y > max_y; }
    bool contains(int x, int y) const { return x >= min_x && x <= max_x && y >= min_y && y <= max_y; }
};

inline PixelBox intersection(const PixelBox& a, const PixelBox& b) {
    return {std::max(a.min_x, b.min_x), std::max(a.min_y, b.min_y), std::min(a.max_x, b.max_x),
            std::min(a.max_y, b.max_y)};
}

/// The pixels that a draw may change.
inline PixelBox drawable_pixels(const State& state, int width, int height) {
    const PixelBox all{0, 0, width - 1, height - 1};
    if (!state.scissor) return all;
    // The sum of two ints may not fit one.
    const auto last = [](int start, int size) {
        return int(std::min<std::int64_t>(std::int64_t(start) + size, 1 << 30)) - 1;
    };
    const Scissor& s = *state.scissor;
    return intersection(all, {s.x, s.y, last(s.x, s.width), last(s.y, s.height)});
}

inline PixelBox bounding_pixels(const std::array<SubpixelVertex<float>, 3>& v, int width, int height) {
    const auto [min_x, max_x] = std::minmax({v[0].x, v[1].x, v[2].x});
    const auto [min_y, max_y] = std::minmax({v[0].y, v[1].y, v[2].y});
    return {std::max((min_x + subpixels - 1) >> subpixel_bits, 0),
            std::max((min_y + subpixels - 1) >> subpixel_bits, 0), std::min(max_x >> subpixel_bits, width - 1),
            std::min(max_y >> subpixel_bits, height - 1)};
}

/// The corners of a triangle in the order in which it is set up: 0 and 1 are exchanged when it runs clockwise.
inline std::array<int, 3> setup_order(std::int64_t area) {
    return area < 0 ? std::array{1, 0, 2} : std::array{0, 1, 2};
}

/// Everything about a triangle that its pixels share, but for the varyings' planes (interpolate.h).
struct TriangleSetup {
    std::array<int, 3> order;   ///< which corner is 0, 1, 2 below
    std::array<Edge<float>, 3> edges;  ///< from 0 to 1, 1 to 2, 2 to 0
    PlaneBasis<float> basis;
    DepthPlane<float> depth;
    PixelBox box;
};

inline TriangleSetup make_setup(const std::array<WindowVertex<float>, 3>& window,
                                const std::array<SubpixelVertex<float>, 3>& subpixel, std::int64_t area, FillRule rule,
                                int width, int height, const DepthOffset& offset = {},
                                DepthFormat format = DepthFormat::unorm24) {
    TriangleSetup s;
    s.order = setup_order(area);
    const auto corner = [&](int i) { return std::size_t(s.order[std::size_t(i)]); };
    for (int i = 0; i < 3; ++i)
        s.edges[std::size_t(i)] = make_edge(subpixel[corner(i)], subpixel[corner((i + 1) % 3)], rule);
    const auto &v0 = window[corner(0)], &v1 = window[corner(1)], &v2 = window[corner(2)];
    s.basis = make_plane_basis(v0, v1, v2);
    s.depth = {make_plane(s.basis, v0.z, v1.z, v2.z), offset.is_on() ? depth_offset(offset, format, v0, v1, v2) : 0.0f};
    s.box = bounding_pixels(subpixel, width, height);
    return s;
}

}  // namespace raster
