// The reflectance models against their textbook formulas, and what all of them promise.
#include <algorithm>
#include <cstring>
#include <set>

#include <gtest/gtest.h>
#include <raster/shading/models.h>

#include "shading_testing.h"

namespace {

using namespace raster;
using namespace raster::testing;

template <class Model>
Reflectance<float> evaluate(const Model& model, glm::vec3 n, glm::vec3 l, glm::vec3 v) {
    return model.evaluate(Frame<float>{n, v, {}, {}}, l);
}

/// Calls check(model) for every model of the list, with parameters of several sizes.
template <class Check>
void for_every_model(const Check& check) {
    for (const std::string_view name : reflectance_names()) {
        for (const float shininess : {0.0f, 1.0f, 5.0f, 32.0f, 200.0f, 1000.0f}) {
            Material material;
            material.shininess = shininess;
            material.roughness = shininess / 1000.0f;
            SCOPED_TRACE(std::string(name) + " with Ns " + std::to_string(shininess));
            std::visit([&](const auto& model) { check(model.with_material(material)); }, *find_reflectance(name));
        }
    }
}

const glm::vec3 up(0, 0, 1);

TEST(Lambert, IsTheCosineOfTheLightsAngleFromWhereverItIsSeen) {
    for (const double degrees : {0.0, 30.0, 45.0, 60.0, 80.0}) {
        for (const double seen_from : {-70.0, 0.0, 50.0}) {
            const auto value = evaluate(Lambert{}, up, at_degrees(degrees), at_degrees(seen_from));
            EXPECT_NEAR(value.diffuse.x, std::cos(degrees * 3.14159265358979 / 180), 1e-6);
            EXPECT_EQ(value.specular, glm::vec3(0.0f));
        }
    }
    EXPECT_EQ(evaluate(Lambert{}, up, at_degrees(100), up).diffuse, glm::vec3(0.0f));
}

TEST(Phong, IsTheCosineBetweenMirrorAndViewerToTheExponent) {
    for (const double light : {10.0, 30.0, 60.0}) {
        for (const double viewer : {-70.0, -30.0, -10.0, 0.0, 15.0}) {
            for (const float exponent : {1.0f, 5.0f, 50.0f}) {
                const double r_v = std::cos((viewer + light) * 3.14159265358979 / 180);  // r is at -light
                const double expected = r_v > 0 ? std::pow(r_v, exponent) : 0;
                const auto value = evaluate(Phong{exponent}, up, at_degrees(light), at_degrees(viewer));
                EXPECT_NEAR(value.specular.y, expected, 2e-5) << light << " " << viewer << " " << exponent;
            }
        }
    }
}

TEST(Phong, IsOneInTheMirrorDirectionForAnyExponent) {
    Random random(1);
    for (int i = 0; i < 1000; ++i) {
        const glm::vec3 n = unit_vector(random), l = unit_vector(random);
        if (glm::dot(n, l) < 0.01f) continue;
        const glm::vec3 r = 2 * glm::dot(n, l) * n - l;
        const float exponent = float(random.integer(0, 200));
        EXPECT_NEAR(evaluate(Phong{exponent}, n, l, r).specular.x, 1.0f, 1e-6f * (exponent + 1)) << exponent;
    }
}

TEST(BlinnPhong, IsTheCosineBetweenNormalAndHalfVectorToTheExponent) {
    for (const double light : {10.0, 30.0, 60.0}) {
        for (const double viewer : {-70.0, -30.0, -10.0, 0.0, 15.0, 85.0}) {
            for (const float exponent : {0.5f, 5.0f, 50.0f}) {
                const double expected = std::pow(std::cos((light + viewer) / 2 * 3.14159265358979 / 180), exponent);
                const auto l = at_degrees(light), v = at_degrees(viewer);
                EXPECT_NEAR(evaluate(BlinnPhong{exponent}, up, l, v).specular.x, expected, 1e-5);
                const BlinnPhong quarter{4 * exponent, BlinnPhong::Exponent::quarter_alpha};
                EXPECT_NEAR(evaluate(quarter, up, l, v).specular.x, expected, 1e-5);
            }
        }
    }
}

TEST(BlinnPhong, GoesOnWherePhongEndsAtNinetyDegreesFromTheMirror) {
    const glm::vec3 l = at_degrees(60), v = at_degrees(45);  // 105 degrees from the mirror direction at -60
    EXPECT_EQ(evaluate(Phong{1}, up, l, v).specular.x, 0.0f);
    EXPECT_NEAR(evaluate(BlinnPhong{1}, up, l, v).specular.x, 0.6087614f, 1e-6f);  // cos 52.5
}

TEST(BlinnPhong, HasNoHighlightWhereThereIsNoHalfVector) {
    for (const double degrees : {0.0, 37.0, 60.0}) {
        const glm::vec3 l = at_degrees(degrees);
        EXPECT_EQ(evaluate(BlinnPhong{5}, up, l, -l).specular.x, 0.0f);
    }
}

TEST(ReflectanceModels, GiveLanesExactlyWhatTheyGiveTheScalar) {
    constexpr int n = 8;
    using F = FloatPack<n>;
    for_every_model([&](const auto& model) {
        Random random(2);
        for (int round = 0; round < 50; ++round) {
            Frame<float> frames[n];
            glm::vec3 ls[n];
            Frame<F> frame;
            vec<3, F> l;
            for (int i = 0; i < n; ++i) {
                frames[i] = make_frame(unit_vector(random), unit_vector(random), unit_vector(random));
                ls[i] = unit_vector(random);
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
                }
            }
        }
    });
}

