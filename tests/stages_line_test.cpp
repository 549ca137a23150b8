// Lines and points by closed forms: which pixels, which values.
#include <raster/stages/line.h>
#include <raster/stages/point.h>

#include <string>

#include <gtest/gtest.h>

#include "random.h"

namespace {

using namespace raster;
using raster::testing::Random;

constexpr int size = 12;
using Window = WindowVertex<float>;

Window at(float x, float y, float z = 0) { return {x, y, z, 1}; }

std::vector<int> covered(const Window& a, const Window& b, int width = 1, FillRule rule = FillRule::bottom_left) {
    std::vector<int> counts(size * size);
    const auto setup = make_line_setup(a, b, width, rule, size, size);
    if (!setup) return counts;
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x) {
            bool inside = true;
            for (const auto& edge : setup->edges) inside = inside && is_inside(edge, edge_at(edge, x, y));
            const PixelBox& box = setup->box;
            const bool in_box = x >= box.min_x && x <= box.max_x && y >= box.min_y && y <= box.max_y;
            EXPECT_TRUE(in_box || !inside);
            counts[std::size_t(y * size + x)] = inside;
        }
    return counts;
}
std::string drawing(const std::vector<int>& counts, int columns, int rows) {
    std::string text;
    for (int y = 0; y < rows; ++y, text += '\n')
        for (int x = 0; x < columns; ++x) text += counts[std::size_t(y * size + x)] ? '#' : '.';
    return text;
}
int count(const std::vector<int>& counts) {
    int n = 0;
    for (const int c : counts) n += c;
    return n;
}

TEST(Line, ARowFromCentreToCentreLeavesOutItsLastPixel) {
    EXPECT_EQ(drawing(covered(at(1.5f, 1.5f), at(4.5f, 1.5f)), 6, 3), "......\n.###..\n......\n");
    EXPECT_EQ(drawing(covered(at(4.5f, 1.5f), at(1.5f, 1.5f)), 6, 3), "......\n..###.\n......\n");
}

TEST(Line, AColumnFromCentreToCentreLeavesOutItsLastPixel) {
    EXPECT_EQ(drawing(covered(at(1.5f, 1.5f), at(1.5f, 4.5f)), 3, 6), "...\n.#.\n.#.\n.#.\n...\n...\n");
    EXPECT_EQ(drawing(covered(at(1.5f, 4.5f), at(1.5f, 1.5f)), 3, 6), "...\n...\n.#.\n.#.\n.#.\n...\n");
}

TEST(Line, ADiagonalHasOnePixelAColumn) {
    EXPECT_EQ(drawing(covered(at(0.5f, 0.5f), at(4.5f, 4.5f)), 5, 5), "#....\n.#...\n..#..\n...#.\n.....\n");
}

TEST(Line, WidthIsAlongTheMinorAxis) {
    EXPECT_EQ(drawing(covered(at(1.5f, 2.5f), at(4.5f, 2.5f), 3), 6, 5), "......\n.###..\n.###..\n.###..\n......\n");
    EXPECT_EQ(count(covered(at(1.5f, 5.5f), at(9.5f, 6.5f), 4)), 8 * 4);
}

TEST(Line, OneWithoutLengthIsNone) {
    EXPECT_FALSE(make_line_setup(at(3, 3), at(3, 3), 1, FillRule::bottom_left, 9, 9));
}

TEST(Line, OneInsideADiamondDrawsNothing) {
    EXPECT_EQ(count(covered(at(2.4f, 2.5f), at(2.6f, 2.5f))), 0) << "it does not leave the diamond";
    EXPECT_EQ(count(covered(at(2.5f, 2.5f), at(3.2f, 2.5f))), 1) << "it leaves one and enters none";
}

TEST(Line, ConnectedSegmentsDrawEachPixelOnce) {
    // The diamond-exit rule: a polyline along one direction is drawn as one line would be.
    Random random(1);
    for (int round = 0; round < 2000; ++round) {
        const auto coordinate = [&] { return float(random.integer(0, 64 * size)) / 64.0f; };
        const float x0 = coordinate(), x2 = coordinate(), y = coordinate(), t = random.uniform(0, 1);
        const float x1 = std::floor((x0 + (x2 - x0) * t) * 64) / 64;
        const auto whole = covered(at(x0, y), at(x2, y)), first = covered(at(x0, y), at(x1, y));
        const auto second = covered(at(x1, y), at(x2, y));
        for (std::size_t i = 0; i < whole.size(); ++i)
            ASSERT_EQ(first[i] + second[i], whole[i]) << x0 << " " << x1 << " " << x2 << " " << y;
    }
}

