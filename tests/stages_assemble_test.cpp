// Stage 2: lists, strips and fans become triangles that all wind the same way.
#include <raster/stages/assemble.h>

#include <algorithm>
#include <vector>

#include <gtest/gtest.h>

namespace {

using namespace raster;
using Triangle = std::array<std::size_t, 3>;

TEST(Assemble, CountsWholeTrianglesOnly) {
    EXPECT_EQ(triangle_count(Topology::triangles, 0), 0u);
    EXPECT_EQ(triangle_count(Topology::triangles, 2), 0u);
    EXPECT_EQ(triangle_count(Topology::triangles, 8), 2u);
    for (const auto topology : {Topology::triangle_strip, Topology::triangle_fan}) {
        for (std::size_t count = 0; count < 3; ++count) EXPECT_EQ(triangle_count(topology, count), 0u);
        EXPECT_EQ(triangle_count(topology, 3), 1u);
        EXPECT_EQ(triangle_count(topology, 10), 8u);
    }
}

TEST(Assemble, AListTakesThreeAtATime) {
    EXPECT_EQ(assemble(Topology::triangles, 0), (Triangle{0, 1, 2}));
    EXPECT_EQ(assemble(Topology::triangles, 5), (Triangle{15, 16, 17}));
}

// OpenGL 4.6, 10.1.8 and 10.1.9, tables 10.1: with the last vertex as the provoking one.
TEST(Assemble, AStripExchangesTheFirstTwoOfEveryOtherTriangle) {
    EXPECT_EQ(assemble(Topology::triangle_strip, 0), (Triangle{0, 1, 2}));
    EXPECT_EQ(assemble(Topology::triangle_strip, 1), (Triangle{2, 1, 3}));
    EXPECT_EQ(assemble(Topology::triangle_strip, 2), (Triangle{2, 3, 4}));
    EXPECT_EQ(assemble(Topology::triangle_strip, 3), (Triangle{4, 3, 5}));
}

TEST(Assemble, AFanStaysAtItsFirstVertex) {
    EXPECT_EQ(assemble(Topology::triangle_fan, 0), (Triangle{0, 1, 2}));
    EXPECT_EQ(assemble(Topology::triangle_fan, 6), (Triangle{0, 7, 8}));
}

TEST(Assemble, TheLastVertexOfATriangleIsItsNewestOne) {
    for (const auto topology : {Topology::triangle_strip, Topology::triangle_fan})
        for (std::size_t i = 0; i < 20; ++i) EXPECT_EQ(assemble(topology, i)[2], i + 2);
}

/// Twice the signed area of points on a zigzag (strip) or a circle (fan).
int orientation(const Triangle& t, const std::vector<std::array<int, 2>>& points) {
    const auto &a = points[t[0]], &b = points[t[1]], &c = points[t[2]];
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

TEST(Assemble, AllTrianglesOfAZigzagStripWindTheSameWay) {
    std::vector<std::array<int, 2>> points;
    for (int i = 0; i < 30; ++i) points.push_back({i, i % 2 * 10});
    for (std::size_t i = 0; i < triangle_count(Topology::triangle_strip, points.size()); ++i)
        EXPECT_LT(orientation(assemble(Topology::triangle_strip, i), points), 0) << i;
}

TEST(Assemble, AllTrianglesOfAConvexFanWindTheSameWay) {
    const std::vector<std::array<int, 2>> points = {{0, 0}, {4, 1}, {5, 3}, {4, 6}, {1, 7}, {-2, 5}};
    for (std::size_t i = 0; i < triangle_count(Topology::triangle_fan, points.size()); ++i)
        EXPECT_GT(orientation(assemble(Topology::triangle_fan, i), points), 0) << i;
}

TEST(Assemble, NoIndexIsBeyondTheList) {
    for (const auto topology : {Topology::triangles, Topology::triangle_strip, Topology::triangle_fan})
        for (std::size_t count = 0; count < 50; ++count)
            for (std::size_t i = 0; i < triangle_count(topology, count); ++i) {
                const Triangle t = assemble(topology, i);
                EXPECT_LT(*std::max_element(t.begin(), t.end()), count);
            }
}

}  // namespace
