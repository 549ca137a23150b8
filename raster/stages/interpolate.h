// interpolate.h: stage 9, the value of each varying at a pixel, perspective-correct (Blinn 1992).
#pragma once

#include <raster/shader.h>
#include <raster/stages/setup.h>

namespace raster {

/// The planes of one triangle's varyings. A smooth varying is divided by w, then linear in the window.
template <Shader S, class F>
struct VaryingPlanes {
    Plane<F> oow;
    std::array<Plane<F>, std::size_t(varying_count<S>)> planes;
};

/// a[0..2] are the varyings of the corners in setup order; the flat ones come from the provoking vertex, which is the
/// last in any order.
template <Shader S, class F>
inline VaryingPlanes<S, F> make_varying_planes(const PlaneBasis<F>& basis,
                                               const std::array<const VaryingArray<S, F>*, 3>& a,
                                               const std::array<F, 3>& oow) {
    VaryingPlanes<S, F> r;
    r.oow = make_plane(basis, oow[0], oow[1], oow[2]);
    for (std::size_t i = 0; i < std::size_t(varying_count<S>); ++i) {
        const F a0 = (*a[0])[i], a1 = (*a[1])[i], a2 = (*a[2])[i];
        switch (interpolation_of<S>(int(i))) {
            case Interpolation::smooth: r.planes[i] = make_plane(basis, a0 * oow[0], a1 * oow[1], a2 * oow[2]); break;
            case Interpolation::noperspective: r.planes[i] = make_plane(basis, a0, a1, a2); break;
            case Interpolation::flat: r.planes[i] = {a2, F(0), F(0)}; break;
        }
    }
    return r;
}

/// The same planes along one column of pixels.
template <Shader S, class F>
struct VaryingColumns {
    std::array<Column<F>, std::size_t(varying_count<S>)> columns;
    Column<F> oow;
};

/// The column at px, of planes of a triangle a lane, or of one triangle for all lanes.
template <Shader S, class F, class P>
inline VaryingColumns<S, F> columns_at(const VaryingPlanes<S, P>& p, F px) {
    const auto widen = [](const Plane<P>& plane) { return Plane<F>{plane.origin, plane.dadx, plane.dady}; };
    VaryingColumns<S, F> r;
    r.oow = column_at(widen(p.oow), px);
    for (std::size_t i = 0; i < std::size_t(varying_count<S>); ++i) {
        // A flat value stays as it is: 0 px + (-0) would be +0.
        const bool flat = interpolation_of<S>(int(i)) == Interpolation::flat;
        r.columns[i] = flat ? Column<F>{F(p.planes[i].origin), F(0)} : column_at(widen(p.planes[i]), px);
    }
    return r;
}

/// The varyings of the column's pixel in row py, 1/w there given.
template <Shader S, class F>
inline VaryingArray<S, F> interpolate(const VaryingColumns<S, F>& p, F py, F oow) {
    VaryingArray<S, F> r;
    const F w = F(1) / oow;
    for (std::size_t i = 0; i < std::size_t(varying_count<S>); ++i) {
        switch (interpolation_of<S>(int(i))) {
            case Interpolation::smooth: r[i] = value_at(p.columns[i], py) * w; break;
            case Interpolation::noperspective: r[i] = value_at(p.columns[i], py); break;
            case Interpolation::flat: r[i] = p.columns[i].start; break;
        }
    }
    return r;
}

/// The varyings at the centre of pixel (px, py).
template <Shader S, class F, class P>
inline VaryingArray<S, F> interpolate(const VaryingPlanes<S, P>& p, F px, F py) {
    const auto columns = columns_at<S, F>(p, px);
    return interpolate<S, F>(columns, py, value_at(columns.oow, py));
}

}  // namespace raster
