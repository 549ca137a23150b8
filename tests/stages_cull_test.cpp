// Stage 5: the area's sign says which side is seen; State::cull says which is wanted.
#include <raster/stages/cull.h>

#include <gtest/gtest.h>

#include "random.h"

namespace {

using namespace raster;
using raster::testing::Random;
using Triangle = std::array<SubpixelVertex<float>, 3>;

TEST(Cull, TheAreaOfARightTriangle) {
    // Rows go down, so (0, 0), (0, 256), (256, 0) runs counter-clockwise on the picture.
    EXPECT_EQ(signed_area(Triangle{{{0, 0}, {0, 256}, {256, 0}}}), 256 * 256);
    EXPECT_EQ(signed_area(Triangle{{{0, 0}, {256, 0}, {0, 256}}}), -256 * 256);
}

TEST(Cull, TrianglesWithoutAreaHaveNone) {
    EXPECT_EQ(signed_area(Triangle{{{5, 7}, {5, 7}, {5, 7}}}), 0);
    EXPECT_EQ(signed_area(Triangle{{{0, 0}, {10, 20}, {0, 0}}}), 0);
    EXPECT_EQ(signed_area(Triangle{{{-100, -50}, {0, 0}, {300, 150}}}), 0);
}

TEST(Cull, TheLargestTriangleDoesNotOverflow) {
    constexpr std::int32_t far = 24576 * 256;
    EXPECT_EQ(signed_area(Triangle{{{-far, -far}, {-far, far}, {far, -far}}}), 4 * std::int64_t(far) * far);
}

TEST(Cull, RotatingKeepsTheAreaAndExchangingNegatesIt) {
    Random random(1);
    for (int round = 0; round < 10000; ++round) {
        Triangle t;
        for (auto& v : t) v.x = random.integer(-1 << 22, 1 << 22), v.y = random.integer(-1 << 22, 1 << 22);
        const std::int64_t area = signed_area(t);
        ASSERT_EQ(signed_area(Triangle{{t[1], t[2], t[0]}}), area);
        ASSERT_EQ(signed_area(Triangle{{t[1], t[0], t[2]}}), -area);
    }
}

TEST(Cull, FrontIsTheWindingThatTheStateSays) {
    EXPECT_TRUE(is_front_facing(FrontFace::counter_clockwise, 1));
    EXPECT_FALSE(is_front_facing(FrontFace::counter_clockwise, -1));
    EXPECT_FALSE(is_front_facing(FrontFace::clockwise, 1));
    EXPECT_TRUE(is_front_facing(FrontFace::clockwise, -1));
}

TEST(Cull, OnlyTheSidesThatTheStateNamesAreCulled) {
    EXPECT_FALSE(is_culled(Cull::none, true));
    EXPECT_FALSE(is_culled(Cull::none, false));
    EXPECT_FALSE(is_culled(Cull::back, true));
    EXPECT_TRUE(is_culled(Cull::back, false));
    EXPECT_TRUE(is_culled(Cull::front, true));
    EXPECT_FALSE(is_culled(Cull::front, false));
    EXPECT_TRUE(is_culled(Cull::both, true));
    EXPECT_TRUE(is_culled(Cull::both, false));
}

}  // namespace
