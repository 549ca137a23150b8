// specular_color.h: the colour of a material's highlights under a reflectance model.
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

}  // namespace raster
