// Substances by name, and the physically based keys of MTL files.
#include <gtest/gtest.h>
#include <raster/scene/material_model.h>
#include <raster/shading/materials.h>
#include <raster/shading/models.h>

#include "shading_hemisphere.h"

namespace {

using namespace raster;
using namespace raster::testing;

AnyReflectance model_of(const Material& m) {
    return RuntimeModel{find_reflectance(m.reflectance).value()}.with_material(m).model;
}

TEST(Materials, EachHasItsNameAModelAndReflectsNoMoreThanItGets) {
    const auto names = material_names();
    EXPECT_GE(names.size(), 15u);
    for (const std::string_view name : names) {
        const auto material = find_material(name);
        ASSERT_TRUE(material) << name;
        EXPECT_EQ(material->name, name);
        ASSERT_TRUE(find_reflectance(material->reflectance)) << name;
        const auto model = model_of(*material);
        for (const double angle : {0.0, 40.0, 70.0}) {
            glm::vec3 sum(0.0f);
            Random random(1);
            const auto frame = flat_frame(at_degrees(angle));
            sum = 2.0f * hemisphere_mean(random, 60, [&](const glm::vec3& l) {
                      const auto value = RuntimeModel{model}.evaluate(frame, l);
                      return value.diffuse * material->diffuse + value.specular * material->specular;
                  });
            for (int c = 0; c < 3; ++c) EXPECT_LT(sum[c], 1.05f) << name << " seen at " << angle;
        }
    }
    EXPECT_FALSE(find_material("unobtainium"));
}

TEST(Materials, MetalsHaveTheirKnownColoursAtNormalIncidence) {
    const auto reflectance = [](std::string_view name) { return metal_ambient(*find_material(name)); };
    const glm::vec3 gold = reflectance("gold"), copper = reflectance("copper"), silver = reflectance("silver");
    EXPECT_GT(gold.x, 0.9f);
    EXPECT_GT(gold.x, gold.y);
    EXPECT_GT(gold.y, 1.5f * gold.z);
    EXPECT_NEAR(gold.z, 0.40f, 0.03f);
    EXPECT_GT(copper.x, 0.9f);
    EXPECT_NEAR(copper.y, 0.62f, 0.04f);
    for (int c = 0; c < 3; ++c) EXPECT_GT(silver[c], 0.95f);
    const glm::vec3 aluminium = reflectance("aluminium"), iron = reflectance("iron");
    for (int c = 0; c < 3; ++c) {
        EXPECT_NEAR(aluminium[c], 0.91f, 0.015f);
        EXPECT_NEAR(iron[c], 0.51f, 0.03f);
    }
}

TEST(PhysicallyBased, LeavesOtherMaterialsAsTheyAre) {
    Material m;
    m.roughness = 0.5f;
    EXPECT_EQ(physically_based(m).reflectance, "");
    m.physically_based = true;
    m.reflectance = "phong";
    EXPECT_EQ(physically_based(m).reflectance, "phong");
    EXPECT_EQ(physically_based(m).roughness, 0.5f);
}

TEST(PhysicallyBased, ADielectricKeepsItsColourAndAMetalReflectsIt) {
    Material m;
    m.physically_based = true;
    m.diffuse = {0.9f, 0.5f, 0.1f};
    m.roughness = 0.6f;
    const Material plastic = physically_based(m);
    EXPECT_EQ(plastic.diffuse, m.diffuse);
    EXPECT_FLOAT_EQ(plastic.roughness, 0.36f);
    EXPECT_NEAR(metal_ambient(plastic).x, 0.04f, 1e-5f);
    m.metallic = 1;
    const Material metal = physically_based(m);
    EXPECT_EQ(metal.diffuse, glm::vec3(0.0f));
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(metal_ambient(metal)[c], m.diffuse[c], 1e-4f);
    m.metallic = 0.5f;
    EXPECT_NEAR(metal_ambient(physically_based(m)).x, 0.5f * 0.04f + 0.5f * 0.9f, 1e-3f);
    EXPECT_NEAR(physically_based(m).diffuse.x, 0.45f, 1e-6f);
}

TEST(PhysicallyBased, WithAnisotropyIsWards) {
    Material m;
    m.physically_based = true;
    m.anisotropy = 0.5f;
    m.roughness = 0.5f;
    EXPECT_EQ(physically_based(m).reflectance, "ward");
    const auto ward = std::get<Ward>(model_of(physically_based(m)));
    EXPECT_LT(ward.along, ward.across);
    EXPECT_NEAR(ward.along * ward.across, 0.25f * 0.25f, 1e-5f);
}

TEST(PhysicallyBased, AMetalHasItsColourOnceUnderEveryModel) {
    Material m;
    m.physically_based = true;
    m.diffuse = {0.8f, 0.5f, 0.2f};
    m.metallic = 1;
    for (const float anisotropy : {0.0f, 0.9f}) {
        m.anisotropy = anisotropy;
        const Material metal = physically_based(m);
        for (int c = 0; c < 3; ++c) {
            EXPECT_NEAR(metal_ambient(metal)[c], m.diffuse[c], 1e-4f) << anisotropy;
            EXPECT_NEAR(specular_color(metal, Phong{})[c], m.diffuse[c], 1e-4f) << anisotropy;
            EXPECT_NEAR(specular_color(metal, Ward{})[c], m.diffuse[c], 1e-4f) << anisotropy;
            EXPECT_EQ(specular_color(metal, CookTorrance{})[c], 1.0f) << "Fresnel's equations give it";
        }
    }
    m.metallic = 0;
    EXPECT_NEAR(specular_color(physically_based(m), Ward{}).x, 0.04f, 1e-5f);
}

}  // namespace
