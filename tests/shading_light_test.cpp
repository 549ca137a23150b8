// Lights against the lectures' formulas: what arrives at a point, and the sum over several.
#include <gtest/gtest.h>
#include <raster/scene/transform.h>
#include <raster/shading/models.h>
#include <raster/shading/light.h>

#include "shading_testing.h"

namespace {

using namespace raster;
using namespace raster::testing;

LightSample<float> sample_at(const Light& light, glm::vec3 position) {
    return sample_light(to_eye(light, glm::mat4(1.0f)), position);
}

TEST(DirectionalLight, IsTheSameAtEveryPoint) {
    Light light;
    light.direction = {0, -3, 4};
    for (const glm::vec3 p : {glm::vec3(0.0f), glm::vec3(100, -7, 1e6f)}) {
        EXPECT_EQ(sample_at(light, p).l, glm::vec3(0, 0.6f, -0.8f));
        EXPECT_EQ(sample_at(light, p).strength, 1.0f);
    }
}

TEST(PointLight, ComesFromItsPositionAndDecaysWithTheThreeCoefficients) {
    Light light;
    light.kind = LightKind::point;
    light.position = {0, 3, 4};
    light.attenuation = {0.5f, 0.25f, 0.125f};
    const auto at_origin = sample_at(light, glm::vec3(0.0f));
    EXPECT_NEAR(glm::distance(at_origin.l, glm::vec3(0, 0.6f, 0.8f)), 0, 1e-6);
    EXPECT_NEAR(at_origin.strength, 1 / (0.5 + 0.25 * 5 + 0.125 * 25), 1e-7);
}

TEST(PointLight, IsNeverStrongerThanItsIntensity) {
    Light light;
    light.kind = LightKind::point;
    for (const Attenuation a : {Attenuation{0, 0, 1}, {0, 1, 0}, {0.1f, 0, 0}, {0, 0, 0}}) {
        light.attenuation = a;
        for (const float distance : {0.0f, 1e-20f, 1e-3f, 0.5f})
            EXPECT_EQ(sample_at(light, {0, 0, distance}).strength, 1.0f);
    }
    light.attenuation = {0, 0, 1};
    EXPECT_EQ(sample_at(light, {0, 0, 2}).strength, 0.25f);  // past 1, 1/d^2 again
    EXPECT_EQ(sample_at(light, {0, 0, 0}).l, glm::vec3(0.0f));
}

TEST(RadiometricLight, GivesTheIrradianceOfItsIntensityOverTheSquareOfTheDistance) {
    // A white Lambertian surface: pi times its radiance is its irradiance, I cos(theta) / r^2.
    Light light;
    light.kind = LightKind::point;
    light.units = LightUnits::radiometric;
    light.diffuse = {50, 20, 10};  // W/sr
    Random random(3);
    for (int i = 0; i < 500; ++i) {
        light.position = {random.uniform(-3, 3), random.uniform(-3, 3), random.uniform(0.05f, 3)};
        const std::vector<EyeLight> lights = {to_eye(light, glm::mat4(1.0f))};
        const Frame<float> frame{{0, 0, 1}, {0, 0, 1}, {}, {}};
        const glm::vec3 radiance = illuminate(Lambert{}, lights, frame, glm::vec3(0.0f)).diffuse;
        const glm::dvec3 p(light.position);
        const double r = glm::length(p), irradiance = 50 * (p.z / r) / (r * r);
        EXPECT_NEAR(3.14159265358979 * double(radiance.x), irradiance, 1e-5 * irradiance);
        EXPECT_NEAR(radiance.x / radiance.z, 5, 1e-5);
    }
}

TEST(RadiometricLight, OnASphereAroundItGivesItsWholePower) {
    // Isotropic: 4 pi I. The mean of E over a sphere of radius r times its area.
    Light light;
    light.kind = LightKind::point;
    light.units = LightUnits::radiometric;
    const std::vector<EyeLight> lights = {to_eye(light, glm::mat4(1.0f))};
    for (const float r : {0.25f, 1.0f, 7.0f}) {
        const Frame<float> frame{{0, 0, -1}, {0, 0, -1}, {}, {}};
        const double e = 3.14159265358979 * double(illuminate(Lambert{}, lights, frame, glm::vec3(0, 0, r)).diffuse.x);
        EXPECT_NEAR(e * 4 * 3.14159265358979 * double(r * r), 4 * 3.14159265358979, 1e-4) << r;
    }
}

TEST(RadiometricLight, KnowsTheConeAndDirectionalOnesAreIrradiance) {
    Light light;
    light.units = LightUnits::radiometric;
    light.kind = LightKind::spot;
    light.attenuation = {100, 100, 100};  // is not asked
    light.cutoff_degrees = 20;
    light.falloff_exponent = 2;
    const double c = std::cos(10 * 3.14159265358979 / 180);
    light.direction = {0, 0, 1};
    EXPECT_NEAR(sample_at(light, at_degrees(10) * 2.0f).strength, c * c / 4, 1e-6);
    EXPECT_EQ(sample_at(light, at_degrees(21)).strength, 0.0f);
    light.kind = LightKind::directional;
    light.direction = {0, 0, -1};
    const std::vector<EyeLight> lights = {to_eye(light, glm::mat4(1.0f))};
    const Frame<float> frame{{0, 0, 1}, {0, 0, 1}, {}, {}};
    EXPECT_NEAR(3.14159265f * illuminate(Lambert{}, lights, frame, glm::vec3(5, 5, 5)).diffuse.x, 1, 1e-6);
}

TEST(SpotLight, EndsAtItsConeAndFallsOffWithTheAngleFromItsAxis) {
    Light light;
    light.kind = LightKind::spot;
    light.position = {0, 0, 0};
    light.direction = {0, 0, 5};
    light.cutoff_degrees = 40;
    light.falloff_exponent = 3;
    for (const double degrees : {0.0, 10.0, 20.0, 39.99}) {
        const double cosine = std::cos(degrees * 3.14159265358979 / 180);
        EXPECT_NEAR(sample_at(light, at_degrees(degrees) * 7.0f).strength, cosine * cosine * cosine, 1e-6) << degrees;
    }
    for (const double degrees : {40.01, 90.0, 180.0}) EXPECT_EQ(sample_at(light, at_degrees(degrees)).strength, 0.0f);

    light.falloff_exponent = 0;
    EXPECT_EQ(sample_at(light, at_degrees(39)).strength, 1.0f);
    light.cutoff_degrees = 180;
    for (const double degrees : {91.0, 179.0, 180.0}) EXPECT_EQ(sample_at(light, at_degrees(degrees)).strength, 1.0f);
    light.attenuation = {0, 2, 0};
    EXPECT_NEAR(sample_at(light, at_degrees(10) * 7.0f).strength, 1.0 / 14, 1e-7);
}

TEST(Lights, OfTheWorldMoveWithTheCameraAndThoseOfTheEyeDoNot) {
    const glm::mat4 eye_from_world = look_at({0, 0, 10}, {0, 0, 0}, {0, 1, 0});
    Light light;
    light.kind = LightKind::spot;
    light.position = {1, 2, 3};
    light.direction = {0, 0, -1};
    EXPECT_EQ(to_eye(light, eye_from_world).position_eye, glm::vec3(1, 2, -7));
    EXPECT_EQ(to_eye(light, look_at({10, 0, 0}, {0, 0, 0}, {0, 1, 0})).direction_eye, glm::vec3(1, 0, 0));
    light.space = LightSpace::eye;
    EXPECT_EQ(to_eye(light, eye_from_world).position_eye, glm::vec3(1, 2, 3));
}

TEST(Lights, AddUpChannelByChannelWithTheirOwnColours) {
    Light red, blue, glow;
    red.ambient = {0.1f, 0, 0};
    red.diffuse = {1, 0, 0};
    red.specular = {0, 1, 0};
    red.direction = {0, 0, -1};
    blue = red;
    blue.ambient = {0, 0, 0.2f};
    blue.diffuse = {0, 0, 0.5f};
    blue.specular = {0, 0, 1};
    glow.kind = LightKind::ambient;
    glow.ambient = {0.5f, 0.5f, 0.5f};
    glow.diffuse = {9, 9, 9};  // does not count
    const std::array lights = {red, glow, blue};
    const Lighting lighting = make_lighting(lights, glm::mat4(1.0f));
    EXPECT_EQ(lighting.ambient, glm::vec3(0.6f, 0.5f, 0.7f));
    ASSERT_EQ(lighting.lights.size(), 2u);

    const glm::vec3 up(0, 0, 1);
    const Lit<float> lit = illuminate(Phong{20}, lighting.lights, Frame<float>{up, up, {}, {}}, glm::vec3(0.0f));
    EXPECT_EQ(lit.diffuse, glm::vec3(1, 0, 0.5f));
    EXPECT_EQ(lit.specular, glm::vec3(0, 1, 1));
}

TEST(Lights, TellTwoParallelPlanesApartOnlyByTheirDecay) {
    Light light;
    light.kind = LightKind::point;
    light.position = {0, 0, 10};
    const auto brightness = [&](float z) {
        const std::array lights = {light};
        const Lighting lighting = make_lighting(lights, glm::mat4(1.0f));
        return illuminate(Lambert{}, lighting.lights, Frame<float>{{0, 0, 1}, {0, 0, 1}, {}, {}}, glm::vec3(0, 0, z))
            .diffuse.x;
    };
    EXPECT_EQ(brightness(0), brightness(5));
    light.attenuation = {0, 0.2f, 0};
    EXPECT_NEAR(brightness(0), 0.5f, 1e-6f);
    EXPECT_NEAR(brightness(5), 1.0f, 1e-6f);
}

TEST(Lights, GiveLanesExactlyWhatTheyGiveTheScalar) {
    constexpr int n = 4;
    using F = FloatPack<n>;
    Random random(11);
    for (int round = 0; round < 300; ++round) {
        Light light;
        light.kind = LightKind(random.integer(1, 3));
        light.position = unit_vector(random);
        light.direction = unit_vector(random);
        light.attenuation = {random.uniform(0, 1), random.uniform(0, 1), random.uniform(0, 1)};
        light.cutoff_degrees = random.uniform(0, 180);
        light.falloff_exponent = random.integer(0, 1) ? random.uniform(0, 20) : 0;
        const EyeLight eye = to_eye(light, glm::mat4(1.0f));
        glm::vec3 points[n];
        vec<3, F> packed;
        for (int i = 0; i < n; ++i) {
            points[i] = unit_vector(random) * random.uniform(0, 3);
            for (int c = 0; c < 3; ++c) set_lane(packed[c], i, points[i][c]);
        }
        const LightSample<F> samples = sample_light(eye, packed);
        for (int i = 0; i < n; ++i) {
            const LightSample<float> scalar = sample_light(eye, points[i]);
            ASSERT_EQ(bits_of(scalar.strength), bits_of(lane(samples.strength, i)));
            for (int c = 0; c < 3; ++c) ASSERT_EQ(bits_of(scalar.l[c]), bits_of(lane(samples.l[c], i)));
        }
    }
}

}  // namespace
