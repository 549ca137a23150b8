// What a draw says became of its triangles.
#include <gtest/gtest.h>

#include "pipeline_testing.h"

namespace {

using namespace raster;
using namespace raster::testing;

constexpr float infinity = std::numeric_limits<float>::infinity();

DrawCounts count(const std::vector<glm::vec4>& positions, const State& state = {},
                 const std::vector<std::uint32_t>& indices = {}) {
    Vertices vertices;
    for (const glm::vec4& position : positions) vertices.push_back({position, glm::vec4(1), {}});
    Target observed(16, 16), fast(16, 16);
    const DrawCounts counts = draw(observed, Smooth{}, Mesh(vertices, indices), state, NoObserver{});
    EXPECT_EQ(draw(fast, Smooth{}, Mesh(vertices, indices), state), counts);
    EXPECT_EQ(counts.submitted,
              counts.bad_index + counts.not_finite + counts.outside + counts.culled + counts.zero_area + counts.drawn);
    return counts;
}
const std::vector<glm::vec4> good = {{-0.5f, -0.5f, 0, 1}, {0.5f, -0.5f, 0, 1}, {0, 0.5f, 0, 1}};

TEST(Counts, ADrawnTriangle) {
    const DrawCounts c = count(good);
    EXPECT_EQ(c.submitted, 1);
    EXPECT_EQ(c.drawn, 1);
}

TEST(Counts, NothingSubmittedIsNothing) {
    EXPECT_EQ(count({}), DrawCounts{});
    EXPECT_EQ(count({good[0], good[1]}), DrawCounts{});
}

TEST(Counts, BadIndices) {
    EXPECT_EQ(count(good, {}, {0, 1, 3}).bad_index, 1);
    EXPECT_EQ(count(good, {}, {0, 1, 0xffffffffu, 0, 1, 2}).bad_index, 1);
    EXPECT_EQ(count(good, {}, {0, 1, 0xffffffffu, 0, 1, 2}).drawn, 1);
}

TEST(Counts, PositionsThatAreNoPoints) {
    for (const float bad : {infinity, -infinity, NAN})
        for (int component = 0; component < 4; ++component) {
            auto positions = good;
            positions[1][component] = bad;
            EXPECT_EQ(count(positions).not_finite, 1) << bad << " " << component;
        }
    EXPECT_EQ(count({good[0], good[1], {0, 0, 0, 0}}).not_finite, 1);
}

TEST(Counts, TrianglesOutside) {
    EXPECT_EQ(count({{2, 0, 0, 1}, {3, 0, 0, 1}, {2, 1, 0, 1}}).outside, 1) << "beyond one plane";
    EXPECT_EQ(count({{3, 0, 0, 1}, {0, 3, 0, 1}, {3, 3, 0, 1}}).outside, 1) << "clipped to nothing";
    EXPECT_EQ(count({{0, 0, 0, -1}, {1, 0, 0, -1}, {0, 1, 0, -1}}).outside, 1) << "behind the eye";
}

TEST(Counts, SidesThatAreNotWanted) {
    State state;
    state.cull = Cull::back;
    EXPECT_EQ(count(good, state).drawn, 1);
    EXPECT_EQ(count({good[0], good[2], good[1]}, state).culled, 1);
    state.cull = Cull::both;
    EXPECT_EQ(count(good, state).culled, 1);
}

TEST(Counts, TrianglesWithoutArea) {
    EXPECT_EQ(count({good[0], good[0], good[1]}).zero_area, 1);
    EXPECT_EQ(count({{0, 0, 0, 1}, {1e-4f, 0, 0, 1}, {0, 1e-4f, 0, 1}}).zero_area, 1) << "none after snapping";
    State state;
    state.cull = Cull::both;
    EXPECT_EQ(count({good[0], good[0], good[1]}, state).zero_area, 1) << "not culled: it has no side";
}

TEST(Counts, AClippedTriangleIsOneTriangle) {
    const DrawCounts c = count({{-9, -9, 0, 1}, {9, -9, 0, 1}, {0, 9, 0, 1}});
    EXPECT_EQ(c.submitted, 1);
    EXPECT_EQ(c.drawn, 1);
}

TEST(Counts, AViewportThatIsNoneDrawsAndCountsNothing) {
    State state;
    state.viewport = {0, 0, 40000, 10};
    EXPECT_EQ(count(good, state), DrawCounts{});
}

TEST(Counts, TheyAlwaysAddUp) {
    Random random(seed(1));
    DrawCounts all;
    for (int round = 0; round < 100; ++round) {
        std::vector<glm::vec4> positions;
        for (int i = 0; i < 20; ++i)
            for (const glm::vec4& p : make_triangle(Group(random.integer(0, int(Group::wild))), random, 16, 16))
                positions.push_back(p);
        std::vector<std::uint32_t> indices;
        for (int i = 0; i < 100; ++i) indices.push_back(std::uint32_t(random.integer(0, 61)));
        all += count(positions, random_state(random), indices);
    }
    for (const auto n : {all.bad_index, all.not_finite, all.outside, all.culled, all.zero_area, all.drawn})
        EXPECT_GT(n, 0);
}

}  // namespace
