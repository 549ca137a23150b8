// curves.cpp: what the reflectance models give, as tables for a plotting program.
//
//   raster_curves fresnel
//     angle in degrees; glass n = 1.5 from outside and from inside; red, green and blue of gold, copper and aluminium
//   raster_curves lobes ANGLE MATERIAL...
//     light at that angle from the normal: the viewer's angle; of each material the red channel of diffuse + specular
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string_view>
#include <vector>

#include <raster/shading/fresnel.h>
#include <raster/shading/materials.h>
#include <raster/shading/measured_table.h>
#include <raster/shading/models.h>

namespace {

using namespace raster;

glm::vec3 direction(double degrees) {
    const auto [s, c] = sin_cos_degrees(degrees);
    return {float(s), float(c), 0};
}

int print_fresnel() {
    const std::optional<Material> metals[] = {find_material("gold"), find_material("copper"),
                                              find_material("aluminium")};
    for (int angle = 0; angle <= 90; ++angle) {
        const float c = float(sin_cos_degrees(angle).cos);
        const float outside = fresnel_dielectric(c, 1.5f), inside = fresnel_dielectric(c, 1 / 1.5f);
        std::printf("%d %.6f %.6f", angle, double(outside), double(inside));
        for (const auto& metal : metals) {
            const vec<3, float> f = Fresnel{}.with_material(*metal)(c);
            std::printf(" %.6f %.6f %.6f", double(f.x), double(f.y), double(f.z));
        }
        std::printf("\n");
    }
    return 0;
}

/// NAME:KEY=VALUE:... of a substance or of a reflectance model, which then is all highlight; or brdf=FILE.
bool read_material(std::string_view text, Material& material) {
    const std::size_t colon = text.find(':');
    const std::string_view name = text.substr(0, colon);
    if (name.starts_with("brdf=")) {
        const auto table = read_measured(std::string(name.substr(5)));
        if (!table) return false;
        material.measured = std::make_shared<const MeasuredTable>(*table);
        material.reflectance = Measured::name;
        material.diffuse = glm::vec3(1.0f);
        return true;
    }
    if (const auto substance = find_material(name)) {
        material = *substance;
    } else {
        material.reflectance = name;
        material.diffuse = glm::vec3(0.0f);
        material.specular = glm::vec3(1.0f);
    }
    for (std::size_t at = colon; at != text.npos; at = text.find(':', at + 1)) {
        const std::string_view pair = text.substr(at + 1, text.find(':', at + 1) - at - 1);
        const std::size_t equals = pair.find('=');
        if (equals == pair.npos) return false;
        const std::string_view key = pair.substr(0, equals);
        const float value = float(std::atof(std::string(pair.substr(equals + 1)).c_str()));  // of colours, red
        if (key == "roughness") material.roughness = value;
        if (key == "shininess") material.shininess = value;
        if (key == "diffuse") material.diffuse = glm::vec3(value);
        if (key == "specular") material.specular = glm::vec3(value);
    }
    return bool(find_reflectance(material.reflectance));
}

int print_lobes(double light_angle, int count, char** names) {
    std::vector<std::pair<RuntimeModel, Material>> models;
    for (int i = 0; i < count; ++i) {
        Material material;
        if (!read_material(names[i], material)) {
            std::fprintf(stderr, "no material %s\n", names[i]);
            return 2;
        }
        models.emplace_back(RuntimeModel{*find_reflectance(material.reflectance)}.with_material(material), material);
    }
    for (int angle = -90; angle <= 90; ++angle) {
        std::printf("%d", angle);
        const glm::vec3 n(0, 1, 0);
        const Frame<float> frame = make_frame<float>(n, direction(angle), glm::vec3(0, 0, 1));
        for (const auto& [model, material] : models) {
            const Reflectance<float> r = model.evaluate(frame, vec<3, float>(direction(-light_angle)));
            std::printf(" %.6f", double(r.diffuse.x * material.diffuse.x + r.specular.x * material.specular.x));
        }
        std::printf("\n");
    }
    return 0;
}

}  // namespace

int main(int argc, char** argv) {
    const std::string_view what = argc > 1 ? argv[1] : "";
    if (what == "fresnel") return print_fresnel();
    if (what == "lobes" && argc > 3) return print_lobes(std::atof(argv[2]), argc - 3, argv + 3);
    std::fputs("usage: raster_curves fresnel | raster_curves lobes ANGLE MATERIAL...\n", stderr);
    return 2;
}
