// Measured tables: the file layout, baking a model and reading it back, principal components.
#include <cstring>

#include <gtest/gtest.h>
#include <raster/shading/measured_bake.h>

#include "shading_hemisphere.h"

namespace {

using namespace raster;
using namespace raster::testing;

constexpr MeasuredSize small{30, 30, 36};

Measured measured(MeasuredTable table) { return {std::make_shared<const MeasuredTable>(std::move(table))}; }

/// The largest difference of the two models, over the larger of the exact value and `floor`.
template <class A, class B>
double largest_difference(const A& exact, const B& other, float kd, float ks, double floor, float lowest = 0.15f) {
    Random random(1);
    double worst = 0;
    for (int i = 0; i < 5000; ++i) {
        const glm::vec3 l = direction_above(random.uniform(lowest, 1), random.uniform(0, 6.28f));
        const glm::vec3 v = direction_above(random.uniform(lowest, 1), random.uniform(0, 6.28f));
        const auto a = exact.evaluate(flat_frame(v), l), b = other.evaluate(flat_frame(v), l);
        for (int c = 0; c < 3; ++c) {
            const double expected = double(a.diffuse[c] * kd + a.specular[c] * ks);
            worst = std::max(worst, std::abs(double(b.diffuse[c]) - expected) / std::max(expected, floor));
        }
    }
    return worst;
}

TEST(HalfDifference, IsRusinkiewiczsRotations) {
    Random random(2);
    for (int i = 0; i < 2000; ++i) {
        const glm::vec3 l = direction_above(random.uniform(0.02f, 0.99f), random.uniform(0, 6.28f));
        const glm::vec3 v = direction_above(random.uniform(0.02f, 0.99f), random.uniform(0, 6.28f));
        const glm::dvec3 h = glm::normalize(glm::dvec3(l) + glm::dvec3(v));
        const double theta_h = std::acos(h.z), phi_h = std::atan2(h.y, h.x);
        // l turned by -phi_h about the normal, then by -theta_h about y.
        const double x = l.x * std::cos(-phi_h) - l.y * std::sin(-phi_h),
                     y = l.x * std::sin(-phi_h) + l.y * std::cos(-phi_h);
        const glm::dvec3 d(x * std::cos(-theta_h) + l.z * std::sin(-theta_h), y,
                           -x * std::sin(-theta_h) + l.z * std::cos(-theta_h));
        double phi_d = std::atan2(d.y, d.x);
        if (phi_d < 0) phi_d += 3.14159265358979;
        const auto at = half_difference(flat_frame(v), l);
        EXPECT_NEAR(at.theta_h, theta_h, 2e-6);
        EXPECT_NEAR(at.theta_d, std::acos(std::min(d.z, 1.0)), 1e-5);
        if (theta_h < 0.01 || std::hypot(d.x, d.y) < 0.01) continue;
        const double apart = std::abs(double(at.phi_d) - phi_d);
        EXPECT_LT(std::min(apart, 3.14159265358979 - apart), 2e-4);
    }
}

TEST(MeasuredFile, OfThreeCellsIsTheseBytes) {
    MeasuredTable table{{1, 1, 3}, {1, 2.0f / 1500, 2.3f / 1500, 3.32f / 1500, 0, 0, 0, 0, 1, 0, 0, 0}};
    const auto bytes = encode_measured(table);
    ASSERT_EQ(bytes.size(), 12u + 24 * 3);
    const auto number = [&](std::size_t at) {
        double value;
        std::memcpy(&value, bytes.data() + 12 + 8 * at, 8);
        return value;
    };
    EXPECT_EQ(int(bytes[0]), 1);
    EXPECT_EQ(int(bytes[8]), 3);
    EXPECT_NEAR(number(0), 2, 1e-6);  // red of the first cell
    EXPECT_EQ(number(1), -1);
    EXPECT_EQ(number(2), 0);
    EXPECT_NEAR(number(3), 2, 1e-6);  // green
    EXPECT_NEAR(number(6), 2, 1e-6);  // blue
    const auto back = decode_measured(bytes);
    ASSERT_TRUE(back);
    EXPECT_EQ(back->size, table.size);
    for (std::size_t i = 0; i < table.samples.size(); ++i) EXPECT_NEAR(back->samples[i], table.samples[i], 1e-9);
}

TEST(MeasuredFile, ThatIsBrokenIsAnError) {
    const auto bytes = encode_measured({{1, 2, 3}, std::vector<float>(24, 1.0f)});
    for (const std::size_t length : {std::size_t(0), std::size_t(11), std::size_t(12), bytes.size() - 1})
        EXPECT_FALSE(decode_measured(std::span(bytes).first(length))) << length;
    for (const unsigned size : {0u, 0x7fffffffu, 0xffffffffu, 4097u}) {
        auto broken = bytes;
        std::memcpy(broken.data() + 4, &size, 4);
        const auto table = decode_measured(broken);
        ASSERT_FALSE(table) << size;
        EXPECT_EQ(table.error().kind, ErrorKind::bad_input);
    }
    auto damaged = bytes;
    const double values[] = {std::nan(""), 1e300, -5};
    std::memcpy(damaged.data() + 12, values, sizeof values);
    const auto table = decode_measured(damaged);
    ASSERT_TRUE(table);
    EXPECT_EQ(table->samples[0], 0.0f);
    EXPECT_EQ(table->samples[4], 1.0f);
    EXPECT_EQ(table->samples[5], 1e6f);
    EXPECT_EQ(table->samples[8], 0.0f);
    EXPECT_FALSE(read_measured("/nonexistent/gold.binary"));
}

TEST(Measured, LambertBakedAndReadBackIsLambert) {
    const auto table = bake_measured(Lambert{}, {0.3f, 0.6f, 0.9f}, glm::vec3(0), small);
    const auto back = decode_measured(encode_measured(table));
    ASSERT_TRUE(back);
    const auto model = measured(*back);
    Random random(3);
    for (int i = 0; i < 2000; ++i) {
        const glm::vec3 l = direction_above(random.uniform(0.01f, 1), random.uniform(0, 6.28f));
        const glm::vec3 v = direction_above(random.uniform(0.01f, 1), random.uniform(0, 6.28f));
        const auto value = model.evaluate(flat_frame(v), l);
        for (int c = 0; c < 3; ++c) EXPECT_NEAR(value.diffuse[c], 0.3f * float(c + 1) * l.z, 1e-5f);
        EXPECT_EQ(value.specular, glm::vec3(0.0f));
    }
}

TEST(Measured, ModelsBakedAtTheFullSizeComeBackWithinTheirInterpolation) {
    EXPECT_LT(largest_difference(OrenNayar{0.5f}, measured(bake_measured(OrenNayar{0.5f}, glm::vec3(1), glm::vec3(0))),
                                 1, 0, 0.1),
              0.02);
    const CookTorrance metal{{{0.16f, 0.42f, 1.38f}, {3.6f, 2.47f, 1.92f}}, 0.3f};
    EXPECT_LT(largest_difference(metal, measured(bake_measured(metal, glm::vec3(0), glm::vec3(1))), 0, 1, 0.2), 0.05);
    const CookTorrance glossy{{}, 0.1f};
    EXPECT_LT(largest_difference(glossy, measured(bake_measured(glossy, glm::vec3(0.5f), glm::vec3(1))), 0.5f, 1, 0.2),
              0.05);
}

TEST(Measured, IsReciprocalAndBlackBelowTheHorizon) {
    const auto model = measured(bake_measured(TorranceSparrow{}, glm::vec3(0.5f), glm::vec3(0.5f), small));
    Random random(4);
    for (int i = 0; i < 1000; ++i) {
        const glm::vec3 l = direction_above(random.uniform(0.05f, 1), random.uniform(0, 6.28f));
        const glm::vec3 v = direction_above(random.uniform(0.05f, 1), random.uniform(0, 6.28f));
        const float there = model.evaluate(flat_frame(v), l).diffuse.x / l.z,
                    back = model.evaluate(flat_frame(l), v).diffuse.x / v.z;
        EXPECT_NEAR(there, back, 2e-4f * (1 + there));
        EXPECT_EQ(model.evaluate(flat_frame(v), glm::vec3(l.x, l.y, -l.z)).diffuse.x, 0.0f);
        EXPECT_EQ(model.evaluate(flat_frame({v.x, v.y, -v.z}), l).diffuse.x, 0.0f);
    }
}

TEST(Measured, GivesLanesExactlyWhatItGivesTheScalar) {
    using F = FloatPack<8>;
    const auto model = measured(bake_measured(CookTorrance{}, glm::vec3(0.5f), glm::vec3(0.5f), small));
    Random random(5);
    for (int round = 0; round < 200; ++round) {
        Frame<F> frame;
        vec<3, F> l;
        Frame<float> frames[8];
        glm::vec3 ls[8];
        for (int i = 0; i < 8; ++i) {
            frames[i] = make_frame(unit_vector(random), unit_vector(random), unit_vector(random));
            ls[i] = random.integer(0, 5) ? unit_vector(random) : frames[i].v;
            for (int c = 0; c < 3; ++c) {
                set_lane(frame.n[c], i, frames[i].n[c]);
                set_lane(frame.v[c], i, frames[i].v[c]);
                set_lane(l[c], i, ls[i][c]);
            }
        }
        const auto packed = model.evaluate(frame, l);
        for (int i = 0; i < 8; ++i)
            for (int c = 0; c < 3; ++c)
                ASSERT_EQ(bits_of(model.evaluate(frames[i], ls[i]).diffuse[c]), bits_of(lane(packed.diffuse[c], i)));
    }
}

TEST(Measured, WithoutATableIsBlack) {
    EXPECT_EQ(Measured{}.evaluate(flat_frame({0, 0, 1}), glm::vec3(0, 0, 1)).diffuse, glm::vec3(0.0f));
}

std::vector<MeasuredTable> set_of_tables() {
    std::vector<MeasuredTable> tables;
    for (const float m : {0.15f, 0.25f, 0.4f, 0.6f})
        for (const float kd : {0.1f, 0.5f, 0.9f})
            tables.push_back(bake_measured(CookTorrance{{}, m}, {kd, 0.5f, 1 - kd}, glm::vec3(0.8f), small));
    return tables;
}

TEST(MeasuredBasis, WithAllComponentsGivesEachTableBackAndWithFewerAnEverLargerError) {
    const auto tables = set_of_tables();
    const MeasuredBasis basis(tables);
    EXPECT_LE(basis.components(), tables.size() - 1);
    EXPECT_NEAR(basis.variance(basis.components()), 1, 1e-9);
    double errors[5] = {};
    const std::size_t counts[5] = {1, 2, 4, 8, basis.components()};
    for (const auto& table : tables) {
        const auto coefficients = basis.project(table);
        for (int i = 0; i < 5; ++i)
            errors[i] += relative_error(table, basis.reconstruct(coefficients, counts[i])) / double(tables.size());
    }
    for (int i = 1; i < 5; ++i) EXPECT_LE(errors[i], errors[i - 1] * 1.001) << i;
    EXPECT_GT(errors[0], 0.1);
    EXPECT_LT(errors[3], 0.05);
    EXPECT_LT(errors[4], 1e-3);
    for (std::size_t k = 1; k < basis.components(); ++k) EXPECT_GE(basis.variance(k + 1), basis.variance(k));
}

TEST(MeasuredBasis, OfEqualTablesHasNoComponents) {
    const auto table = bake_measured(Lambert{}, glm::vec3(0.5f), glm::vec3(0), {4, 4, 4});
    const std::vector<MeasuredTable> tables(3, table);
    const MeasuredBasis basis(tables);
    EXPECT_EQ(basis.components(), 0u);
    EXPECT_LT(relative_error(table, basis.reconstruct(basis.project(table), 4)), 1e-5);
}

TEST(RelativeError, OfHalfTheValueIsOneHalf) {
    const auto a = bake_measured(Lambert{}, glm::vec3(0.8f), glm::vec3(0), small);
    const auto b = bake_measured(Lambert{}, glm::vec3(0.4f), glm::vec3(0), small);
    EXPECT_NEAR(relative_error(a, b), 0.5, 1e-5);
    EXPECT_EQ(relative_error(a, a), 0.0);
}

}  // namespace
