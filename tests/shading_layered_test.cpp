// Layers on a reflectance model: fibres, varnish, and what is left for the base.
#include <gtest/gtest.h>
#include <raster/scene/append.h>
#include <raster/scene/draw_plan.h>
#include <raster/scene/material_model.h>
#include <raster/scene/transform.h>

#include "shading_hemisphere.h"

namespace {

using namespace raster;
using namespace raster::testing;

Layered layered(const AnyReflectance& base, float sheen, float clearcoat, float roughness, float ks = 0) {
    Material m;
    m.specular = glm::vec3(ks);
    m.sheen = sheen;
    m.clearcoat = clearcoat;
    m.clearcoat_roughness = roughness;
    return std::get<Layered>(finish(m, base).reflectance);
}

TEST(Sheen, TakesFromBelowWhatItReflectsAndALittleMore) {
    for (const double angle : {0.0, 20.0, 40.0, 60.0, 75.0, 85.0, 89.0}) {
        const float reflected = albedo(layered(Lambert{}, 1, 0, 0), at_degrees(angle), 0, 1, 300).x;
        const float taken = Sheen::albedo(at_degrees(angle).z);
        EXPECT_GE(taken, reflected - 0.002f) << angle;
        EXPECT_LE(taken, reflected + 0.03f) << angle;
    }
    EXPECT_GT(Sheen::albedo(0.05f), 5 * Sheen::albedo(1.0f)) << "it is at the outline";
}

TEST(Clearcoat, OnBlackIsCookAndTorrancesVarnish) {
    Random random(1);
    CookTorrance varnish;
    varnish.m = 0.4f * 0.4f;
    const Layered model = layered(Lambert{}, 0, 0.7f, 0.4f);
    for (int i = 0; i < 500; ++i) {
        const glm::vec3 l = unit_vector(random), v = unit_vector(random);
        const auto a = model.evaluate(flat_frame(v), l), b = varnish.evaluate(flat_frame(v), l);
        EXPECT_NEAR(a.specular.x, 0.7f * b.specular.x, 1e-5f * (1 + b.specular.x));
    }
}

TEST(Clearcoat, LetsThroughWhatFresnelsEquationsLeave) {
    const glm::vec3 up(0, 0, 1);
    const auto value = layered(Lambert{}, 0, 1, 0.5f).evaluate(flat_frame(up), up);
    EXPECT_NEAR(value.diffuse.x, 0.96f * 0.96f, 1e-5f);
    const auto half = layered(Lambert{}, 0, 0.5f, 0.5f).evaluate(flat_frame(up), up);
    EXPECT_NEAR(half.diffuse.x, 0.98f * 0.98f, 1e-5f);
    const auto grazing = layered(Lambert{}, 0, 1, 0.5f).evaluate(flat_frame(at_degrees(89.9)), up);
    EXPECT_LT(grazing.diffuse.x, 0.02f);
}

TEST(Layered, IsReciprocalOverReciprocalModelsAndGivesNoMoreThanItGets) {
    const std::array<AnyReflectance, 4> bases = {Lambert{}, OrenNayar{0.5f}, CookTorrance{}, Velvet{}};
    Random random(2);
    for (const AnyReflectance& base : bases) {
        for (const glm::vec3& layers :
             {glm::vec3(1, 0, 0), {0, 1, 0.3f}, {0, 1, 0.8f}, {0.5f, 0.7f, 0.5f}, {1, 1, 1}}) {
            const float sheen = layers.x, coat = layers.y, roughness = layers.z;
            const bool has_diffuse = base.index() == 0 || base.index() == AnyReflectance(OrenNayar{}).index();
            const float kd = has_diffuse ? 1.0f : 0.0f;
            const Layered model = layered(base, sheen, coat, roughness, 1.0f - kd);
            const auto f = [&](const glm::vec3& l, const glm::vec3& v) {
                const auto value = model.evaluate(flat_frame(v), l);
                return (value.diffuse.x * kd + value.specular.x) / l.z;
            };
            for (int i = 0; i < 500; ++i) {
                const glm::vec3 a = direction_above(random.uniform(0.02f, 1), random.uniform(0, 6.3f));
                const glm::vec3 b = direction_above(random.uniform(0.02f, 1), random.uniform(0, 6.3f));
                EXPECT_NEAR(f(a, b), f(b, a), 1e-5f * std::max(f(a, b), 1.0f));
            }
            for (const double angle : {0.0, 30.0, 60.0, 75.0, 85.0})
                EXPECT_LT(albedo(model, at_degrees(angle), kd, 1, 200).x, 1.01f)
                    << base.index() << " at " << angle << " with " << sheen << " " << coat << " " << roughness;
        }
    }
}

TEST(Layered, IsTheBaseAloneWithoutLayersAndBlackWithoutABase) {
    Material m;
    m.specular = {0.1f, 0.2f, 0.3f};
    const MaterialModel bare = finish(m, Phong{7});
    EXPECT_EQ(std::get<Phong>(bare.reflectance).exponent, 7);
    EXPECT_EQ(bare.specular, m.specular);
    m.clearcoat = 1e-9f;  // next to none
    const MaterialModel coated = finish(m, Phong{7});
    EXPECT_EQ(coated.specular, glm::vec3(1.0f));
    const glm::vec3 l = at_degrees(20), v = at_degrees(-25);
    const auto a = RuntimeModel{coated.reflectance}.evaluate(flat_frame(v), l), b = Phong{7}.evaluate(flat_frame(v), l);
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(a.specular[c], b.specular[c] * m.specular[c], 1e-6f);
    EXPECT_EQ(Layered{}.evaluate(flat_frame(v), l).diffuse, glm::vec3(0.0f));
}

TEST(Layered, GivesLanesWhatItGivesTheScalarFiniteForAllDirections) {
    using F = FloatN;
    constexpr int n = lanes<F>;
    Random random(4);
    const RuntimeModel model{layered(Ward{}, 0.8f, 0.9f, 0.3f, 0.5f)};
    ASSERT_TRUE(reads_tangents(model));
    for (int round = 0; round < 400; ++round) {
        Frame<float> frames[n];
        glm::vec3 ls[n];
        Frame<F> frame;
        vec<3, F> l;
        for (int i = 0; i < n; ++i) {
            frames[i] = make_frame(unit_vector(random), unit_vector(random), unit_vector(random));
            ls[i] = i == 0 ? -frames[i].v : unit_vector(random);
            for (int c = 0; c < 3; ++c) {
                set_lane(frame.n[c], i, frames[i].n[c]);
                set_lane(frame.v[c], i, frames[i].v[c]);
                set_lane(frame.t[c], i, frames[i].t[c]);
                set_lane(frame.b[c], i, frames[i].b[c]);
                set_lane(l[c], i, ls[i][c]);
            }
        }
        const Reflectance<F> packed = model.evaluate(frame, l);
        for (int i = 0; i < n; ++i) {
            const Reflectance<float> scalar = model.evaluate(frames[i], ls[i]);
            for (int c = 0; c < 3; ++c) {
                ASSERT_EQ(bits_of(scalar.diffuse[c]), bits_of(lane(packed.diffuse[c], i)));
                ASSERT_EQ(bits_of(scalar.specular[c]), bits_of(lane(packed.specular[c], i)));
                ASSERT_TRUE(scalar.specular[c] >= 0 && scalar.specular[c] < 1e9f && scalar.diffuse[c] >= 0);
                if (glm::dot(frames[i].n, ls[i]) <= 0) {
                    ASSERT_EQ(scalar.diffuse[c] + scalar.specular[c], 0.0f);
                }
            }
        }
    }
}

Model brushed_square(float rotation) {
    Model model;
    add_quad(model, {glm::vec3(-1, -1, 0), {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}}, {0, 0, 1}, 0);
    model.materials.push_back(*find_material("brushed-aluminium"));
    model.materials[0].anisotropy_rotation = rotation;
    return model;
}

std::vector<std::uint32_t> picture(const Model& model, const glm::mat4& world_from_object = glm::mat4(1.0f)) {
    Target target(32, 32);
    RenderOptions options;
    options.world_from_object = world_from_object;
    render(target, model, *camera_matrices(Camera{}, 1.0), options);
    const auto pixels = target.color8();
    return {pixels.begin(), pixels.end()};
}

TEST(Grain, TurnsWithItsObjectAndByTheMaterialsRotation) {
    const glm::mat4 quarter = rotate(90, {0, 0, 1});  // takes the square to itself, and its grain from y to -x
    const auto upright = picture(brushed_square(0)), turned = picture(brushed_square(0), quarter);
    EXPECT_NE(upright, turned);
    Model scene;
    ASSERT_TRUE(append(scene, brushed_square(0), quarter));
    EXPECT_NEAR(glm::length(scene.materials[0].grain - glm::vec3(-1, 0, 0)), 0.0f, 1e-6f);
    EXPECT_EQ(picture(scene), turned);
    EXPECT_EQ(picture(brushed_square(0.25f)), turned) << "a quarter of a turn, counter-clockwise";
    EXPECT_EQ(picture(brushed_square(0.5f)), upright) << "a grain has no front";
    const auto frame = raster::turned(make_frame(glm::vec3(0, 0, 1), glm::vec3(0, 0, 1), glm::vec3(0, 1, 0)), 0.8f, 0.6f);
    EXPECT_EQ(frame.t, glm::vec3(-0.6f, 0.8f, 0)) << "counter-clockwise";
    EXPECT_EQ(frame.b, glm::cross(frame.n, frame.t));
    const Model eighth = brushed_square(0.125f);
    DrawPlan(eighth, {}, false).for_each(*camera_matrices(Camera{}, 1.0), [](const PlannedDraw& draw) {
        EXPECT_FLOAT_EQ(draw.uniforms.grain_turn.x, std::sqrt(0.5f));
        EXPECT_FLOAT_EQ(draw.uniforms.grain_turn.y, std::sqrt(0.5f));
    });
}

}  // namespace
