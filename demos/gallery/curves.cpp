// curves.cpp: what the reflectance models give, as tables for a plotting program.
//
//   raster_curves fresnel
//     angle in degrees; glass n = 1.5 from outside and from inside; red, green and blue of gold, copper and aluminium
//   raster_curves lobes ANGLE NAME...
//     light at that angle from the normal: the viewer's angle; of each material the red channel of diffuse + specular
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string_view>
#include <vector>

#include <raster/shading/fresnel.h>
#include <raster/shading/materials.h>
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

/// NAME or NAME:ROUGHNESS of a substance; phong and blinn-phong with an exponent.
int print_lobes(double light_angle, int count, char** names) {
    std::vector<std::pair<RuntimeModel, Material>> models;
    for (int i = 0; i < count; ++i) {
        const std::string_view text = names[i];
        const std::size_t colon = text.find(':');
        const std::string_view name = text.substr(0, colon);
        const float number = colon == text.npos ? 0.0f : float(std::atof(names[i] + colon + 1));
        Material material = find_material(name).value_or(Material{});
        if (material.reflectance.empty()) {
            material.reflectance = name;
            material.shininess = number;
            material.diffuse = glm::vec3(0.0f);
            material.specular = glm::vec3(1.0f);
        } else if (number > 0) {
            material.roughness = number;
        }
        const auto model = find_reflectance(material.reflectance);
        if (!model) {
            std::fprintf(stderr, "no material %s\n", names[i]);
            return 2;
        }
        models.emplace_back(RuntimeModel{*model}.with_material(material), material);
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
    std::fputs("usage: raster_curves fresnel | raster_curves lobes ANGLE NAME[:NUMBER]...\n", stderr);
    return 2;
}
