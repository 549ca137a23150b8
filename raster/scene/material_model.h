// material_model.h: what a material makes of a reflectance model: the colour of its highlights, layers on top.
#pragma once

#include <raster/shading/materials.h>
#include <raster/shading/models.h>

namespace raster {

/// A metal's colour comes of Fresnel's equations; under a model that knows none it is the colour itself.
inline glm::vec3 specular_color(const Material& material, const AnyReflectance& reflectance) {
    const auto has_fresnel = []<class M>(const M&) { return requires(const M model) { model.fresnel; }; };
    const bool is_metal = material.extinction != glm::vec3(0.0f);
    return is_metal && !std::visit(has_fresnel, reflectance) ? metal_ambient(material) : material.specular;
}

/// A model as it is drawn, and the ks that multiplies its specular part.
struct MaterialModel {
    AnyReflectance reflectance;
    glm::vec3 specular;
};

/// A model that has the material's parameters, with its ks, and under the material's sheen and clear coat if there are
/// any. A texture of Ks then colours the layers too.
inline MaterialModel finish(const Material& material, const AnyReflectance& base) {
    const glm::vec3 ks = material.illumination >= 2 ? specular_color(material, base) : glm::vec3(0.0f);
    if (!(material.sheen > 0.0f) && !(material.clearcoat > 0.0f)) return {base, ks};
    const float roughness = material.clearcoat_roughness;
    Layered layered;
    layered.base = std::make_shared<const RuntimeModel>(RuntimeModel{base});
    layered.base_specular = ks;
    layered.sheen.strength = min(material.sheen, 1.0f);
    layered.coat = {min(material.clearcoat, 1.0f), clamp(roughness * roughness, layered.coat.m, 1.0f)};
    return {layered, glm::vec3(1.0f)};
}

}  // namespace raster