TEST(Line, ALineHasAsManyPixelsAColumnAsItIsWide) {
    Random random(2);
    for (int round = 0; round < 3000; ++round) {
        const float x0 = random.uniform(-5, 17), y0 = random.uniform(4, 8), x1 = random.uniform(-5, 17);
        const float y1 = y0 + (x1 - x0) * random.uniform(-0.2f, 0.2f);
        const int width = random.integer(1, 3);
        const auto counts = covered(at(x0, y0), at(x1, y1), width);
        for (int x = 0; x < size; ++x) {
            int column = 0;
            for (int y = 0; y < size; ++y) column += counts[std::size_t(y * size + x)];
            ASSERT_TRUE(column == 0 || column == width) << round;
        }
    }
}

TEST(Line, ValuesGoLinearlyFromEndToEnd) {
    const auto setup = make_line_setup(at(0.5f, 0.5f, 0.25f), at(8.5f, 4.5f, 0.75f), 1, FillRule::bottom_left, 9, 9);
    ASSERT_TRUE(setup);
    EXPECT_NEAR(value_at(setup->depth, 0.0f, 0.0f), 0.25, 1e-6);
    EXPECT_NEAR(value_at(setup->depth, 4.0f, 2.0f), 0.5, 1e-6);
    EXPECT_NEAR(value_at(setup->depth, 8.0f, 4.0f), 0.75, 1e-6);
    EXPECT_EQ(value_at(setup->depth, 4.0f, 0.0f), value_at(setup->depth, 4.0f, 7.0f)) << "equal along the minor axis";
}

TEST(Line, HalvesAreSnappedAwayFromZero) {
    EXPECT_EQ(snap_half_away(0.5f), 0);
    EXPECT_EQ(snap_half_away(0.5f + 1.0f / 512), 1);
    EXPECT_EQ(snap_half_away(0.5f + 3.0f / 512), 2);
    EXPECT_EQ(snap_half_away(0.5f - 1.0f / 512), -1);
}

struct None {
    template <class F>
    struct Vertex {
        vec<4, F> position;
    };
    template <class F>
    struct Varyings {
        F value;
    };
    template <class F>
    VertexOut<F, Varyings> vertex(const Vertex<F>& v) const {
        return {v.position, {F(0)}};
    }
};

TEST(Line, ClippingCutsBothEnds) {
    const ShadedVertex<float, 1> a{{-3, 0, 0, 1}, {0}}, b{{3, 0, 0, 1}, {6}};
    const auto r = clip_line<None>(a, b, outcode(a.clip) | outcode(b.clip));
    ASSERT_TRUE(r);
    EXPECT_NEAR((*r)[0].clip.x, -1, 1e-6);
    EXPECT_NEAR((*r)[1].clip.x, 1, 1e-6);
    EXPECT_NEAR((*r)[0].varyings[0], 2, 1e-6);
    EXPECT_NEAR((*r)[1].varyings[0], 4, 1e-6);
    const ShadedVertex<float, 1> c{{3, 0, 0, 1}, {0}}, d{{0, 3, 0, 1}, {0}};
    EXPECT_FALSE(clip_line<None>(c, d, outcode(c.clip) | outcode(d.clip))) << "passes the corner";
}

TEST(Point, OddSizesSurroundTheirPixelAndEvenOnesTheNearestCorner) {
    const auto box = [](float x, float y, float points) {
        return point_pixels(at(x, y), points, FillRule::bottom_left, size, size);
    };
    const auto same = [](const PixelBox& b, int x0, int y0, int x1, int y1) {
        return b.min_x == x0 && b.min_y == y0 && b.max_x == x1 && b.max_y == y1;
    };
    EXPECT_TRUE(same(box(5.5f, 5.5f, 1), 5, 5, 5, 5));
    EXPECT_TRUE(same(box(5.1f, 5.9f, 3), 4, 4, 6, 6));
    EXPECT_TRUE(same(box(5.4f, 5.4f, 2), 4, 4, 5, 5));
    EXPECT_TRUE(same(box(5.6f, 5.6f, 2), 5, 5, 6, 6));
    EXPECT_TRUE(same(box(0.5f, 11.5f, 5), 0, 9, 2, 11)) << "cut at the target";
    EXPECT_TRUE(same(box(5.5f, 5.5f, 0.1f), 5, 5, 5, 5)) << "at least one pixel";
    EXPECT_TRUE(same(box(5.5f, 5.5f, 1.5f), 5, 5, 5, 5)) << "halves go down";
}

TEST(Point, OnTheBorderOfTwoRowsTheRuleDecides) {
    EXPECT_EQ(point_pixels(at(5.5f, 6), 1, FillRule::bottom_left, size, size).min_y, 5);
    EXPECT_EQ(point_pixels(at(5.5f, 6), 1, FillRule::top_left, size, size).min_y, 6);
}

TEST(Point, OneWhoseCentreIsOutsideIsNotDrawn) {
    EXPECT_TRUE(is_point_visible({1, 1, 1, 1}));
    EXPECT_FALSE(is_point_visible({1.01f, 0, 0, 1}));
    EXPECT_FALSE(is_point_visible({0, 0, 0, 0}));
    EXPECT_FALSE(is_point_visible({NAN, 0, 0, 1}));
}

}  // namespace
