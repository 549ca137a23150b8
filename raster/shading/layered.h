// layered.h: any reflectance model under a sheen and a clear coat.
#pragma once

#include <memory>

#include <raster/shading/clearcoat.h>
#include <raster/shading/sheen.h>

namespace raster {

struct RuntimeModel;

/// base.evaluate(frame, l), for a type that is not complete here; in models.h.
template <class F>
Reflectance<F> evaluate_base(const RuntimeModel& base, const Frame<F>& frame, const vec<3, F>& l);

/// The varnish is outside, the fibres below it, the base at the bottom: each layer reflects, and what is below it gets
/// the rest. Layers are white, whatever the base's ks is: the model has that in itself, and is drawn with a ks of 1. A
/// material without layers is its base alone, and pays nothing.
struct Layered {
    static constexpr std::string_view name = "layered";
    static constexpr bool needs_data = true;

    std::shared_ptr<const RuntimeModel> base;  ///< with its parameters; black without one
    glm::vec3 base_specular{1.0f};             ///< ks of the base
    Sheen sheen;
    Clearcoat coat;

    bool reads_tangents() const;
    /// The layers are set where the base is.
    Layered with_material(const Material&) const { return *this; }

    template <class F>
    Reflectance<F> evaluate(const Frame<F>& frame, const vec<3, F>& l) const {
        if (!base) return {grey(F(0)), grey(F(0))};
        Reflectance<F> r = evaluate_base(*base, frame, l);
        HalfVector<F> h = make_half_vector(frame, l);
        r.specular = r.specular * base_specular;
        if (sheen.strength > 0.0f) add(sheen, h, r);
        if (coat.strength > 0.0f) add(coat, h, r);
        return r;
    }

private:
    template <class Layer, class F>
    static void add(const Layer& layer, const HalfVector<F>& h, Reflectance<F>& r) {
        const F passing = layer.passing(h);
        r.diffuse = r.diffuse * passing;
        r.specular = r.specular * passing + grey(layer.reflection(h));
    }
};

}  // namespace raster
