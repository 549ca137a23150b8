// shapes_test.cpp: generated models are closed, oriented, unit-normalled and of the right size.
#include <raster/scene/shapes.h>

#include <cmath>
#include <limits>
#include <string>

#include <gtest/gtest.h>

#include "shapes_testing.h"

namespace raster {
namespace {

using testing::Surface;

const double pi = std::acos(-1.0);

struct NamedModel {
    std::string name;
    Model model;
};

/// Every generator, at its default and at odd and extreme counts.
std::vector<NamedModel> all_models() {
    const std::vector<glm::dvec2> outline = {{0, 0}, {0.5, 0}, {0.5, 0}, {0.3, 1}, {0.6, 1.5}};
    return {{"cube", cube()},
            {"box", box({-1, 0, 2}, {4, 0.5f, 3})},
            {"box 5", box({-1, 0, 2}, {4, 0.5f, 3}, 5)},
            {"tetrahedron", tetrahedron()},
            {"plane", plane()},
            {"plane 1", plane(1)},
            {"sphere", sphere()},
            {"sphere 3 2", sphere(3, 2)},
            {"sphere 7 5", sphere(7, 5)},
            {"torus", torus()},
            {"torus 3 3", torus(0.7f, 3, 3)},
            {"bowl", bowl()},
            {"bowl 5 1", bowl(5, 1)},
            {"vase", surface_of_revolution(smooth_profile(outline), 20)},
            {"the vase", vase()},
            {"the vase 3 1", vase(3, 1)},
            {"cylinder", cylinder()},
            {"cylinder 3", cylinder(3)},
            {"icosphere", icosphere()},
            {"icosphere 1", icosphere(1)},
            {"icosphere 5", icosphere(5)},
            {"teapot", teapot()},
            {"teapot 1", teapot(1)},
            {"teapot 7", teapot(7)},
            {"cornell box", cornell_box()},
            {"cyclic trio", cyclic_trio()}};
}

TEST(Shapes, KeepThePromisesOfAModel) {
    for (const auto& [name, m] : all_models()) {
        SCOPED_TRACE(name);
        ASSERT_FALSE(m.indices.empty());
        ASSERT_EQ(m.indices.size() % 3, 0u);
        for (std::uint32_t i : m.indices) ASSERT_LT(i, m.vertices.size());
        std::size_t covered = 0;
        for (const Part& p : m.parts) {
            EXPECT_FALSE(p.name.empty());
            EXPECT_EQ(p.first_index, covered);
            EXPECT_GT(p.index_count, 0u);
            EXPECT_LT(p.material, int(m.materials.size()));
            covered += p.index_count;
        }
        EXPECT_EQ(covered, m.indices.size());
        for (const auto& v : m.vertices) {
            EXPECT_NEAR(glm::length(glm::dvec3(v.normal)), 1, 1.2e-7);
            const float last_u = name.starts_with("icosphere") ? 1.1000001f : 1.0f;  // beyond its seam
            for (int k = 0; k < 2; ++k) EXPECT_TRUE(v.uv[k] >= 0 && v.uv[k] <= (k == 0 ? last_u : 1.0f)) << v.uv[k];
            for (int k = 0; k < 3; ++k) EXPECT_TRUE(std::isfinite(v.position[k]));
            for (int k = 0; k < 3; ++k) EXPECT_FALSE(v.position[k] == 0 && std::signbit(v.position[k]));
            EXPECT_EQ(v.color, glm::vec3(1));
        }
    }
}

TEST(Shapes, TrianglesWindCounterClockwiseAroundTheirNormals) {
    for (const auto& [name, m] : all_models()) {
        SCOPED_TRACE(name);
        // At these counts a triangle is as big as what it approximates, and may face away from an exact
        // normal.
        if (name == "teapot 1" || name == "torus 3 3") continue;
        for (std::size_t i = 0; i < m.indices.size(); i += 3) {
            const auto &a = m.vertices[m.indices[i]], &b = m.vertices[m.indices[i + 1]];
            const auto& c = m.vertices[m.indices[i + 2]];
            const glm::dvec3 n = glm::cross(glm::dvec3(b.position) - glm::dvec3(a.position),
                                            glm::dvec3(c.position) - glm::dvec3(a.position));
            EXPECT_GT(glm::length(n), 0);
            for (const auto* v : {&a, &b, &c}) EXPECT_GT(glm::dot(n, glm::dvec3(v->normal)), 0) << i / 3;
        }
    }
}

TEST(Shapes, TexturesAreNotMirrored) {
    for (const auto& [name, m] : all_models()) {
        SCOPED_TRACE(name);
        for (std::size_t i = 0; i < m.indices.size(); i += 3) {
            const glm::dvec2 a(m.vertices[m.indices[i]].uv), b(m.vertices[m.indices[i + 1]].uv);
            const glm::dvec2 c(m.vertices[m.indices[i + 2]].uv), ab = b - a, ac = c - a;
            EXPECT_GT(ab.x * ac.y - ab.y * ac.x, 0) << i / 3;
        }
    }
}

TEST(Shapes, ClosedOnesAreWatertightAndOthersOpenWhereTheyShould) {
    const std::tuple<const char*, Model, int, std::size_t> cases[] = {
        {"cube", cube(), 2, 0},
        {"box in pieces", box(glm::vec3(-1), glm::vec3(1), 3), 2, 0},
        {"tetrahedron", tetrahedron(), 2, 0},
        {"sphere", sphere(), 2, 0},
        {"coarse sphere", sphere(3, 2), 2, 0},
        {"torus", torus(), 0, 0},
        {"coarse torus", torus(0.5f, 3, 3), 0, 0},
        {"vase", vase(), 2, 0},
        {"cylinder", cylinder(5), 2, 0},
        {"icosahedron", icosphere(1), 2, 0},
        {"icosphere", icosphere(7), 2, 0},
        {"plane", plane(5), 1, 20},
        {"bowl", bowl(9, 4), 1, 9},
    };
    for (const auto& [name, model, euler, open] : cases) {
        const Surface surface(model);
        EXPECT_EQ(surface.euler_characteristic(), euler) << name;
        EXPECT_EQ(surface.open_edges().size(), open) << name;
    }
}

TEST(Shapes, HaveTheVolumesOfTheirSolids) {
    EXPECT_DOUBLE_EQ(Surface(cube()).volume(), 8);
    EXPECT_DOUBLE_EQ(Surface(tetrahedron()).volume(), 8.0 / 3);
    EXPECT_DOUBLE_EQ(Surface(box({-1, 0, 2}, {4, 0.5f, 3})).volume(), 2.5);
    EXPECT_DOUBLE_EQ(Surface(box({-1, 0, 2}, {4, 0.5f, 3}, 4)).volume(), 2.5);
    EXPECT_EQ(box({-1, 0, 2}, {4, 0.5f, 3}, 4).indices.size(), 6u * 16 * 6);
    EXPECT_NEAR(Surface(sphere(400, 200)).volume(), 4 * pi / 3, 1e-3);
    EXPECT_NEAR(Surface(torus(0.25f, 400, 200)).volume(), 2 * pi * pi * 0.0625, 1e-3);
    EXPECT_NEAR(Surface(cylinder(1000)).volume(), 2 * pi, 1e-4);
    EXPECT_NEAR(Surface(icosphere(100)).volume(), 4 * pi / 3, 1e-3);
    // A pyramid of n sides inside the double cone.
    EXPECT_NEAR(Surface(sphere(6, 2)).volume(), std::sqrt(3.0), 1e-6);
}

TEST(Shapes, RoundOnesLieOnTheirSurfacesWithExactNormals) {
    for (const auto& v : sphere(31, 17).vertices) {
        EXPECT_NEAR(glm::length(glm::dvec3(v.position)), 1, 1e-7);
        EXPECT_EQ(v.position, v.normal);
    }
    for (const auto& v : torus(0.3f, 31, 17).vertices) {
        const glm::dvec3 p(v.position);
        const glm::dvec3 on_circle = glm::normalize(glm::dvec3(p.x, 0, p.z));
        EXPECT_NEAR(glm::length(p - on_circle), 0.3, 1e-6);
        EXPECT_NEAR(glm::length((p - on_circle) / 0.3 - glm::dvec3(v.normal)), 0, 1e-6);
    }
    for (const auto& v : bowl().vertices) EXPECT_LE(v.position.y, 0);
}

TEST(Shapes, TheTextureOfASphereRunsEastwardWithItsSeamBehind) {
    const auto place = [](const glm::vec2& uv) {
        for (const auto& v : sphere(8, 4).vertices)
            if (v.uv == uv) return v.position;
        return glm::vec3(0);
    };
    EXPECT_EQ(place({0.0f, 0.5f}), glm::vec3(0, 0, -1));
    EXPECT_EQ(place({0.25f, 0.5f}), glm::vec3(-1, 0, 0));
    EXPECT_EQ(place({0.5f, 0.5f}), glm::vec3(0, 0, 1));
    EXPECT_EQ(place({0.75f, 0.5f}), glm::vec3(1, 0, 0));
    EXPECT_EQ(place({1.0f, 0.5f}), glm::vec3(0, 0, -1));
    EXPECT_EQ(place({0.0625f, 1.0f}), glm::vec3(0, 1, 0)) << "the pole's tips lie between the meridians";
}

TEST(Shapes, CountsOutOfRangeAreBroughtIntoIt) {
    EXPECT_EQ(plane(0).triangle_count(), 2u);
    EXPECT_EQ(plane(-5).triangle_count(), 2u);
    EXPECT_EQ(sphere(-1, -1).triangle_count(), 6u);
    EXPECT_EQ(torus(0.5f, 0, 0).triangle_count(), 18u);
    EXPECT_EQ(teapot(-3).triangle_count(), teapot(1).triangle_count());
    for (float bad : {-1.0f, 0.0f, 2.0f, std::numeric_limits<float>::quiet_NaN()})
        EXPECT_EQ(Surface(torus(bad, 8, 8)).euler_characteristic(), 0) << bad;
    EXPECT_TRUE(surface_of_revolution({}, 8).indices.empty());
    EXPECT_TRUE(surface_of_revolution(std::vector<ProfilePoint>(1), 8).indices.empty());
    for (const auto& v : box({1, 1, 1}, {1, 1, 1}).vertices) EXPECT_EQ(v.normal, glm::vec3(0, 1, 0));
}

TEST(Profile, ARepeatedPointIsASharpEdge) {
    const std::vector<glm::dvec2> points = {{0, 0}, {1, 0}, {1, 0}, {1, 2}};
    const auto profile = smooth_profile(points);
    ASSERT_EQ(profile.size(), 4u);
    EXPECT_EQ(profile[1].normal, glm::dvec2(0, -1)) << "the floor looks down";
    EXPECT_EQ(profile[2].normal, glm::dvec2(1, 0)) << "the wall looks outward";
}

TEST(Profile, AClosedProfileJoinsSmoothly) {
    const std::vector<glm::dvec2> square = {{1, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 0}};
    const auto profile = smooth_profile(square);
    EXPECT_EQ(profile.front().normal, profile.back().normal);
    EXPECT_NEAR(profile.front().normal.x, -std::sqrt(0.5), 1e-12);
    EXPECT_NEAR(profile.front().normal.y, -std::sqrt(0.5), 1e-12);
    const Surface ring(surface_of_revolution(profile, 300));
    EXPECT_EQ(ring.open_edges().size(), 0u);
    EXPECT_NEAR(ring.volume(), 3 * pi, 1e-3);
}

}  // namespace
}  // namespace raster
