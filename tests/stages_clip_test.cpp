// Stage 3: what is cut off, what stays, and that nothing but numbers inside the view volume goes on.
#include <raster/stages/clip.h>

#include <algorithm>

#include <gtest/gtest.h>

#include "scenes.h"

namespace {

using namespace raster;
using raster::testing::Group;
using raster::testing::Random;

constexpr float infinity = std::numeric_limits<float>::infinity();

/// One smooth, one window-linear varying.
struct Two {
    template <class F>
    struct Vertex {
        vec<4, F> position;
    };
    template <class F>
    struct Varyings {
        F smooth, affine;
    };
    static constexpr Interpolation interpolation(int i) {
        return i == 0 ? Interpolation::smooth : Interpolation::noperspective;
    }
    template <class F>
    VertexOut<F, Varyings> vertex(const Vertex<F>& v) const {
        return {v.position, {F(0), F(0)}};
    }
};
using Corner = ShadedVertex<float, 2>;
using Polygon = ClipPolygon<2>;

Polygon polygon_of(const raster::testing::Corners& corners) {
    Polygon polygon;
    for (std::size_t i = 0; i < 3; ++i) polygon.add({corners[i], {float(i), float(i)}});
    return polygon;
}
std::int32_t outside_of(const Polygon& polygon) {
    std::int32_t outside = 0;
    for (int i = 0; i < polygon.count; ++i) outside |= outcode(polygon.corners[std::size_t(i)].clip);
    return outside;
}
Polygon clip(const raster::testing::Corners& corners) {
    const Polygon polygon = polygon_of(corners);
    return clip_triangle<Two>(polygon, outside_of(polygon), [](auto&&...) {});
}
double ndc_area(const Polygon& p) {
    double sum = 0;
    for (int i = 0; i < p.count; ++i) {
        const glm::dvec4 a = p.corners[std::size_t(i)].clip, b = p.corners[std::size_t((i + 1) % p.count)].clip;
        sum += a.x / a.w * (b.y / b.w) - b.x / b.w * (a.y / a.w);
    }
    return sum / 2;
}

TEST(Clip, OutcodesNameThePlanesThatAPointIsBeyond) {
    EXPECT_EQ(outcode(glm::vec4(0, 0, 0, 1)), 0);
    EXPECT_EQ(outcode(glm::vec4(2, 0, 0, 1)), 1 << int(ClipPlane::right));
    EXPECT_EQ(outcode(glm::vec4(-2, 0, 0, 1)), 1 << int(ClipPlane::left));
    EXPECT_EQ(outcode(glm::vec4(0, 2, 0, 1)), 1 << int(ClipPlane::top));
    EXPECT_EQ(outcode(glm::vec4(0, -2, 0, 1)), 1 << int(ClipPlane::bottom));
    EXPECT_EQ(outcode(glm::vec4(0, 0, -2, 1)), 1 << int(ClipPlane::near));
    EXPECT_EQ(outcode(glm::vec4(0, 0, 2, 1)), 1 << int(ClipPlane::far));
    EXPECT_EQ(outcode(glm::vec4(0, 0, 0, -1)), 63) << "behind the eye is beyond all planes";
}

TEST(Clip, PointsOnAPlaneAreInside) {
    for (const float w : {1.0f, 0.1f, 3e10f})
        for (int i = 0; i < 3; ++i)
            for (const float sign : {-1.0f, 1.0f}) {
                glm::vec4 point(0, 0, 0, w);
                point[i] = sign * w;
                EXPECT_EQ(outcode(point), 0);
                for (int plane = 0; plane < clip_plane_count; ++plane)
                    EXPECT_GE(clip_distance(ClipPlane(plane), point), 0.0f);
            }
}

TEST(Clip, LanesHaveTheOutcodesOfScalars) {
    using F = FloatPack<4>;
    Random random(1);
    for (int round = 0; round < 500; ++round) {
        vec<4, F> pack;
        glm::vec4 scalars[4];
        for (int l = 0; l < 4; ++l) {
            scalars[l] = make_triangle(Group::wild, random, 100, 100)[0];
            for (int i = 0; i < 4; ++i) pack[i].v[l] = scalars[l][i];
        }
        for (int l = 0; l < 4; ++l) {
            ASSERT_EQ(lane(outcode(pack), l), outcode(scalars[l]));
            ASSERT_EQ(lane(is_finite(pack), l), is_finite(scalars[l]));
        }
    }
}

TEST(Clip, OnlyNumbersThatMakeAPointAreFinite) {
    EXPECT_TRUE(is_finite(glm::vec4(1, 2, 3, 4)));
    EXPECT_TRUE(is_finite(glm::vec4(3e38f, -3e38f, 3e38f, -3e38f)));
    EXPECT_TRUE(is_finite(glm::vec4(1, 0, 0, 0))) << "a direction is a point at infinity, and can be cut";
    EXPECT_FALSE(is_finite(glm::vec4(0, 0, 0, 0)));
    EXPECT_FALSE(is_finite(glm::vec4(1e-40f, 0, -1e-39f, 0)));
    for (int i = 0; i < 4; ++i)
        for (const float bad : {infinity, -infinity, NAN}) {
            glm::vec4 point(1);
            point[i] = bad;
            EXPECT_FALSE(is_finite(point));
        }
}

TEST(Clip, ATriangleInsideIsNotTouched) {
    const Polygon p = clip({{{0, 0, 0, 1}, {0.5f, 0, 0, 1}, {0, 0.5f, 0, 1}}});
    EXPECT_EQ(p.count, 3);
    EXPECT_FALSE(p.clipped);
}

TEST(Clip, ACornerBeyondOnePlaneIsCutOff) {
    // (0, 0), (2, 0), (0, 1) at x <= 1: what stays is (0, 0), (1, 0), (1, 1/2), (0, 1).
    const Polygon p = clip({{{0, 0, 0, 1}, {2, 0, 0, 1}, {0, 1, 0, 1}}});
    ASSERT_EQ(p.count, 4);
    EXPECT_TRUE(p.clipped);
    EXPECT_EQ(p.corners[0].clip, glm::vec4(0, 0, 0, 1));
    EXPECT_EQ(p.corners[1].clip, glm::vec4(1, 0, 0, 1));
    EXPECT_EQ(p.corners[2].clip, glm::vec4(1, 0.5f, 0, 1));
    EXPECT_EQ(p.corners[3].clip, glm::vec4(0, 1, 0, 1));
    EXPECT_FLOAT_EQ(p.corners[1].varyings[0], 0.5f);
    EXPECT_FLOAT_EQ(p.corners[2].varyings[0], 1.5f);
}

TEST(Clip, TwoCornersBeyondOnePlaneLeaveATriangle) {
    const Polygon p = clip({{{0, 0, 0, 1}, {2, -1, 0, 1}, {2, 1, 0, 1}}});
    ASSERT_EQ(p.count, 3);
    EXPECT_EQ(p.corners[1].clip, glm::vec4(1, -0.5f, 0, 1));
    EXPECT_EQ(p.corners[2].clip, glm::vec4(1, 0.5f, 0, 1));
}

TEST(Clip, ATriangleAroundTheVolumeBecomesItsCrossSection) {
    const Polygon p = clip({{{-100, -100, 0, 1}, {100, -100, 0, 1}, {0, 100, 0, 1}}});
    EXPECT_NEAR(ndc_area(p), 4, 1e-4);
}

TEST(Clip, ATriangleOutsideWithoutACommonPlaneVanishes) {
    // It passes the corner (1, 1) without touching the volume.
    EXPECT_LT(clip({{{3, 0, 0, 1}, {0, 3, 0, 1}, {3, 3, 0, 1}}}).count, 3);
}

TEST(Clip, ATriangleThroughTheEyeIsCutAtTheNearPlane) {
    const Polygon p = clip({{{0, 0, 0.5f, 1}, {0.5f, 0, 0.5f, 1}, {0, 0, -3, -2}}});
    ASSERT_GE(p.count, 4);
    for (int i = 0; i < p.count; ++i) {
        EXPECT_GE(p.corners[std::size_t(i)].clip.z, -p.corners[std::size_t(i)].clip.w - 1e-6f);
        EXPECT_GT(p.corners[std::size_t(i)].clip.w, 0);
    }
}

TEST(Clip, BothDirectionsOfAnEdgeGiveTheSameCorner) {
    Random random(2);
    int cut = 0;
    for (int round = 0; round < 20000; ++round) {
        const auto corners = make_triangle(Group::clip_all, random, 100, 100);
        const Corner a{corners[0], {random.uniform(-5, 5), 1}}, b{corners[1], {random.uniform(-5, 5), 2}};
        for (int plane = 0; plane < clip_plane_count; ++plane) {
            const auto cut_with = [&](const Corner& from, const Corner& to) {
                Polygon polygon;
                polygon.add(from), polygon.add(to);
                return clip_against<Two>(ClipPlane(plane), polygon);
            };
            const Polygon forth = cut_with(a, b), back = cut_with(b, a);
            ASSERT_EQ(forth.count, back.count);
            if ((clip_distance(ClipPlane(plane), a.clip) >= 0) == (clip_distance(ClipPlane(plane), b.clip) >= 0))
                continue;
            ++cut;
            // A polygon of two corners has its edge in both directions, so the new corner is there twice.
            ASSERT_EQ(forth.count, 3);
            const auto new_corner = [&](const Polygon& p, const Corner& old) {
                const auto* c = &p.corners[p.corners[0].clip == old.clip ? 1u : 0u];
                EXPECT_EQ(c->clip, p.corners[2].clip);
                return *c;
            };
            const Corner& inside = clip_distance(ClipPlane(plane), a.clip) >= 0 ? a : b;
            ASSERT_EQ(new_corner(forth, inside).clip, new_corner(back, inside).clip);
            ASSERT_EQ(new_corner(forth, inside).varyings, new_corner(back, inside).varyings);
        }
    }
    EXPECT_GT(cut, 10000);
}

TEST(Clip, WhatStaysIsInsideAndConvexAndKeepsItsWinding) {
    Random random(3);
    int clipped = 0;
    for (int round = 0; round < 50000; ++round) {
        const auto group = Group(random.integer(int(Group::clip_near), int(Group::clip_all)));
        const auto corners = make_triangle(group, random, 100, 100);
        const Polygon p = clip(corners);
        if (p.count < 3 || !p.clipped) continue;
        ++clipped;
        ASSERT_LE(p.count, 9);
        for (int i = 0; i < p.count; ++i) {
            const glm::vec4 c = p.corners[std::size_t(i)].clip;
            ASSERT_GT(c.w, 0);
            for (int k = 0; k < 3; ++k) ASSERT_LE(std::abs(c[k]), c.w + 1e-4f) << round;
        }
        // The side it shows is the sign of the homogeneous determinant, whatever the signs of w.
        const glm::dvec4 a = corners[0], b = corners[1], c = corners[2];
        const double side = glm::determinant(glm::dmat3(a.x, a.y, a.w, b.x, b.y, b.w, c.x, c.y, c.w));
        const double area = ndc_area(p);
        if (std::abs(area) > 1e-4) {
            ASSERT_EQ(area > 0, side > 0) << round;
        }
    }
    EXPECT_GT(clipped, 10000);
}

TEST(Clip, TheAreaIsThatOfTheIntersection) {
    // The parts of a triangle on both sides of a plane add up to the triangle.
    Random random(4);
    for (int round = 0; round < 5000; ++round) {
        raster::testing::Corners corners;
        for (auto& corner : corners) {
            const float x = random.uniform(-3, 3), y = random.uniform(-3, 3);
            corner = glm::vec4(x, y, 0, 1) * random.uniform(0.5f, 2);
        }
        raster::testing::Corners mirrored = corners;  // reflected at x = w: what was outside is inside
        for (auto& corner : mirrored) corner.x = 2 * corner.w - corner.x;
        const auto part = [](const raster::testing::Corners& c) {
            return std::abs(ndc_area(clip_against<Two>(ClipPlane::right, polygon_of(c))));
        };
        const double whole = std::abs(ndc_area(polygon_of(corners)));
        ASSERT_NEAR(part(corners) + part(mirrored), whole, 1e-5 * (1 + whole));
    }
}

TEST(Clip, SmoothVaryingsAreLinearInClipSpaceAndAffineOnesInTheWindow) {
    // From (0, 0, 0, 1) to (8, 0, 0, 2): x = w at t = 1/7, where w = 8/7. In the window that is from 0 to 1 of 4.
    const Corner a{{0, 0, 0, 1}, {0, 0}}, b{{8, 0, 0, 2}, {7, 4}};
    const Corner new_corner = clip_intersection<Two>(a, b, 1.0f / 7);
    EXPECT_FLOAT_EQ(new_corner.varyings[0], 1);
    EXPECT_FLOAT_EQ(new_corner.varyings[1], 1);
}

TEST(Clip, FractionsOfTheWindowAreTakenWhereTheyCanBeTold) {
    EXPECT_FLOAT_EQ(window_fraction({0, 0, 0, 1}, {1, 0, 0, 1}, {0.25f, 0, 0, 1}, 9), 0.25f);
    EXPECT_FLOAT_EQ(window_fraction({1, 0, 0, 1}, {1, 2, 0, 1}, {1, 0.5f, 0, 1}, 9), 0.25f);
    EXPECT_FLOAT_EQ(window_fraction({1, 0, 0, 1}, {2, 4, 0, 2}, {1.5f, 1.5f, 0, 1.5f}, 9), 0.5f) << "x / w is equal";
    EXPECT_FLOAT_EQ(window_fraction({1, 1, 0, 1}, {1, 1, 5, 1}, {1, 1, 2, 1}, 0.4f), 0.4f) << "the same window point";
    EXPECT_FLOAT_EQ(window_fraction({1, 0, 0, 0}, {1, 0, 0, 1}, {1, 0, 0, 0.5f}, 0.5f), 0.5f) << "from infinity";
}

TEST(Clip, FlatVaryingsAreTheProvokingVertexsWhereverItLies) {
    struct Flat : Two {
        static constexpr Interpolation interpolation(int i) { return i ? Interpolation::flat : Interpolation::smooth; }
    };
    Polygon p = clip({{{0, 0, 0, 1}, {0, 0.5f, 0, 1}, {5, 0, 0, 1}}});
    ASSERT_EQ(p.count, 4);
    const auto smooth = p.corners[1].varyings[0];
    keep_flat_varyings<Flat>(p, {{}, {8, 9}});
    for (const auto& corner : p.corners) EXPECT_EQ(corner.varyings[1], 9);
    EXPECT_EQ(p.corners[1].varyings[0], smooth);
}

TEST(Clip, TheFanHasOneTriangleACornerAndWindsAsThePolygon) {
    EXPECT_EQ(clip_fan(0), (std::array{1, 2, 0}));
    EXPECT_EQ(clip_fan(3), (std::array{4, 5, 0}));
}

TEST(Clip, EachCutIsShown) {
    const Polygon polygon = polygon_of({{{0, 0, 0, 1}, {2, 0, 0, 1}, {0, 3, 0, 1}}});
    std::vector<ClipPlane> planes;
    clip_triangle<Two>(polygon, outside_of(polygon), [&](ClipPlane plane, const Polygon& before, const Polygon& after) {
        planes.push_back(plane);
        EXPECT_EQ(before.count, planes.size() == 1 ? 3 : 4);
        EXPECT_GE(after.count, 4);
    });
    EXPECT_EQ(planes, (std::vector{ClipPlane::right, ClipPlane::top}));
}

TEST(Clip, WildNumbersAreDroppedOrEndNearTheVolume) {
    Random random(5);
    int kept = 0, dropped = 0;
    for (int round = 0; round < 200000; ++round) {
        raster::testing::Corners corners = make_triangle(Group::wild, random, 100, 100);
        if (round % 2)  // any exponent at all
            for (auto& corner : corners)
                for (int i = 0; i < 4; ++i) corner[i] = as_float(std::int32_t(std::uint32_t(random.bits())));
        if (!is_finite(corners[0]) || !is_finite(corners[1]) || !is_finite(corners[2])) continue;
        const Polygon p = clip(corners);
        ++(p.count < 3 ? dropped : kept);
        for (int i = 0; i < p.count && p.count >= 3; ++i) {
            const glm::vec4 c = p.corners[std::size_t(i)].clip;
            ASSERT_TRUE(std::isfinite(1 / c.w) && c.w > 0);
            for (int k = 0; k < 3; ++k) ASSERT_LE(std::abs(c[k] * (1 / c.w)), 1.5001f);
        }
    }
    EXPECT_GT(kept, 1000);
    EXPECT_GT(dropped, 1000);
}

}  // namespace
