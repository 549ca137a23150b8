// physics.cpp: raster_physics prints the tables of docs/physics.md: energy, reciprocity, Fresnel's limits, tables' errors.
#include <algorithm>
#include <cmath>
#include <cstdio>

#include <raster/scene/material_model.h>
#include <raster/shading/materials.h>
#include <raster/shading/measured_bake.h>

namespace {

using namespace raster;

constexpr double pi = 3.14159265358979;
const Fresnel mirror{glm::vec3(1e-4f), glm::vec3(1e4f)};  // reflects all at every angle

glm::vec3 direction(double cosine, double azimuth) {
    const auto [s, c] = sin_cos_degrees(azimuth * 180 / pi);
    const double sine = std::sqrt(std::max(0.0, 1 - cosine * cosine));
    return glm::normalize(glm::vec3(float(sine * c), float(sine * s), float(cosine)));
}
glm::vec3 at_degrees(double degrees) { return direction(sin_cos_degrees(degrees).cos, 0.3); }

double value_of(const RuntimeModel& model, const glm::vec3& l, const glm::vec3& v, float kd, float ks) {
    const auto frame = make_frame(glm::vec3(0, 0, 1), v, glm::vec3(1, 0, 0));
    const auto value = model.evaluate(frame, vec<3, float>(l));
    return double(value.diffuse.y * kd + value.specular.y * ks);
}

/// The mean of f over the hemisphere, on a grid that is uniform in the solid angle.
template <class F>
double hemisphere_mean(const F& f) {
    constexpr int rings = 400, sectors = 400;
    double sum = 0;
    for (int i = 0; i < rings; ++i)
        for (int j = 0; j < sectors; ++j) sum += f(direction((i + 0.5) / rings, 2 * pi * (j + 0.5) / sectors));
    return sum / rings / sectors;
}

/// What a viewer sees in the white furnace: light of 1 from everywhere.
double furnace(const AnyReflectance& model, double degrees, float kd, float ks) {
    const glm::vec3 v = at_degrees(degrees);
    return 2 * hemisphere_mean([&](const glm::vec3& l) { return value_of({model}, l, v, kd, ks); });
}
/// The part of the light that comes from one direction and goes away again.
double leaving(const AnyReflectance& model, double degrees, float kd, float ks) {
    const glm::vec3 l = at_degrees(degrees);
    return 2 / double(l.z) *
           hemisphere_mean([&](const glm::vec3& v) { return value_of({model}, l, v, kd, ks) * double(v.z); });
}

/// The largest difference of f(l, v) and f(v, l) over the larger of them, both directions 3 degrees above the surface
/// and more, of what is brighter than 0.01 / pi.
double reciprocity_error(const AnyReflectance& model) {
    double worst = 0;
    for (double a = 0; a < 87; a += 3.1) {
        for (double b = 0; b < 87; b += 2.9) {
            for (double azimuth = 0; azimuth < 6.28; azimuth += 0.37) {
                const glm::vec3 l = direction(sin_cos_degrees(a).cos, 0.3);
                const glm::vec3 v = direction(sin_cos_degrees(b).cos, 0.3 + azimuth);
                const double there = value_of({model}, l, v, 1, 1) / double(l.z);
                const double back = value_of({model}, v, l, 1, 1) / double(v.z);
                worst = std::max(worst, std::abs(there - back) / std::max({there, back, 0.01}));
            }
        }
    }
    return worst;
}

/// With facets that absorb nothing, where a model has any.
AnyReflectance white(AnyReflectance model) {
    std::visit([](auto& m) { if constexpr (requires { m.fresnel; }) m.fresnel = mirror; }, model);
    if (auto* he = std::get_if<HeTorrance>(&model)) he->source_degrees = 6;  // so that the grid sees its mirror
    if (auto* below = std::get_if<Subsurface>(&model)) below->absorption = glm::vec3(0);
    return model;
}

void print_furnace() {
    std::printf("| model | part | 0 | 40 | 60 | 75 | 85 | reciprocity |\n|---|---|---|---|---|---|---|---|\n");
    for (const std::string_view name : reflectance_names()) {
        const AnyReflectance model = white(*find_reflectance(name));
        const bool diffuse = name == "lambert" || name == "oren-nayar" || name == "subsurface";
        std::printf("| %s | %s |", name.data(), diffuse ? "diffuse" : "specular");
        for (const double angle : {0.0, 40.0, 60.0, 75.0, 85.0})
            std::printf(" %.3f |", furnace(model, angle, diffuse ? 1.0f : 0.0f, diffuse ? 0.0f : 1.0f));
        std::printf(" %.1e |\n", reciprocity_error(*find_reflectance(name)));
    }
    const auto on_white = [](const char* name, const Material& layers) {
        const AnyReflectance model = finish(layers, Lambert{}).reflectance;
        std::printf("| %s on lambert | both |", name);
        for (const double angle : {0.0, 40.0, 60.0, 75.0, 85.0}) std::printf(" %.3f |", furnace(model, angle, 1, 1));
        std::printf(" %.1e |\n", reciprocity_error(model));
    };
    Material varnish, fibres;
    varnish.clearcoat = fibres.sheen = 1;
    varnish.clearcoat_roughness = 0.5f;
    on_white("clear coat", varnish);
    on_white("sheen", fibres);
}

void print_empirical() {
    std::printf("\n| model | n | seen from 0 | 60 | 85 | lit from 0 | 60 | 80 | 85 | 88 |\n"
                "|---|---|---|---|---|---|---|---|---|---|\n");
    const auto row = [](const char* name, float n, const AnyReflectance& model) {
        std::printf("| %s | %g |", name, double(n));
        for (const double angle : {0.0, 60.0, 85.0}) std::printf(" %.3f |", furnace(model, angle, 0, 1));
        for (const double angle : {0.0, 60.0, 80.0, 85.0, 88.0}) std::printf(" %.3f |", leaving(model, angle, 0, 1));
        std::printf("\n");
    };
    for (const float n : {1.0f, 5.0f, 32.0f, 200.0f}) row("phong", n, Phong{n});
    for (const float n : {1.0f, 5.0f, 32.0f, 200.0f}) row("blinn-phong", n, BlinnPhong{n});
}

void print_fresnel() {
    const auto glass = [](double degrees) {
        return double(fresnel_dielectric(float(sin_cos_degrees(degrees).cos), 1.5f));
    };
    const auto inside = [](double degrees) {
        return double(fresnel_dielectric(float(sin_cos_degrees(degrees).cos), 1 / 1.5f));
    };
    std::printf("\n| boundary | angle | reflected |\n|---|---|---|\n");
    std::printf("| air to glass, n = 1.5 | 0 | %.5f |\n", glass(0));
    std::printf("| air to glass | 56.31 (Brewster's) | %.5f |\n", glass(56.30993));
    std::printf("| air to glass | 89.9 | %.5f |\n| air to glass | 90 | %.5f |\n", glass(89.9), glass(90));
    std::printf("| glass to air | 41 | %.5f |\n| glass to air | 41.82 and more | %.5f |\n", inside(41), inside(41.82));
    for (const char* name : {"gold", "silver", "copper", "aluminium", "iron"}) {
        const Fresnel f = Fresnel{}.with_material(*find_material(name));
        const auto at = [&](double degrees) { return f(float(sin_cos_degrees(degrees).cos)); };
        const auto normal = at(0), grazing = at(89.9);
        std::printf("| air to %s | 0 | %.3f, %.3f, %.3f |\n| air to %s | 89.9 | %.3f, %.3f, %.3f |\n", name,
                    double(normal.x), double(normal.y), double(normal.z), name, double(grazing.x), double(grazing.y),
                    double(grazing.z));
    }
}

/// Between the middles of cells too: directions that the table does not hold.
void print_tables() {
    std::printf("\n| baked | root mean square | largest |\n|---|---|---|\n");
    for (const char* name : {"paper", "clay", "velvet", "plastic", "rubber", "iron", "gold", "milk"}) {
        const Material material = *find_material(name);
        const auto model = RuntimeModel{*find_reflectance(material.reflectance)}.with_material(material);
        const auto back =
            decode_measured(encode_measured(bake_measured(model.model, material.diffuse, material.specular)));
        const Measured table{std::make_shared<const MeasuredTable>(*back)};
        double sum = 0, all = 0, worst = 0, brightest = 0;
        for (double a = 1.3; a < 80; a += 2.37) {
            for (double b = 0.7; b < 80; b += 2.71) {
                for (double azimuth = 0.01; azimuth < 6.28; azimuth += 0.31) {
                    const glm::vec3 l = direction(sin_cos_degrees(a).cos, 0),
                                    v = direction(sin_cos_degrees(b).cos, azimuth);
                    const double exact = value_of(model, l, v, material.diffuse.y, material.specular.y);
                    const double read = value_of({table}, l, v, 1, 0);
                    sum += (exact - read) * (exact - read), all += exact * exact;
                    worst = std::max(worst, std::abs(exact - read));
                    brightest = std::max(brightest, exact);
                }
            }
        }
        std::printf("| %s | %.2f %% | %.2f %% |\n", name, 100 * std::sqrt(sum / all), 100 * worst / brightest);
    }
}

}  // namespace

int main() {
    print_furnace();
    print_empirical();
    print_fresnel();
    print_tables();
    return 0;
}
