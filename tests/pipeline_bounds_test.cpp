// No input leaves the fixed-point range, the viewport or the target.
#include <gtest/gtest.h>

#include "pipeline_testing.h"

namespace {

using namespace raster;
using namespace raster::testing;

/// Checks what goes into fixed point.
struct Bounds {
    std::int64_t pieces = 0;
    void on(const ProjectEvent& e) {
        ++pieces;
        for (const auto& w : e.window) {
            ASSERT_LT(std::abs(w.x), 32768.0f);
            ASSERT_LT(std::abs(w.y), 32768.0f);
            ASSERT_TRUE(std::isfinite(w.z) && std::isfinite(w.oow));
        }
        for (const auto& s : e.subpixel) {
            ASSERT_LT(std::abs(s.x), 1 << 23);
            ASSERT_LT(std::abs(s.y), 1 << 23);
        }
    }
};

void draw_wild(const Viewport& viewport, std::uint64_t number) {
    Random random(seed(number));
    Target target(9, 7);
    State state;
    state.viewport = viewport;
    Bounds bounds;
    for (int round = 0; round < 2000; ++round) {
        Vertices vertices;
        for (int i = 0; i < 10; ++i) add_triangle(vertices, make_triangle(Group::wild, random, 9, 7), random);
        if (round % 2)  // any floats at all
            for (auto& v : vertices)
                for (int i = 0; i < 4; ++i) v.position[i] = as_float(std::int32_t(std::uint32_t(random.bits())));
        draw(target, Smooth{}, Mesh(vertices), state, bounds);
        draw(target, Smooth{}, Mesh(vertices), state);
        if (::testing::Test::HasFailure()) return;
    }
    EXPECT_GT(bounds.pieces, 1000);
}

TEST(Bounds, AnyNumbersStayInFixedPoint) { draw_wild({}, 1); }
TEST(Bounds, AlsoInTheLargestViewport) { draw_wild({-16384, -16384, 32768, 32768}, 2); }
TEST(Bounds, AlsoInAViewportAtTheFarEnd) { draw_wild({16383, 16383, 1, 1}, 3); }

TEST(Bounds, NothingIsDrawnOutsideTheViewport) {
    Random random(seed(4));
    for (int round = 0; round < 200; ++round) {
        Target target(60, 50), fast(60, 50);
        State state;
        state.depth_compare = Compare::always;
        const int x = random.integer(-10, 50), y = random.integer(-10, 40), width = random.integer(1, 40);
        state.viewport = {x, y, width, random.integer(1, 40)};
        Vertices vertices;
        for (int i = 0; i < 20; ++i) {
            const auto group = Group(random.integer(0, int(Group::collinear)));
            add_triangle(vertices, make_triangle(group, random, width, state.viewport.height), random);
        }
        for (auto& v : vertices) v.color = glm::vec4(1);
        draw(target, Smooth{}, Mesh(vertices), state, NoObserver{});
        draw(fast, Smooth{}, Mesh(vertices), state);
        for (int row = 0; row < 50; ++row)
            for (int column = 0; column < 60; ++column) {
                const bool inside = column >= x && column < x + width && row >= y && row < y + state.viewport.height;
                if (inside) continue;
                ASSERT_EQ(target.color8()[target.index(column, row)], 0u);
                ASSERT_EQ(fast.color8()[target.index(column, row)], 0u);
            }
    }
}

TEST(Bounds, AWholeViewportIsFilledToTheLastPixel) {
    for (const auto fill : {FillRule::bottom_left, FillRule::top_left})
        for (const Viewport& v : {Viewport{0, 0, 64, 64}, Viewport{3, 5, 17, 31}, Viewport{60, 60, 4, 4}}) {
            Vertices vertices;
            for (const glm::vec4& p :
                 {glm::vec4(-1, -1, 0, 1), glm::vec4(1, -1, 0, 1), glm::vec4(-1, 1, 0, 1), glm::vec4(1, 1, 0, 1)})
                vertices.push_back({p, glm::vec4(1.0f / 255), {}});
            State state;
            state.topology = Topology::triangle_strip;
            state.viewport = v;
            state.fill_rule = fill;
            state.blend = Blend::additive;
            state.depth_compare = Compare::always;
            Target target(64, 64);
            draw(target, Smooth{}, Mesh(vertices), state);
            for (int y = 0; y < 64; ++y)
                for (int x = 0; x < 64; ++x) {
                    const bool inside = x >= v.x && x < v.x + v.width && y >= v.y && y < v.y + v.height;
                    ASSERT_EQ(target.color8()[target.index(x, y)], inside ? 0x01010101u : 0u) << x << " " << y;
                }
        }
}

}  // namespace