TEST(ReflectanceModels, AreFiniteNotNegativeAndDarkFromBelowForAllDirections) {
    Random random(3);
    std::vector<glm::vec3> directions = {glm::vec3(0.0f), {1, 0, 0}, {-1, 0, 0}, {0, 0, 1}, {0, 0, -1}};
    for (int i = 0; i < 20; ++i) directions.push_back(unit_vector(random));
    for (const double degrees : {89.9, 89.9999, 90.0, 90.0001, 90.1}) directions.push_back(at_degrees(degrees));
    for_every_model([&](const auto& model) {
        for (const glm::vec3& n : directions) {
            for (const glm::vec3& l : directions) {
                for (const glm::vec3& v : directions) {
                    const auto value = model.evaluate(make_frame(n, v, glm::vec3(0, 1, 0)), l);
                    for (int c = 0; c < 3; ++c) {
                        ASSERT_TRUE(value.diffuse[c] >= 0 && value.diffuse[c] < 1e6f);
                        ASSERT_TRUE(value.specular[c] >= 0 && value.specular[c] < 1e6f);
                        if (glm::dot(n, l) <= 0) {
                            ASSERT_EQ(value.diffuse[c], 0.0f);
                            ASSERT_EQ(value.specular[c], 0.0f);
                        }
                    }
                }
            }
        }
    });
}

TEST(ReflectanceModels, AreFoundByTheirNames) {
    const auto names = reflectance_names();
    EXPECT_EQ(std::set(names.begin(), names.end()).size(), names.size());
    for (const std::string_view name : names) {
        const auto found = find_reflectance(name);
        ASSERT_TRUE(found) << name;
        const std::string_view model = std::visit([](const auto& m) { return std::string_view(m.name); }, *found);
        EXPECT_TRUE(name.starts_with(model)) << name << " is a " << model;
    }
    EXPECT_FALSE(find_reflectance("phlogiston"));
    EXPECT_TRUE(find_reflectance("measured")) << "one that needs data is found, not listed";
    EXPECT_EQ(std::ranges::count(names, "measured"), 0);
}

TEST(ReflectanceModels, HaveFormsByNamesOfTheirOwn) {
    const auto quarter = std::get<BlinnPhong>(*find_reflectance("blinn-phong-quarter"));
    Material material;
    material.shininess = 40;
    const auto bound = quarter.with_material(material);
    for (const double degrees : {5.0, 20.0, 40.0}) {
        const auto l = at_degrees(2 * degrees);  // h is at `degrees`
        EXPECT_NEAR(evaluate(bound, up, l, up).specular.x, std::pow(std::cos(degrees * 3.14159265358979 / 180), 10),
                    1e-5);
    }
    using Distribution = CookTorrance::Distribution;
    EXPECT_EQ(std::get<CookTorrance>(*find_reflectance("cook-torrance-gaussian")).distribution, Distribution::gaussian);
    EXPECT_EQ(std::get<CookTorrance>(*find_reflectance("cook-torrance")).distribution, Distribution::beckmann);
    EXPECT_EQ(std::get<CookTorrance>(*find_reflectance("cook-torrance-pi")).denominator, CookTorrance::Denominator::pi);
    EXPECT_EQ(std::get<Ward>(*find_reflectance("ward-1992")).form, Ward::Form::ward_1992);
}

TEST(ReflectanceModels, AreTheSameWhenChosenWhileRunning) {
    Random random(4);
    for_every_model([&](const auto& model) {
        for (int i = 0; i < 100; ++i) {
            const auto frame = make_frame(unit_vector(random), unit_vector(random), unit_vector(random));
            const glm::vec3 l = unit_vector(random);
            const auto direct = model.evaluate(frame, l), chosen = RuntimeModel{model}.evaluate(frame, l);
            ASSERT_EQ(0, std::memcmp(&direct, &chosen, sizeof direct));
        }
    });
}

TEST(Frame, HasUnitTangentsUprightOnTheNormalAndNoneAlongTheGrain) {
    Random random(5);
    for (int i = 0; i < 200; ++i) {
        const auto frame = make_frame(unit_vector(random), unit_vector(random), unit_vector(random));
        EXPECT_NEAR(glm::dot(frame.n, frame.t), 0, 2e-5);
        EXPECT_NEAR(glm::dot(frame.n, frame.b), 0, 1e-6);
        EXPECT_NEAR(glm::dot(frame.t, frame.b), 0, 1e-6);
        EXPECT_NEAR(glm::length(frame.t), 1, 1e-6);
    }
    EXPECT_EQ(make_frame(up, up, up).t, glm::vec3(0.0f));
    EXPECT_EQ(normalize_or_zero(glm::vec3(0.0f)), glm::vec3(0.0f));
}

}  // namespace
