// columns.h: the planes of one triangle, or of one a lane, along a column of pixels, for one row or for two at once.
#pragma once

#include <raster/stages/interpolate.h>
#include <raster/tiles/planes.h>

namespace raster::tiles {

/// Two packs as one of twice the lanes, and one pack twice.
template <template <int> class Pack>
inline Pack<2 * native_lanes> pair(Pack<native_lanes> a, Pack<native_lanes> b) {
    using V = decltype(Pack<2 * native_lanes>::v);
    return Pack<2 * native_lanes>(V{a.v, b.v});
}
template <template <int> class Pack>
inline Pack<2 * native_lanes> twice(Pack<native_lanes> a) { return pair(a, a); }

/// Triangles' planes along a column of pixels: of one triangle, or of one a lane.
template <HasFragment S, class F>
struct ShadingColumn {
    VaryingColumns<S, F> varyings;
    Column<F> depth;
    F depth_offset, px;
    Int<F> triangle;
    Mask<F> front_facing;

    ShadingColumn() = default;

    ShadingColumn(const ShadingPlanes<S>& p, F px)
        : varyings(columns_at<S, F>(from_numbers<S, float>(p.varyings), px)),
          depth(column_at(Plane<F>{p.depth[0], p.depth[1], p.depth[2]}, px)),
          depth_offset(p.depth[3]),
          px(px),
          triangle(p.triangle),
          front_facing(p.front_facing != 0) {}

    /// Lane i is of the triangle planes[which[i]].
    ShadingColumn(const ShadingPlanes<S>* planes, Int<F> which, F px) : px(px) {
        constexpr std::ptrdiff_t stride = sizeof(ShadingPlanes<S>) / sizeof(float);
        PlaneNumbers<S, F> numbers;
        // Neighbours in a row are often of one triangle.
        if (const std::int32_t first = lane(which, 0); all(which == Int<F>(first))) {
            for (std::size_t k = 0; k < numbers.size(); ++k) numbers[k] = F(planes[first].varyings[k]);
        } else {
            for (std::size_t k = 0; k < numbers.size(); k += 4)
                gather4(planes->varyings.data() + k, which, numbers[k], numbers[k + 1], numbers[k + 2], numbers[k + 3],
                        stride);
        }
        varyings = columns_at<S, F>(from_numbers<S, F>(numbers), px);
        if constexpr (HasPlacedFragment<S>) {
            Plane<F> plane;
            gather4(planes->depth, which, plane.origin, plane.dadx, plane.dady, depth_offset, stride);
            F triangle_bits, front_bits, unused0, unused1;
            gather4(reinterpret_cast<const float*>(&planes->triangle), which, triangle_bits, front_bits, unused0,
                    unused1, stride);
            depth = column_at(plane, px);
            triangle = as_int(triangle_bits);
            front_facing = as_int(front_bits) != Int<F>(0);
        } else {
            depth = {F(0), F(0)}, depth_offset = F(0), triangle = Int<F>(0), front_facing = Mask<F>(false);
        }
    }
};

/// A column for two rows.
template <HasFragment S>
inline ShadingColumn<S, FloatPair> twice(const ShadingColumn<S, FloatN>& one) {
    ShadingColumn<S, FloatPair> r;
    const auto widen = [](const Column<FloatN>& c) { return Column<FloatPair>{twice(c.start), twice(c.dady)}; };
    for (std::size_t i = 0; i < r.varyings.columns.size(); ++i)
        r.varyings.columns[i] = widen(one.varyings.columns[i]);
    r.varyings.oow = widen(one.varyings.oow);
    r.depth = widen(one.depth), r.depth_offset = twice(one.depth_offset), r.px = twice(one.px);
    r.triangle = twice(one.triangle), r.front_facing = twice(one.front_facing);
    return r;
}

/// Lane i is of `a` where the mask is set, else of `b`.
template <HasFragment S>
inline ShadingColumn<S, FloatPair> choose(Mask<FloatPair> mask, const ShadingColumn<S, FloatPair>& a,
                                          const ShadingColumn<S, FloatPair>& b) {
    ShadingColumn<S, FloatPair> r;
    const auto either = [&](const Column<FloatPair>& x, const Column<FloatPair>& y) {
        return Column<FloatPair>{select(mask, x.start, y.start), select(mask, x.dady, y.dady)};
    };
    for (std::size_t i = 0; i < r.varyings.columns.size(); ++i)
        r.varyings.columns[i] = either(a.varyings.columns[i], b.varyings.columns[i]);
    r.varyings.oow = either(a.varyings.oow, b.varyings.oow);
    r.depth = either(a.depth, b.depth), r.depth_offset = select(mask, a.depth_offset, b.depth_offset), r.px = a.px;
    r.triangle = select(mask, a.triangle, b.triangle);
    r.front_facing = (mask & a.front_facing) | ((!mask) & b.front_facing);
    return r;
}

}  // namespace raster::tiles
