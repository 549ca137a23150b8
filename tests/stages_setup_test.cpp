// Stage 6: edge functions are exact, planes go through the corners, boxes leave nothing out.
#include <raster/stages/setup.h>

#include <gtest/gtest.h>

#include "scenes.h"

namespace {

using namespace raster;
using raster::testing::Group;
using raster::testing::Random;
using Triangle = std::array<SubpixelVertex<float>, 3>;
using Window = std::array<WindowVertex<float>, 3>;

Triangle random_triangle(Random& random, int range) {
    Triangle t;
    for (auto& v : t) v.x = random.integer(-range, range), v.y = random.integer(-range, range);
    return t;
}
Window random_window(Random& random) {
    const ViewportTransform viewport(Viewport{0, 0, 300, 200});
    Window window;
    const auto corners = make_triangle(Group::perspective, random, 300, 200);
    for (std::size_t i = 0; i < 3; ++i) window[i] = project(corners[i], viewport);
    return window;
}
double exact_value(const Plane<float>& p, double x, double y) { return p.origin + p.dadx * x + p.dady * y; }

TEST(Setup, AnEdgeIsZeroOnItsLineAndPositiveToItsLeft) {
    // Down the picture: the left hand points to larger x.
    const auto down = make_edge<float>({0, 0}, {0, 512}, FillRule::bottom_left);
    EXPECT_EQ(down.origin, 0);
    EXPECT_EQ(down.step_x, 512);
    EXPECT_EQ(down.step_y, 0);
    const auto slanted = make_edge<float>({256, 512}, {1024, 256}, FillRule::bottom_left);
    const auto at = [&](int x, int y) { return slanted.origin + slanted.step_x * x + slanted.step_y * y; };
    EXPECT_EQ(at(256, 512), 0);
    EXPECT_EQ(at(1024, 256), 0);
    EXPECT_EQ(at(640, 384), 0);
    EXPECT_GT(at(256, 256), 0) << "above an edge that goes right";
}

TEST(Setup, LeftEdgesOwnTheirPointsAndTheRuleChoosesBetweenTopAndBottom) {
    const auto owns = [](int dx, int dy, FillRule rule) { return make_edge<float>({0, 0}, {dx, dy}, rule).inclusive; };
    for (const auto rule : {FillRule::bottom_left, FillRule::top_left}) {
        for (const int dx : {-5, 0, 5}) {
            EXPECT_TRUE(owns(dx, 1, rule)) << "goes down: a left edge";
            EXPECT_FALSE(owns(dx, -1, rule)) << "goes up: a right edge";
        }
    }
    EXPECT_TRUE(owns(1, 0, FillRule::bottom_left)) << "goes right: a bottom edge";
    EXPECT_FALSE(owns(-1, 0, FillRule::bottom_left));
    EXPECT_TRUE(owns(-1, 0, FillRule::top_left)) << "goes left: a top edge";
    EXPECT_FALSE(owns(1, 0, FillRule::top_left));
}

TEST(Setup, AnEdgeAndItsReverseOwnEachPointOnce) {
    Random random(1);
    for (int round = 0; round < 10000; ++round) {
        const Triangle t = random_triangle(random, 3);
        if (t[0].x == t[1].x && t[0].y == t[1].y) continue;
        for (const auto rule : {FillRule::bottom_left, FillRule::top_left})
            ASSERT_NE(make_edge(t[0], t[1], rule).inclusive, make_edge(t[1], t[0], rule).inclusive);
    }
}

TEST(Setup, TheThreeEdgesAddUpToTheArea) {
    Random random(2);
    for (int round = 0; round < 10000; ++round) {
        const Triangle t = random_triangle(random, 1 << 22);
        const std::int64_t area = signed_area(t);
        std::int64_t origin = 0, step_x = 0, step_y = 0;
        for (std::size_t i = 0; i < 3; ++i) {
            const auto e = make_edge(t[i], t[(i + 1) % 3], FillRule::bottom_left);
            origin += e.origin, step_x += e.step_x, step_y += e.step_y;
            // The third corner's value is the area, exactly, however large.
            const auto& c = t[(i + 2) % 3];
            ASSERT_EQ(e.origin + std::int64_t(e.step_x) * c.x + std::int64_t(e.step_y) * c.y, area);
        }
        ASSERT_EQ(origin, area);
        ASSERT_EQ(step_x, 0);
        ASSERT_EQ(step_y, 0);
    }
}

TEST(Setup, CornersZeroAndOneAreExchangedWhenClockwise) {
    EXPECT_EQ(setup_order(5), (std::array{0, 1, 2}));
    EXPECT_EQ(setup_order(-5), (std::array{1, 0, 2})) << "the provoking corner stays the last";
}

TEST(Setup, APlaneGoesThroughItsCorners) {
    Random random(3);
    int checked = 0;
    for (int round = 0; round < 10000; ++round) {
        const Window w = random_window(random);
        const double area = double(w[1].x - w[0].x) * (w[2].y - w[0].y) - double(w[1].y - w[0].y) * (w[2].x - w[0].x);
        if (std::abs(area) < 500) continue;  // slivers magnify rounding
        ++checked;
        const float a[3] = {random.uniform(-1, 1), 0.5f, random.uniform(-1, 1)};
        const auto plane = make_plane(make_plane_basis(w[0], w[1], w[2]), a[0], a[1], a[2]);
        for (std::size_t i = 0; i < 3; ++i)
            ASSERT_NEAR(exact_value(plane, double(w[i].x) - 0.5, double(w[i].y) - 0.5), a[i], 2e-3) << area;
    }
    EXPECT_GT(checked, 5000);
}

TEST(Setup, APlaneWithKnownSlopes) {
    // a = 3 + x / 2 - y / 4 at pixel centres.
    const auto at = [](float x, float y) { return 3 + x / 2 - y / 4; };
    const WindowVertex<float> v0{8.5f, 4.5f, 0, 1}, v1{24.5f, 4.5f, 0, 1}, v2{8.5f, 36.5f, 0, 1};
    const auto plane = make_plane(make_plane_basis(v0, v1, v2), at(8, 4), at(24, 4), at(8, 36));
    EXPECT_EQ(plane.dadx, 0.5f);
    EXPECT_EQ(plane.dady, -0.25f);
    EXPECT_EQ(plane.origin, 3.0f);
    EXPECT_EQ(value_at(plane, 10.0f, 20.0f), 3.0f);
}

TEST(Setup, AConstantStaysConstantToTheBit) {
    Random random(4);
    for (int round = 0; round < 20000; ++round) {
        const Window w = random_window(random);
        const float a = random.uniform(-100, 100);
        const auto plane = make_plane(make_plane_basis(w[0], w[1], w[2]), a, a, a);
        const auto x = float(random.integer(0, 299));
        ASSERT_EQ(value_at(plane, x, float(random.integer(0, 199))), a);
    }
}

TEST(Setup, BoxesHoldThePixelsWhoseCentresAreInThem) {
    const auto box = [](int x0, int y0, int x1, int y1) {
        return bounding_pixels(Triangle{{{x0, y0}, {x1, y0}, {x0, y1}}}, 100, 80);
    };
    const auto same = [](const PixelBox& b, int x0, int y0, int x1, int y1) {
        return b.min_x == x0 && b.min_y == y0 && b.max_x == x1 && b.max_y == y1;
    };
    EXPECT_TRUE(same(box(0, 0, 256, 512), 0, 0, 1, 2)) << "centres on the border are in";
    EXPECT_TRUE(same(box(1, 1, 255, 511), 1, 1, 0, 1));
    EXPECT_TRUE(box(1, 1, 255, 511).empty());
    EXPECT_TRUE(same(box(-9999, -9999, 99999, 99999), 0, 0, 99, 79)) << "cut at the target";
    EXPECT_TRUE(box(-5000, 0, -257, 512).empty());
    EXPECT_TRUE(box(100 * 256, 0, 120 * 256, 512).empty());
    EXPECT_TRUE(same(box(-256, -1, 0, 1), 0, 0, 0, 0));
}

TEST(Setup, LanesAreSetUpAsScalars) {
    using F = FloatPack<8>;
    Random random(5);
    for (int round = 0; round < 1000; ++round) {
        Window windows[8];
        Triangle snapped[8];
        std::array<WindowVertex<F>, 3> window;
        std::array<SubpixelVertex<F>, 3> subpixel;
        for (int l = 0; l < 8; ++l) {
            windows[l] = random_window(random);
            snapped[l] = random_triangle(random, 1 << 14);  // so that products fit 32 bits
            for (std::size_t i = 0; i < 3; ++i) {
                window[i].x.v[l] = windows[l][i].x, window[i].y.v[l] = windows[l][i].y;
                window[i].z.v[l] = windows[l][i].z, window[i].oow.v[l] = windows[l][i].oow;
                subpixel[i].x.v[l] = snapped[l][i].x, subpixel[i].y.v[l] = snapped[l][i].y;
            }
        }
        const auto rule = FillRule(random.integer(0, 1));
        const Edge<F> edge = make_edge(subpixel[0], subpixel[1], rule);
        const Plane<F> plane =
            make_plane(make_plane_basis(window[0], window[1], window[2]), window[0].z, window[1].z, window[2].z);
        for (int l = 0; l < 8; ++l) {
            const Window& w = windows[l];
            const Edge<float> e = make_edge(snapped[l][0], snapped[l][1], rule);
            ASSERT_EQ(lane(edge.step_x, l), e.step_x);
            ASSERT_EQ(lane(edge.step_y, l), e.step_y);
            ASSERT_EQ(lane(edge.origin, l), e.origin);
            ASSERT_EQ(lane(edge.inclusive, l), e.inclusive);
            const Plane<float> p = make_plane(make_plane_basis(w[0], w[1], w[2]), w[0].z, w[1].z, w[2].z);
            ASSERT_EQ(lane(plane.origin, l), p.origin);
            ASSERT_EQ(lane(plane.dadx, l), p.dadx);
            ASSERT_EQ(lane(plane.dady, l), p.dady);
            ASSERT_EQ(lane(value_at(plane, F(7.0f), F(9.0f)), l), value_at(p, 7.0f, 9.0f));
        }
    }
}

TEST(Setup, ItIsMadeOfTheCornersInTheirOrder) {
    const ViewportTransform viewport(Viewport{0, 0, 64, 64});
    Window window;
    Triangle subpixel;
    const glm::vec4 corners[3] = {{-0.5f, -0.5f, 0, 1}, {0, 0.5f, 0.5f, 1}, {0.5f, -0.5f, 1, 1}};  // clockwise
    for (std::size_t i = 0; i < 3; ++i) window[i] = project(corners[i], viewport), subpixel[i] = snap(window[i]);
    const std::int64_t area = signed_area(subpixel);
    EXPECT_LT(area, 0);
    const TriangleSetup s = make_setup(window, subpixel, area, FillRule::top_left, 64, 64);
    EXPECT_EQ(s.order, (std::array{1, 0, 2}));
    const auto first = make_edge(subpixel[1], subpixel[0], FillRule::top_left);
    EXPECT_EQ(s.edges[0].step_x, first.step_x);
    EXPECT_EQ(s.edges[0].origin, first.origin);
    EXPECT_NEAR(value_at(s.depth, 32.0f - 0.5f, 48.0f - 0.5f), 0.75, 1e-6) << "between corners 0 and 2";
}

}  // namespace
