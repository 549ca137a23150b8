// Stage 9: smooth, noperspective and flat varyings at a pixel.
#include <raster/stages/interpolate.h>

#include <cmath>

#include <gtest/gtest.h>

#include "scenes.h"

namespace {

using namespace raster;
using raster::testing::Group;
using raster::testing::Random;

/// One varying of each kind.
struct Kinds {
    template <class F>
    struct Vertex {
        vec<4, F> position;
    };
    template <class F>
    struct Varyings {
        F smooth, affine, flat;
    };
    static constexpr Interpolation interpolation(int i) { return Interpolation(i); }
    template <class F>
    VertexOut<F, Varyings> vertex(const Vertex<F>& v) const {
        return {v.position, {F(0), F(0), F(0)}};
    }
};
using Values = VaryingArray<Kinds, float>;

struct Made {
    std::array<WindowVertex<float>, 3> window;
    VaryingPlanes<Kinds, float> planes;
};
Made make(const raster::testing::Corners& clip, const std::array<Values, 3>& values, int width, int height) {
    const ViewportTransform viewport(Viewport{0, 0, width, height});
    Made m;
    for (std::size_t i = 0; i < 3; ++i) m.window[i] = project(clip[i], viewport);
    const auto& w = m.window;
    m.planes = make_varying_planes<Kinds, float>(make_plane_basis(w[0], w[1], w[2]),
                                                 {&values[0], &values[1], &values[2]}, {w[0].oow, w[1].oow, w[2].oow});
    return m;
}

static_assert(interpolation_of<Kinds>(0) == Interpolation::smooth);
static_assert(interpolation_of<Kinds>(1) == Interpolation::noperspective);
static_assert(interpolation_of<Kinds>(2) == Interpolation::flat);

TEST(Interpolate, HalfwayInTheWindowIsNotHalfwayInSpace) {
    // Along the bottom, w goes from 1 to 3. Halfway in the window 1/w is 2/3, and the point is a quarter of the way.
    const raster::testing::Corners clip = {{{-1, -1, 0, 1}, {3, -3, 0, 3}, {-1, 1, 0, 1}}};
    const Made m = make(clip, {{{0, 0, 7}, {1, 1, 8}, {0, 0, 9}}}, 65, 65);
    const Values v = interpolate<Kinds, float>(m.planes, 32, 64.5f);
    EXPECT_NEAR(v[0], 0.25, 1e-6);
    EXPECT_NEAR(v[1], 0.5, 1e-6);
    EXPECT_EQ(v[2], 9) << "the last corner's";
    EXPECT_NEAR(value_at(m.planes.oow, 32.0f, 64.5f), 2.0 / 3, 1e-6);
}

TEST(Interpolate, WithEqualDepthsSmoothIsLinear) {
    const raster::testing::Corners clip = {{{-1, -1, 0, 1}, {1, -1, 0, 1}, {-1, 1, 0, 1}}};
    const Made m = make(clip, {{{1, 1, 0}, {5, 5, 0}, {3, 3, 0}}}, 64, 64);
    for (int x = 0; x < 64; x += 7) {
        const Values v = interpolate<Kinds, float>(m.planes, float(x), 40);
        EXPECT_NEAR(v[0], v[1], 1e-5);
        EXPECT_NEAR(v[0], 1 + 4 * (float(x) + 0.5) / 64 + 2 * 23.5 / 64, 1e-5);
    }
}

TEST(Interpolate, FlatIsTheLastCornersEverywhere) {
    Random random(1);
    for (int round = 0; round < 1000; ++round) {
        const auto clip = make_triangle(Group::perspective, random, 64, 64);
        const float flat = random.uniform(-9, 9);
        const Made m = make(clip, {{{0, 0, 1}, {0, 0, 2}, {0, 0, flat}}}, 64, 64);
        const Values v = interpolate<Kinds, float>(m.planes, float(random.integer(0, 63)), 5);
        ASSERT_EQ(v[2], flat);
    }
}

/// A constant varying: exact when noperspective. Smooth ones are divided by w, interpolated and multiplied by w again, so
/// that rounding shows, the more the greater the range of w: seen were 201 units of 2^-24 in triangles of more than 1000
/// pixels with w from 1/4 to 8.
TEST(Interpolate, AConstantStaysConstantWithinRounding) {
    Random random(2);
    double worst = 0;
    for (int round = 0; round < 100000; ++round) {
        const auto clip = make_triangle(Group::perspective, random, 256, 256);
        const float c = random.uniform(0.5f, 1);
        const Made m = make(clip, {{{c, c, c}, {c, c, c}, {c, c, c}}}, 256, 256);
        const auto& w = m.window;
        // A random point inside, away from corners.
        const float a = random.uniform(0.1f, 0.45f), b = random.uniform(0.1f, 0.45f);
        const float x = std::floor(w[0].x * a + w[1].x * b + w[2].x * (1 - a - b));
        const float y = std::floor(w[0].y * a + w[1].y * b + w[2].y * (1 - a - b));
        const Values v = interpolate<Kinds, float>(m.planes, x, y);
        ASSERT_EQ(v[1], c);
        ASSERT_EQ(v[2], c);
        const double area = double(w[1].x - w[0].x) * (w[2].y - w[0].y) - double(w[1].y - w[0].y) * (w[2].x - w[0].x);
        if (std::abs(area) > 2000) worst = std::max(worst, std::abs(double(v[0]) - c) / std::ldexp(1.0, -24));
    }
    EXPECT_LE(worst, 512);
    EXPECT_GT(worst, 0) << "smooth constants were never off by anything: is this interpolation at all?";
}

TEST(Interpolate, ValuesAreThoseOfTheRayThroughThePixel) {
    // Against solving for the point in clip space in double.
    Random random(3);
    for (int round = 0; round < 20000; ++round) {
        const auto clip = make_triangle(Group::perspective, random, 128, 128);
        const Values v0 = {random.uniform(-1, 1), 0, 0}, v1 = {random.uniform(-1, 1), 0, 0}, v2 = {0.5f, 0, 0};
        const Made m = make(clip, {{v0, v1, v2}}, 128, 128);
        const auto& w = m.window;
        const double area = double(w[1].x - w[0].x) * (w[2].y - w[0].y) - double(w[1].y - w[0].y) * (w[2].x - w[0].x);
        if (std::abs(area) < 500) continue;
        const float a = random.uniform(0, 0.5f), b = random.uniform(0, 0.5f);
        const float x = std::floor(w[0].x * a + w[1].x * b + w[2].x * (1 - a - b));
        const float y = std::floor(w[0].y * a + w[1].y * b + w[2].y * (1 - a - b));
        // Barycentric coordinates in the window, then divided by w each.
        const auto cross = [&](std::size_t i, std::size_t j) {
            return (w[i].x - (x + 0.5)) * (w[j].y - (y + 0.5)) - (w[i].y - (y + 0.5)) * (w[j].x - (x + 0.5));
        };
        const double k[3] = {cross(1, 2) * w[0].oow, cross(2, 0) * w[1].oow, cross(0, 1) * w[2].oow};
        const double exact = (k[0] * v0[0] + k[1] * v1[0] + k[2] * v2[0]) / (k[0] + k[1] + k[2]);
        ASSERT_NEAR((interpolate<Kinds, float>(m.planes, x, y)[0]), exact, 3e-3);
    }
}

TEST(Interpolate, LanesInterpolateAsScalars) {
    using F = FloatPack<8>;
    Random random(4);
    for (int round = 0; round < 2000; ++round) {
        const auto clip = make_triangle(Group::perspective, random, 128, 128);
        const Values v = {random.uniform(-1, 1), random.uniform(-1, 1), 3};
        const Made m = make(clip, {{v, {1, 2, 3}, {4, 5, 6}}}, 128, 128);
        VaryingPlanes<Kinds, F> planes;
        const auto widen = [](const Plane<float>& p) { return Plane<F>{F(p.origin), F(p.dadx), F(p.dady)}; };
        for (std::size_t i = 0; i < 3; ++i) planes.planes[i] = widen(m.planes.planes[i]);
        planes.oow = widen(m.planes.oow);
        const F x = F(float(random.integer(0, 100))) + to_float(lane_index<F>());
        const float y = float(random.integer(0, 127));
        const auto pack = interpolate<Kinds, F>(planes, x, F(y));
        for (int l = 0; l < 8; ++l) {
            const Values one = interpolate<Kinds, float>(m.planes, lane(x, l), y);
            for (std::size_t i = 0; i < 3; ++i) ASSERT_EQ(lane(pack[i], l), one[i]);
        }
    }
}

}  // namespace
