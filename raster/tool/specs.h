// specs.h: lights and materials as one word on the command line: point:pos=0,2,1:intensity=0.8.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <raster/result.h>
#include <raster/scene/render.h>

namespace raster::tool {

/// A reflectance model by its name.
Result<AnyReflectance> parse_reflectance(std::string_view text);

/// What --light takes. `head` can be several lights.
Result<std::vector<Light>> parse_light(std::string_view text);
extern const char* const light_help;

/// What --material changes; the rest stays as the model's file has it.
struct MaterialChange {
    std::optional<Material> substance;  ///< what all is changed to first
    std::optional<std::string> reflectance;
    std::optional<std::shared_ptr<const MeasuredTable>> brdf;
    std::optional<glm::vec3> color, ambient, diffuse, specular, emission;
    std::optional<float> shininess, alpha, roughness, metallic, anisotropy, anisotropy_rotation, index_of_refraction;
    std::optional<float> sheen, clearcoat, clearcoat_roughness;

    void apply_to(Material& material) const;
};
/// Errors are of kind usage, or those of the table that `brdf` names.
Result<MaterialChange> parse_material(std::string_view text);
/// The same where `find` makes the path to open out of the name of a table's file. `own_names` are told with the
/// substances where a name is neither.
using FindFile = std::function<Result<std::string>(const std::string& name)>;
Result<MaterialChange> parse_material_finding(std::string_view text, const FindFile& find,
                                              const std::vector<std::string>& own_names);
std::string material_help();

}  // namespace raster::tool
