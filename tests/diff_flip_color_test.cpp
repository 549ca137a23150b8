// diff_flip_color_test.cpp: the colours and errors of FLIP: rows have the bits of single pixels.
#include <raster/image/flip_color.h>
#include <raster/image/flip_rows.h>
#include <raster/image/metrics_display.h>
#include <raster/image/metrics_rows.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "random.h"

namespace {

using namespace raster::flip;
using raster::testing::Random;

TEST(FlipColor, TheCubeRootIsRightToThreeInTenMillion) {
    Random random(28);
    for (int i = 0; i < 100000; ++i) {
        const float x = std::ldexp(random.uniform(1, 8), random.integer(-60, 60));
        EXPECT_NEAR(cube_root(x) / std::cbrt(double(x)), 1.0, 5e-7) << x;
    }
}

TEST(FlipColor, RowsHaveTheBitsOfSinglePixels) {
    Random random(30);
    constexpr int count = 64;
    std::array<float, count> r, g, b, y, red_green, blue_yellow;
    for (int i = 0; i < count; ++i) {
        const std::size_t k = std::size_t(i);
        // Beyond what a screen shows too, as filters make them.
        r[k] = random.uniform(-0.1f, 1.1f), g[k] = random.uniform(-0.1f, 1.1f), b[k] = random.uniform(-0.1f, 1.1f);
    }
    opponent_colors({r.data(), g.data(), b.data()}, count,
                                  {y.data(), red_green.data(), blue_yellow.data()});
    auto l = y, lab_a = red_green, lab_b = blue_yellow;
    seen_colors({l.data(), lab_a.data(), lab_b.data()}, count);
    for (std::size_t k = 0; k < count; ++k) {
        const auto opponent = opponent_from_rgb(Rgb<float>{r[k], g[k], b[k]});
        EXPECT_EQ(y[k], opponent.y);
        EXPECT_EQ(red_green[k], opponent.red_green);
        EXPECT_EQ(blue_yellow[k], opponent.blue_yellow);
        const auto lab = hunt_lab_from_rgb(clamped_rgb_from_opponent(opponent));
        EXPECT_EQ(l[k], lab.l);
        EXPECT_EQ(lab_a[k], lab.a);
        EXPECT_EQ(lab_b[k], lab.b);
    }
}

TEST(FlipColor, BytesHaveTheBitsOfTheirLinearLight) {
    Random random(31);
    constexpr int count = 64;
    const float* const linear_of = raster::linear_of_bytes();
    std::array<std::uint8_t, 3 * count> bytes;
    std::array<float, count> y, red_green, blue_yellow;
    for (auto& byte : bytes) byte = std::uint8_t(random.integer(0, 255));
    opponent_colors_of_bytes(bytes.data(), count, {y.data(), red_green.data(), blue_yellow.data()});
    for (std::size_t k = 0; k < count; ++k) {
        const std::uint8_t* const c = bytes.data() + 3 * k;
        const auto one = opponent_from_rgb(Rgb<float>{linear_of[c[0]], linear_of[c[1]], linear_of[c[2]]});
        EXPECT_EQ(y[k], one.y);
        EXPECT_EQ(red_green[k], one.red_green);
        EXPECT_EQ(blue_yellow[k], one.blue_yellow);
    }
}

/// A row of colours and features, as filters make them; some equal in both rows of a pair.
struct RandomRow {
    static constexpr int count = 256;
    std::array<std::vector<float>, 7> planes;

    explicit RandomRow(Random& random) {
        for (std::size_t p = 0; p < planes.size(); ++p)
            for (int i = 0; i < count; ++i)
                planes[p].push_back(i % 16 == 0 ? 0.25f
                                    : p < 3     ? random.uniform(-60, 60)
                                                : random.uniform(-0.6f, 0.6f));
    }
    SeenRow row() {
        return {{planes[0].data(), planes[1].data(), planes[2].data()},
                planes[3].data(), planes[4].data(), planes[5].data(), planes[6].data()};
    }
};

TEST(FlipColor, RowsOfErrorsHaveTheBitsOfSingleErrors) {
    Random random(32);
    constexpr int count = RandomRow::count;
    RandomRow e(random), a(random);
    std::vector<float> errors(count), scratch(2 * count);
    errors_between(e.row(), a.row(), count, errors.data(), scratch.data());
    const ErrorCurve curve;
    int beyond = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const auto length = [&](const RandomRow& of, std::size_t x) {
            return std::sqrt(of.planes[x][i] * of.planes[x][i] + of.planes[x + 1][i] * of.planes[x + 1][i]);
        };
        const float edges = std::abs(length(e, 3) - length(a, 3)), points = std::abs(length(e, 5) - length(a, 5));
        const float exponent = std::max(1.0f - std::sqrt(std::max(edges, points) * 0.707106781f), 0.0f);
        const auto lab = [&](const RandomRow& of) {
            return HuntLab<float>{of.planes[0][i], of.planes[1][i], of.planes[2][i]};
        };
        const float distance = hyab(lab(e), lab(a));
        beyond += distance > 40;
        EXPECT_EQ(errors[i], curve.to_power(distance, exponent)) << distance << " " << exponent;
    }
    EXPECT_GT(beyond, 10);
    EXPECT_LT(beyond, count - 30);
}

TEST(FlipColor, OpponentColoursGoThereAndBack) {
    Random random(29);
    for (int i = 0; i < 1000; ++i) {
        const Rgb<float> c = {random.uniform(0, 1), random.uniform(0, 1), random.uniform(0, 1)};
        const auto back = clamped_rgb_from_opponent(opponent_from_rgb(c));
        EXPECT_NEAR(back.r, c.r, 2e-6f);
        EXPECT_NEAR(back.g, c.g, 2e-6f);
        EXPECT_NEAR(back.b, c.b, 2e-6f);
    }
}

}  // namespace
