// opengl_models.h: the reflectance models in GLSL, written from the papers' formulas alone: what ours are held against.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <raster/shading/models.h>

namespace raster::tool {

/// A model's function `void reflect_light(vec3 n, vec3 v, vec3 t, vec3 b, vec3 l, out vec3 diffuse, out vec3 specular)`,
/// for n l > 0, with what it calls; and its parameters as uniforms.
struct GlslModel {
    std::string source;
    std::vector<std::pair<std::string, std::variant<float, glm::vec3>>> uniforms;
};

/// Nothing for a table of measured data, which GLSL does not have in a page.
std::optional<GlslModel> reflectance_in_glsl(const AnyReflectance& reflectance);

}  // namespace raster::tool
