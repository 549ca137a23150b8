// lane_triangles.h: what binning and tiles share: one triangle a lane, its box, its winding, and exact coverage when tiny.
#pragma once

#include <array>

#include <raster/stages/coverage.h>
#include <raster/stages/setup.h>

namespace raster::tiles {

/// The bounding box of a triangle in each lane, in subpixels; and of the pixels whose centres it holds.
template <class F>
struct SubpixelBox {
    Int<F> min_x, min_y, max_x, max_y;

    Int<F> first_x() const { return (min_x + Int<F>(subpixels - 1)) >> subpixel_bits; }
    Int<F> first_y() const { return (min_y + Int<F>(subpixels - 1)) >> subpixel_bits; }
    Int<F> last_x() const { return max_x >> subpixel_bits; }
    Int<F> last_y() const { return max_y >> subpixel_bits; }
};

template <class F>
inline SubpixelBox<F> bounding_box(const std::array<SubpixelVertex<F>, 3>& v) {
    return {min(min(v[0].x, v[1].x), v[2].x), min(min(v[0].y, v[1].y), v[2].y), max(max(v[0].x, v[1].x), v[2].x),
            max(max(v[0].y, v[1].y), v[2].y)};
}

/// Twice the area; right where it fits 32 bits, which it does up to 128 pixels of extent, and wrapped elsewhere.
template <class F>
inline Int<F> wrapping_area(const std::array<SubpixelVertex<F>, 3>& v) {
    return (v[0].x - v[1].x) * (v[2].y - v[0].y) - (v[2].x - v[0].x) * (v[0].y - v[1].y);
}

template <class F>
inline void exchange_where(Mask<F> m, F& a, F& b) {
    const F t = select(m, b, a);
    b = select(m, a, b);
    a = t;
}
template <int N>
inline void exchange_where(MaskPack<N> m, IntPack<N>& a, IntPack<N>& b) {
    const IntPack<N> t = select(m, b, a);
    b = select(m, a, b);
    a = t;
}

/// Puts corners in setup order: 0 and 1 are exchanged in the lanes that run clockwise, which are returned.
template <class F>
inline Mask<F> order_corners(std::array<SubpixelVertex<F>, 3>& s) {
    const Mask<F> clockwise = wrapping_area(s) < Int<F>(0);
    exchange_where(clockwise, s[0].x, s[1].x), exchange_where(clockwise, s[0].y, s[1].y);
    return clockwise;
}
template <class F>
inline Mask<F> order_corners(std::array<WindowVertex<F>, 3>& v, std::array<SubpixelVertex<F>, 3>& s) {
    const Mask<F> clockwise = order_corners(s);
    exchange_where<F>(clockwise, v[0].x, v[1].x), exchange_where<F>(clockwise, v[0].y, v[1].y);
    exchange_where<F>(clockwise, v[0].z, v[1].z);
    return clockwise;
}

/// Which of the pixels (x0, y0), (x0 + 1, y0), (x0, y0 + 1), (x0 + 1, y0 + 1) a triangle covers, as bits 0 to 3, for boxes
/// of one or two columns and rows (`columns` and `rows` are 0 or 1). origins are the edges' pixel_origin.
template <class F>
inline Int<F> covered_2x2(const std::array<Edge<F>, 3>& edges, const std::array<Int<F>, 3>& origins, Int<F> x0,
                          Int<F> y0, Int<F> columns, Int<F> rows) {
    // The sign of an OR is negative where any operand is.
    Int<F> outside[4] = {Int<F>(0), Int<F>(0), Int<F>(0), Int<F>(0)};
    for (std::size_t i = 0; i < 3; ++i) {
        const Int<F> e = origins[i] + edges[i].step_x * x0 + edges[i].step_y * y0;
        outside[0] = outside[0] | e;
        outside[1] = outside[1] | (e + edges[i].step_x);
        outside[2] = outside[2] | (e + edges[i].step_y);
        outside[3] = outside[3] | (e + edges[i].step_x + edges[i].step_y);
    }
    Int<F> covered(0);
    for (int k = 0; k < 4; ++k) {
        const Mask<F> in_box = (Int<F>(k & 1) <= columns) & (Int<F>(k >> 1) <= rows);
        covered = covered | select((outside[k] >= Int<F>(0)) & in_box, Int<F>(1 << k), Int<F>(0));
    }
    return covered;
}

}  // namespace raster::tiles
