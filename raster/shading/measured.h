// measured.h: a measured surface: a table of its BRDF, interpolated.
#pragma once

#include <memory>

#include <raster/math.h>
#include <raster/shading/measured_table.h>
#include <raster/shading/reflectance.h>

namespace raster {

/// The directions l and v as Rusinkiewicz has them (A New Change of Variables for Efficient BRDF Representation, 1998):
/// the half vector's angle from the normal, and l's angles around the half vector. In radians.
template <class F>
struct HalfDifference {
    F theta_h, theta_d;  ///< 0 to pi/2
    F phi_d;             ///< 0 to pi; that of l and that of v differ by pi and mean the same
};

template <class F>
inline HalfDifference<F> half_difference(const Frame<F>& frame, const vec<3, F>& l) {
    vec<3, F> h = normalize_or_zero(l + frame.v);
    const F cos_h = glm::dot(frame.n, h);
    vec<3, F> aside = h - frame.n * cos_h;
    const F sin_h = sqrt(glm::dot(aside, aside));
    vec<3, F> tangent = aside * (F(1) / max(sin_h, F(1e-20f)));
    const F x = glm::dot(l, tangent) * cos_h - glm::dot(l, frame.n) * sin_h;
    const F y = glm::dot(l, glm::cross(frame.n, tangent));
    vec<3, F> off = glm::cross(l, h);
    const F phi = raster::atan2(y, x);
    return {raster::atan2(sin_h, cos_h), raster::atan2(sqrt(glm::dot(off, off)), glm::dot(l, h)),
            select(phi < F(0), phi + 3.14159265f, phi)};
}

/// f from the table; all of it is Reflectance's diffuse part, so that kd = 1 shows it as measured. Without a table it is
/// black.
struct Measured {
    static constexpr std::string_view name = "measured";
    static constexpr bool needs_data = true;
    static constexpr bool has_own_color = true;

    std::shared_ptr<const MeasuredTable> table;

    Measured with_material(const Material& material) const {
        return material.measured ? Measured{material.measured} : *this;
    }

    template <class F>
    Reflectance<F> evaluate(const Frame<F>& frame, const vec<3, F>& l) const {
        if (!table || table->empty()) return {grey(F(0)), grey(F(0))};
        HalfDifference<F> at = half_difference(frame, l);
        constexpr float per_quarter = 0.636619772f, per_half = 0.318309886f;
        const MeasuredSize& n = table->size;
        Cells<F> h = cells(sqrt(clamp(at.theta_h * per_quarter, F(0), F(1))), n.theta_h, false);
        Cells<F> d = cells(at.theta_d * per_quarter, n.theta_d, false);
        Cells<F> p = cells(at.phi_d * per_half, n.phi_d, true);
        F weight(0), r(0), g(0), b(0);
        for (int corner = 0; corner < 8; ++corner) {
            const int i = corner >> 2, j = corner >> 1 & 1, k = corner & 1;
            const F w = h.weight[i] * d.weight[j] * p.weight[k];
            const Int<F> cell = (h.cell[i] * Int<F>(n.theta_d) + d.cell[j]) * Int<F>(n.phi_d) + p.cell[k];
            F has, x, y, z;
            gather4(table->samples.data(), cell, has, x, y, z);
            weight += w * has;
            r += w * x;
            g += w * y;
            b += w * z;
        }
        const F n_l = glm::dot(frame.n, l);
        const Mask<F> above = (n_l > F(0)) & (glm::dot(frame.n, frame.v) > F(0));
        // Cells without a value have no weight; where none has one the sums are 0.
        const F scale = select(above, F(3.14159265f) * n_l / max(weight, F(1e-6f)), F(0));
        return {{r * scale, g * scale, b * scale}, grey(F(0))};
    }

private:
    /// The two cells whose middles are around a place, and their weights.
    template <class F>
    struct Cells {
        Int<F> cell[2];
        F weight[2];
    };
    /// `place` from 0 to 1 over all n cells; around = after the last cell comes the first.
    template <class F>
    static Cells<F> cells(F place, int n, bool around) {
        const F x = clamp(place, F(0), F(1)) * float(n) - 0.5f;
        const Int<F> low = floor_to_int(x);
        const Int<F> first(0), last(n - 1), high = low + Int<F>(1);
        Cells<F> r;
        r.cell[0] = select(low < first, around ? last : first, low);
        r.cell[1] = select(high > last, around ? first : last, high);
        r.weight[1] = x - to_float(low);
        r.weight[0] = F(1) - r.weight[1];
        return r;
    }
};

}  // namespace raster
