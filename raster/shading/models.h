// models.h: the list of reflectance models, and one type that can be any of them.
#pragma once

#include <optional>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include <raster/shading/blinn_phong.h>
#include <raster/shading/cook_torrance.h>
#include <raster/shading/he_torrance.h>
#include <raster/shading/lambert.h>
#include <raster/shading/layered.h>
#include <raster/shading/measured.h>
#include <raster/shading/oren_nayar.h>
#include <raster/shading/phong.h>
#include <raster/shading/subsurface.h>
#include <raster/shading/torrance_sparrow.h>
#include <raster/shading/velvet.h>
#include <raster/shading/ward.h>

namespace raster {

/// Any reflectance model, with its parameters. A new model is a file, its include line and an entry here;
/// docs/reflectance.md tells what tests ask for besides.
using AnyReflectance = std::variant<  //
    Lambert,                          //
    Phong,                            //
    BlinnPhong,                       //
    TorranceSparrow,                  //
    CookTorrance,                     //
    OrenNayar,                        //
    HeTorrance,                       //
    Ward,                             //
    Velvet,                           //
    Subsurface,                       //
    Measured,                         //
    Layered>;

/// A reflectance model that is chosen while running: a call an evaluation instead of a specialised shader. It serves
/// where shading is rare (vertices, faces) and where a model is so much work that the call does not count; compiled in
/// models.cpp. Only models that say `specialised` get pixel shaders of their own.
struct RuntimeModel {
    static constexpr std::string_view name = "any";

    AnyReflectance model;

    bool reads_tangents() const {
        return std::visit([](const auto& m) { return raster::reads_tangents(m); }, model);
    }
    RuntimeModel with_material(const Material& material) const {
        return {std::visit([&](const auto& m) { return AnyReflectance(m.with_material(material)); }, model)};
    }
    template <class F>
    RASTER_ONE_CALL Reflectance<F> evaluate(const Frame<F>& frame, const vec<3, F>& l) const {
        return std::visit([&](const auto& m) { return m.evaluate(frame, l); }, model);
    }
};

template <class F>
inline Reflectance<F> evaluate_base(const RuntimeModel& base, const Frame<F>& frame, const vec<3, F>& l) {
    return base.evaluate(frame, l);
}
inline bool Layered::reads_tangents() const { return base && base->reads_tangents(); }

extern template Reflectance<float> RuntimeModel::evaluate(const Frame<float>&, const vec<3, float>&) const;
extern template Reflectance<FloatN> RuntimeModel::evaluate(const Frame<FloatN>&, const vec<3, FloatN>&) const;

namespace detail {
template <class M, class Visit>
inline void for_each_form(const Visit& visit) {
    visit(M::name, M{});
    if constexpr (requires { M::forms(); })
        for (const NamedForm<M>& form : M::forms()) visit(form.name, form.model);
}
/// Calls visit(name, model) for every model and every form of it, in the order of the list.
template <class Visit, std::size_t... I>
inline void for_each_model(const Visit& visit, std::index_sequence<I...>) {
    (for_each_form<std::variant_alternative_t<I, AnyReflectance>>(visit), ...);
}
inline constexpr auto model_indices = std::make_index_sequence<std::variant_size_v<AnyReflectance>>{};
}  // namespace detail

/// The names of the models that one can ask for and of their forms, in the order of the list; without those that need
/// data.
inline std::vector<std::string_view> reflectance_names() {
    std::vector<std::string_view> names;
    const auto add = [&]<class M>(std::string_view name, const M&) {
        if (!needs_data<M>) names.push_back(name);
    };
    detail::for_each_model(add, detail::model_indices);
    return names;
}

/// The model of that name with its default parameters, also of one that needs data; nothing when there is none.
inline std::optional<AnyReflectance> find_reflectance(std::string_view name) {
    std::optional<AnyReflectance> found;
    const auto look = [&](std::string_view form, const auto& model) {
        if (form == name) found = model;
    };
    detail::for_each_model(look, detail::model_indices);
    return found;
}

}  // namespace raster
