// Lit pictures with every reflectance model that GLSL can write in a page: colours within 1/255.
#include <cstdio>

#include <gtest/gtest.h>

#include <raster/scene/material_model.h>
#include <raster/scene/shapes.h>
#include <raster/shading/materials.h>

#include "lit_pair.h"
#include "opengl_models.h"

namespace {

using namespace raster;
using namespace raster::conformance;

constexpr int width = 512, height = 384;

struct ModelScene {
    std::string name;
    Model model;
    RenderOptions options;
};

/// A directional light at the viewer's shoulder and a point light behind the model, which shows what happens at grazing
/// angles.
std::vector<Light> front_and_back() {
    Light front, back;
    front.space = back.space = LightSpace::eye;
    front.direction = {0.5f, -0.6f, -1.0f};
    front.diffuse = glm::vec3(0.6f, 0.5f, 0.4f);
    front.specular = glm::vec3(0.2f);
    front.ambient = glm::vec3(0.05f);
    back.kind = LightKind::point;
    back.position = {-4, 5, -12};
    back.attenuation = {0.5f, 0.02f, 0.001f};
    back.diffuse = glm::vec3(0.2f, 0.3f, 0.5f);
    back.specular = glm::vec3(0.1f, 0.12f, 0.15f);
    return {front, back};
}

/// A model with the parameters that it has here.
ModelScene scene(std::string name, const AnyReflectance& reflectance, Model model,
                 ShadingFrequency frequency = ShadingFrequency::phong) {
    RenderOptions options;
    options.frequency = frequency;
    options.reflectance = reflectance;
    options.reflectance_from_material = false;
    options.lights = front_and_back();
    options.default_material.specular = glm::vec3(0.8f, 0.9f, 1.0f);
    return {std::move(name), std::move(model), options};
}

const Fresnel glass{glm::vec3(1.5f), glm::vec3(0.0f)};
const Fresnel copper{{0.238f, 1.007f, 1.240f}, {3.626f, 2.582f, 2.393f}};
const Fresnel iron{{2.911f, 2.950f, 2.585f}, {3.089f, 2.932f, 2.767f}};

HeTorrance he_torrance(const Fresnel& fresnel, float sigma, float tau) {
    HeTorrance model;
    model.fresnel = fresnel;
    model.sigma = sigma;
    model.tau = tau;
    model.source_degrees = 8;  // so that the mirror reflection is some pixels large and does not only clamp
    return model;
}

AnyReflectance layered(const AnyReflectance& base, float sheen, float clearcoat, float roughness) {
    Material m;
    m.specular = glm::vec3(0.6f, 0.5f, 0.4f);
    m.sheen = sheen;
    m.clearcoat = clearcoat;
    m.clearcoat_roughness = roughness;
    return finish(m, base).reflectance;
}

struct Variant {
    const char* name;
    AnyReflectance model;
};

std::vector<Variant> variants() {
    using Distribution = CookTorrance::Distribution;
    using Denominator = CookTorrance::Denominator;
    return {
        {"Torrance-Sparrow, glass, m = 0.3", TorranceSparrow{glass, 0.3f}},
        {"Torrance-Sparrow, iron, m = 0.15", TorranceSparrow{iron, 0.15f}},
        {"Cook-Torrance, Beckmann, glass", CookTorrance{glass, 0.25f, Distribution::beckmann}},
        {"Cook-Torrance, Beckmann, copper", CookTorrance{copper, 0.4f, Distribution::beckmann}},
        {"Cook-Torrance, Gaussian, glass", CookTorrance{glass, 0.25f, Distribution::gaussian}},
        {"Cook-Torrance, Gaussian, copper", CookTorrance{copper, 0.4f, Distribution::gaussian}},
        {"Cook-Torrance over pi, copper", CookTorrance{copper, 0.5f, Distribution::beckmann, Denominator::pi}},
        {"Oren-Nayar, 0.5", OrenNayar{0.5f}},
        {"Oren-Nayar, 1.2", OrenNayar{1.2f}},
        {"Ward, bounded", Ward{0.12f, 0.45f}},
        {"Ward, of 1992", Ward{0.45f, 0.2f, Ward::Form::ward_1992}},
        {"velvet", Velvet{0.4f}},
        {"subsurface, marble", Subsurface{}},
        {"He-Torrance, rough iron", he_torrance(iron, 0.3f, 2.5f)},
        {"He-Torrance, smooth copper", he_torrance(copper, 0.06f, 3.0f)},
        {"He-Torrance, glass", he_torrance(glass, 0.15f, 1.5f)},
        {"Lambert under fibres", layered(Lambert{}, 1, 0, 0)},
        {"Ward under fibres and varnish", layered(Ward{0.12f, 0.45f}, 0.5f, 0.8f, 0.6f)},
        {"Cook-Torrance, copper, under varnish", layered(CookTorrance{copper, 0.4f}, 0, 1, 0.3f)},
    };
}

/// Every variant at each shading frequency; a torus has all normals, and some hidden by others.
std::vector<ModelScene> variant_scenes() {
    std::vector<ModelScene> scenes;
    for (const Variant& v : variants()) {
        scenes.push_back(scene(std::string("torus, ") + v.name, v.model, torus()));
        // Ward's form of 1992 has no bound where n v = 0: a vertex seen edge-on has the rounding of n v a thousandfold.
        const Ward* ward = std::get_if<Ward>(&v.model);
        if (!ward || ward->form == Ward::Form::bounded)
            scenes.push_back(scene(std::string("teapot, Gouraud shading, ") + v.name, v.model, teapot(8),
                                   ShadingFrequency::gouraud));
        scenes.push_back(scene(std::string("teapot, flat shading, ") + v.name, v.model, teapot(8),
                               ShadingFrequency::flat));
    }
    return scenes;
}

/// The substances that one can ask for, on a vase; and a light in watts.
std::vector<ModelScene> substance_scenes() {
    std::vector<ModelScene> scenes;
    for (const std::string_view name : material_names()) {
        ModelScene s = scene("vase of " + std::string(name), Lambert{}, vase(48));
        s.options.reflectance_from_material = true;
        s.options.default_material = *find_material(name);
        scenes.push_back(std::move(s));
    }
    ModelScene turned = scene("vase of brushed aluminium, its grain turned", Lambert{}, vase(48));
    turned.options.reflectance_from_material = true;
    turned.options.default_material = *find_material("brushed-aluminium");
    turned.options.default_material.anisotropy_rotation = 0.1f;
    scenes.push_back(std::move(turned));
    // Aluminium seen edge-on at the rims, where the effective roughness depends on the last digits of n v.
    ModelScene rims = scene("torus of ground-aluminium", Lambert{}, torus());
    rims.options.reflectance_from_material = true;
    rims.options.default_material = *find_material("ground-aluminium");
    scenes.push_back(std::move(rims));
    ModelScene watts = scene("sphere, Cook-Torrance, 40 W/sr", CookTorrance{copper, 0.4f}, sphere());
    Light lamp;
    lamp.kind = LightKind::point;
    lamp.units = LightUnits::radiometric;
    lamp.position = {2, 4, 3};
    lamp.diffuse = lamp.specular = glm::vec3(40, 30, 20);
    watts.options.lights = {lamp};
    scenes.push_back(std::move(watts));
    return scenes;
}

void compare_all(const std::vector<ModelScene>& scenes) {
    const auto gl = tool::OpenGl::make();
    ASSERT_TRUE(gl) << gl.error().message;
    for (const ModelScene& s : scenes) {
        SCOPED_TRACE(s.name);
        LitPair pair;
        const Camera camera = auto_frame(s.model, double(width) / height);
        ASSERT_NO_FATAL_FAILURE(draw_lit_pair(**gl, s.model, camera, s.options, width, height, pair));
        const auto& [ours, theirs] = pair;
        const Difference difference = compare(ours, theirs);
        EXPECT_EQ(difference.depth_pixels, 0u) << s.name;
        EXPECT_LE(difference.largest, 1) << s.name;
        // What is black or white all over compares nothing.
        std::size_t drawn = 0, between = 0;
        for (std::size_t i = 0; i < theirs.depth.size(); ++i) {
            if (theirs.depth[i] == 0xffffff) continue;
            ++drawn;
            const std::uint32_t red = theirs.color[i] & 255;
            between += red > 2 && red < 255;
        }
        EXPECT_GT(drawn, std::size_t(width * height / 20)) << s.name;
        EXPECT_GT(between, drawn / 8) << s.name;
        std::printf("| %s | %zu | %zu | %d/255 |\n", s.name.c_str(), drawn, difference.color_pixels,
                    difference.largest);
    }
}

TEST(LitModels, AtEveryShadingFrequency) { compare_all(variant_scenes()); }
TEST(LitModels, SubstancesByName) { compare_all(substance_scenes()); }

TEST(LitModels, AllButTablesAreKnownInGlsl) {
    for (const std::string_view name : reflectance_names())
        EXPECT_TRUE(tool::reflectance_in_glsl(*find_reflectance(name))) << name;
    EXPECT_FALSE(tool::reflectance_in_glsl(Measured{}));
}

}  // namespace
