// The colour that reflectance models have under even light.
#include <gtest/gtest.h>
#include <raster/scene/draw_plan.h>
#include <raster/shading/albedo.h>
#include <raster/shading/materials.h>
#include <raster/shading/measured_bake.h>

#include "shading_hemisphere.h"

namespace {

using namespace raster;
using namespace raster::testing;

AnyReflectance model_of(const char* substance) {
    const Material m = *find_material(substance);
    return RuntimeModel{*find_reflectance(m.reflectance)}.with_material(m).model;
}

/// By seeded directions to light and viewer, each apart.
glm::vec3 by_directions(const AnyReflectance& model, float kd, float ks) {
    Random random(3);
    return 2.0f * hemisphere_mean(random, 12, [&](const glm::vec3& v) {
               return albedo(RuntimeModel{model}, v, kd, ks, 40) * v.z;
           });
}

AnyReflectance baked(const char* substance, MeasuredSize size) {
    const Material m = *find_material(substance);
    auto table = bake_measured(model_of(substance), m.diffuse, m.specular, size);
    return Measured{std::make_shared<const MeasuredTable>(std::move(table))};
}

TEST(DiffuseAlbedo, OfLambertsLawIsOneAndOfOthersThatOfTheHemisphere) {
    for (const AnyReflectance& white : {AnyReflectance(Lambert{}), AnyReflectance(Phong{}), AnyReflectance(Velvet{})})
        EXPECT_EQ(diffuse_albedo(white), glm::vec3(1.0f));
    for (const char* substance : {"marble", "skin", "milk", "ketchup", "clay", "moon"}) {
        const AnyReflectance model = model_of(substance);
        const glm::vec3 sum = diffuse_albedo(model), expected = by_directions(model, 1, 0);
        for (int c = 0; c < 3; ++c) EXPECT_NEAR(sum[c], expected[c], 0.003f) << substance << " " << c;
    }
    EXPECT_EQ(diffuse_albedo(Measured{}), glm::vec3(0.0f)) << "without a table";
}

TEST(DiffuseAlbedo, OfABakedMetalIsWhatItsHighlightReflects) {
    for (const char* substance : {"gold", "copper"}) {
        const glm::vec3 sum = diffuse_albedo(baked(substance, {60, 60, 60}));
        const glm::vec3 expected = by_directions(model_of(substance), 0, 1);
        for (int c = 0; c < 3; ++c) EXPECT_NEAR(sum[c], expected[c], 0.01f) << substance << " " << c;
    }
}

TEST(OwnColor, IsOneWhereKdIsTheColour) {
    for (const AnyReflectance& model : {AnyReflectance(OrenNayar{}), AnyReflectance(CookTorrance{})})
        EXPECT_EQ(own_color(model), glm::vec3(1.0f));
    EXPECT_LT(own_color(model_of("ketchup")).y, 0.2f * own_color(model_of("ketchup")).x);
}

TEST(Ambient, ColourThatCountsIsTakenAsItIsOfEveryMaterial) {
    Model model;
    add_quad(model, {glm::vec3(-1, -1, 0), {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}}, {0, 0, 1});
    RenderOptions options;
    Light light;
    light.kind = LightKind::ambient;
    light.ambient = glm::vec3(0.5f);
    options.lights = {light};
    for (const char* substance : {"clay", "gold", "ketchup"}) {
        options.default_material = *find_material(substance);
        options.default_material.ambient = {0.25f, 0.5f, 1};
        Target target(16, 16, ColorFormat::rgba_float);
        render(target, model, *camera_matrices(Camera{}, 1.0), options);
        EXPECT_NE(glm::vec3(target.color(8, 8)), glm::vec3(0.125f, 0.25f, 0.5f)) << substance;
        options.default_material.ambient_counts = true;
        render(target, model, *camera_matrices(Camera{}, 1.0), options);
        EXPECT_EQ(glm::vec3(target.color(8, 8)), glm::vec3(0.125f, 0.25f, 0.5f)) << substance;
    }
}

TEST(Ambient, LightOnKetchupAndOnATableHasTheirColourTimesKd) {
    Model model;
    add_quad(model, {glm::vec3(-1, -1, 0), {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}}, {0, 0, 1});
    RenderOptions options;
    Light light;
    light.kind = LightKind::ambient;
    light.ambient = glm::vec3(0.5f);
    options.lights = {light};
    options.default_material = *find_material("ketchup");
    options.default_material.diffuse = {1, 0.5f, 1};
    const auto middle = [&] {
        Target target(16, 16, ColorFormat::rgba_float);
        render(target, model, *camera_matrices(Camera{}, 1.0), options);
        return glm::vec3(target.color(8, 8));
    };
    const glm::vec3 ketchup = diffuse_albedo(model_of("ketchup")) * options.default_material.diffuse * 0.5f;
    EXPECT_EQ(middle(), ketchup);
    options.ambient_color = AmbientColor::material;
    options.default_material.ambient = glm::vec3(0.25f);
    EXPECT_EQ(middle(), diffuse_albedo(model_of("ketchup")) * 0.25f * 0.5f);

    const AnyReflectance gold = baked("gold", {30, 30, 36});
    options = {};
    options.lights = {light};
    options.default_material.diffuse = glm::vec3(1.0f);
    options.default_material.reflectance = "measured";
    options.default_material.measured = std::get<Measured>(gold).table;
    EXPECT_EQ(middle(), diffuse_albedo(gold) * 0.5f);
}

}  // namespace
