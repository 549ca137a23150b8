// shapes_known_test.cpp: the teapot, the Cornell box and the cyclic trio are the ones that everybody knows.
#include <raster/scene/shapes.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <raster/scene/shapes_teapot_data.h>

#include "shapes_testing.h"

namespace raster {
namespace {

using testing::Surface;

// ------------------------------------------------------------------------------------------------ the teapot

TEST(Teapot, TheTableIsWholeAndSymmetric) {
    std::set<int> used;
    using Patch = std::vector<std::array<double, 3>>;
    std::multiset<Patch> patches, mirrored;
    for (const auto& patch : detail::teapot_patches) {
        Patch points, mirror;
        for (int i : patch) {
            ASSERT_TRUE(i >= 1 && i <= 306);
            used.insert(i);
            const auto& p = detail::teapot_points[i - 1];
            points.push_back({p[0], p[1], p[2]});
            mirror.push_back({p[0], -p[1] + 0.0, p[2]});
        }
        std::sort(points.begin(), points.end());
        std::sort(mirror.begin(), mirror.end());
        patches.insert(points);
        mirrored.insert(mirror);
    }
    EXPECT_EQ(patches, mirrored) << "the pot is its own mirror image";
    EXPECT_EQ(used.size(), 302u);
    for (int relic : {205, 206, 216, 223}) EXPECT_EQ(used.count(relic), 0u);
}

TEST(Teapot, NeighbouringPatchesShareEveryEdgePoint) {
    for (int n : {2, 3, 7, 10, 16}) {
        const Surface pot(teapot(n));
        EXPECT_EQ(int(pot.triangles.size()), 64 * n * n - 8 * n);
        // Open are the inside of the rim and the underside of the lid, round four patches each, and both ends
        // of the handle and of the spout, round two patches each.
        const auto open = pot.open_edges();
        EXPECT_EQ(int(open.size()), (4 + 4 + 2 + 2 + 2 + 2) * n) << n;
        int on_rim = 0, on_lid = 0;
        for (const auto& [a, b] : open) {
            const glm::dvec3& p = pot.points[a];
            const double radius = std::hypot(p.x, p.z);
            if (std::fabs(p.y - 2.4) < 1e-6 && radius < 1.35) ++on_lid;
            if (std::fabs(p.y - 2.4) < 1e-6 && radius > 1.35 && radius < 1.45) ++on_rim;
        }
        EXPECT_EQ(on_rim, 4 * n);
        EXPECT_EQ(on_lid, 4 * n);
        // Two discs (pot and lid) and two tubes; but the handle's lower end touches the pot in one point.
        EXPECT_EQ(pot.euler_characteristic(), 2 - 1);
    }
}

TEST(Teapot, NeighbouringPatchesMeetSmoothly) {
    // Newell drew it so: where patches meet, their normals agree. A wrong figure in the table breaks this.
    std::map<std::array<float, 3>, std::vector<glm::dvec3>> normals;
    for (const auto& v : teapot(4).vertices)
        normals[{v.position.x, v.position.y, v.position.z}].emplace_back(v.normal);
    for (const auto& [p, ns] : normals) {
        if (p == std::array<float, 3>{-2, 0.9f, 0}) continue;  // the handle's lower end touches the body here
        for (const glm::dvec3& n : ns) EXPECT_LT(glm::length(n - ns[0]), 1e-5) << p[0] << " " << p[1];
    }
}

TEST(Teapot, HasItsKnownSize) {
    const Model pot = teapot(64);
    glm::vec3 low(1e9f), high(-1e9f);
    for (const auto& v : pot.vertices) {
        for (int k = 0; k < 3; ++k) low[k] = std::fmin(low[k], v.position[k]);
        for (int k = 0; k < 3; ++k) high[k] = std::fmax(high[k], v.position[k]);
    }
    EXPECT_EQ(low, glm::vec3(-3, 0, -2));
    EXPECT_EQ(high.y, 3.15f);
    EXPECT_EQ(high.z, 2.0f);
    EXPECT_NEAR(high.x, 3.434, 1e-3);
}

TEST(Teapot, IsItsOwnMirrorImage) {
    const Model pot = teapot(5);
    std::set<std::array<float, 6>> points;
    for (const auto& v : pot.vertices)
        points.insert({v.position.x, v.position.y, v.position.z, v.normal.x, v.normal.y, v.normal.z});
    for (const auto& p : points)
        EXPECT_EQ(points.count({p[0], p[1], -p[2] + 0.0f, p[3], p[4], -p[5] + 0.0f}), 1u) << p[0];
}

/// De Casteljau's construction in one direction: an evaluation that shares nothing with the library's.
glm::dvec3 de_casteljau(std::array<glm::dvec3, 4> p, double t) {
    for (int level = 3; level > 0; --level)
        for (int i = 0; i < level; ++i) p[i] = p[i] * (1 - t) + p[i + 1] * t;
    return p[0];
}

glm::dvec3 teapot_point(int patch, double along, double across) {
    std::array<glm::dvec3, 4> column;
    for (int r = 0; r < 4; ++r) {
        std::array<glm::dvec3, 4> row;
        for (int c = 0; c < 4; ++c) {
            const auto& p = detail::teapot_points[detail::teapot_patches[patch][r * 4 + c] - 1];
            row[c] = {p[0], p[2], -p[1]};
        }
        column[r] = de_casteljau(row, across);
    }
    return de_casteljau(column, along);
}

TEST(Teapot, PointsAndNormalsAgreeWithDeCasteljauAndDifferences) {
    const int n = 9;
    const Model pot = teapot(n);
    for (int patch = 0; patch < 32; ++patch) {
        for (int i = 0; i <= n; ++i) {
            for (int j = 0; j <= n; ++j) {
                const auto& v = pot.vertices[(patch * (n + 1) + i) * (n + 1) + j];
                const double s = double(i) / n, t = double(j) / n;
                EXPECT_LT(glm::length(glm::dvec3(v.position) - teapot_point(patch, s, t)), 5e-7);
                // A polynomial goes on beyond the patch, so central differences work on its border too; at a
                // pole the point a little way off stands for it.
                const double h = 1e-5, s_in = patch >= 20 && i == 0 ? 1e-3 : s;
                const glm::dvec3 across = teapot_point(patch, s_in, t + h) - teapot_point(patch, s_in, t - h);
                const glm::dvec3 along = teapot_point(patch, s_in + h, t) - teapot_point(patch, s_in - h, t);
                const glm::dvec3 normal = glm::normalize(glm::cross(across, along));
                EXPECT_LT(glm::length(normal - glm::dvec3(v.normal)), s_in == s ? 1e-5 : 0.02)
                    << patch << " " << i << " " << j;
            }
        }
    }
}

TEST(Teapot, PolesAreSmooth) {
    int top = 0, bottom = 0;
    for (const auto& v : teapot(6).vertices) {
        if (v.position == glm::vec3(0, 3.15f, 0)) {
            ++top;
            EXPECT_NEAR(v.normal.y, 1, 1e-6);
        }
        if (v.position == glm::vec3(0, 0, 0)) {
            ++bottom;
            EXPECT_NEAR(v.normal.y, -1, 1e-6);
        }
    }
    EXPECT_EQ(top, 4 * 7);
    EXPECT_EQ(bottom, 4 * 7);
}

TEST(Teapot, HasItsPartsByName) {
    std::vector<std::string> names;
    for (const Part& p : teapot(3).parts) names.push_back(p.name);
    EXPECT_EQ(names, (std::vector<std::string>{"rim", "body", "handle", "spout", "lid", "bottom"}));
}

// ------------------------------------------------------------------------------------------- the Cornell box

TEST(CornellBox, IsARoomOpenOnlyToTheViewer) {
    const Model model = cornell_box();
    Model room = model;
    std::size_t blocks = 0;
    for (const Part& p : model.parts)
        if (p.name.find("block") != std::string::npos) blocks += p.index_count;
    room.indices.resize(room.indices.size() - blocks);
    const Surface walls(room);
    const auto open = walls.open_edges();
    EXPECT_EQ(open.size(), 4u) << "the light fills its hole, walls meet";
    for (const auto& [a, b] : open) EXPECT_TRUE(walls.points[a].z == 0 && walls.points[b].z == 0);
    EXPECT_EQ(Surface(model).open_edges().size(), 4u + 4u + 4u) << "and the blocks have no underside";
}

TEST(CornellBox, FacesLookIntoTheRoomAndOutOfTheBlocks) {
    const Model m = cornell_box();
    for (const Part& part : m.parts) {
        const bool block = part.name.find("block") != std::string::npos;
        glm::dvec3 middle(0.0);
        for (std::uint32_t i = 0; i < part.index_count; ++i)
            middle += glm::dvec3(m.vertices[m.indices[part.first_index + i]].position);
        middle /= double(part.index_count);
        if (!block) middle = {278, 274.4, 279.6};
        for (std::uint32_t i = 0; i < part.index_count; ++i) {
            const auto& v = m.vertices[m.indices[part.first_index + i]];
            const double outward = glm::dot(glm::dvec3(v.normal), glm::dvec3(v.position) - middle);
            EXPECT_TRUE(block ? outward > 0 : outward < 0) << part.name;
        }
    }
}

TEST(CornellBox, HasItsPublishedMaterialsAndSizes) {
    const Model m = cornell_box();
    std::map<std::string, std::string> materials;
    for (const Part& p : m.parts) materials[p.name] = m.materials[p.material].name;
    const std::map<std::string, std::string> expected = {
        {"floor", "white"},     {"ceiling", "white"},   {"back_wall", "white"},  {"right_wall", "green"},
        {"left_wall", "red"},   {"light", "light"},     {"short_block", "white"}, {"tall_block", "white"}};
    EXPECT_EQ(materials, expected);
    const auto area = [&](const std::string& name) {
        double sum = 0;
        for (const Part& p : m.parts) {
            if (p.name != name) continue;
            for (std::uint32_t i = p.first_index; i < p.first_index + p.index_count; i += 3) {
                const auto at = [&](int k) { return glm::dvec3(m.vertices[m.indices[i + k]].position); };
                sum += glm::length(glm::cross(at(1) - at(0), at(2) - at(0))) / 2;
            }
        }
        return sum;
    };
    EXPECT_NEAR(area("light"), 130 * 105, 1e-3);
    EXPECT_NEAR(area("ceiling") + area("light"), 556 * 559.2, 0.05);
    EXPECT_NEAR(area("right_wall"), 559.2 * 548.8, 0.05);
    EXPECT_GT(m.materials[3].emission.x, 0);
}

TEST(CornellBox, TheMeasuredCameraSeesRedOnTheLeftAndGreenOnTheRight) {
    const auto matrices = camera_matrices(cornell_camera(), 1);
    ASSERT_TRUE(matrices);
    const Model m = cornell_box();
    for (const auto& v : m.vertices) {
        const glm::vec4 clip = matrices->clip_from_world * glm::vec4(v.position, 1);
        EXPECT_TRUE(clip.z > -clip.w && clip.z < clip.w) << "between the planes";
    }
    const glm::vec4 left = matrices->clip_from_world * glm::vec4(552.8f, 0, 0, 1);
    const glm::vec4 right = matrices->clip_from_world * glm::vec4(0, 0, 0, 1);
    EXPECT_NEAR(left.x / left.w, -1, 0.05) << "the opening fills the picture";
    EXPECT_NEAR(right.x / right.w, 1, 0.05);
}

// ------------------------------------------------------------------------------------------- the cyclic trio

/// Where triangles a and b of a model overlap on the picture: 1 if a is nearer in all of it, -1 if b, 0 if
/// mixed or no overlap.
int nearer(const Model& m, const glm::mat4& clip_from_world, int a, int b) {
    const auto ndc = [&](int triangle, int corner) {
        const auto& v = m.vertices[m.indices[std::size_t(triangle * 3 + corner)]];
        const glm::dvec4 clip = glm::dmat4(clip_from_world) * glm::dvec4(v.position, 1.0);
        return glm::dvec3(clip) / clip.w;
    };
    // Depth of the triangle at (x, y), NaN outside.
    const auto depth = [&](int triangle, double x, double y) {
        const glm::dvec3 p = ndc(triangle, 0), q = ndc(triangle, 1), r = ndc(triangle, 2);
        const auto area = [](double ax, double ay, double bx, double by) { return ax * by - ay * bx; };
        const double whole = area(q.x - p.x, q.y - p.y, r.x - p.x, r.y - p.y);
        const double wq = area(x - p.x, y - p.y, r.x - p.x, r.y - p.y) / whole;
        const double wr = area(q.x - p.x, q.y - p.y, x - p.x, y - p.y) / whole;
        if (whole <= 0 || wq < 0 || wr < 0 || wq + wr > 1) return std::nan("");
        return p.z + wq * (q.z - p.z) + wr * (r.z - p.z);
    };
    int in_front = 0, behind = 0;
    for (int i = 0; i < 200; ++i) {
        for (int j = 0; j < 200; ++j) {
            const double x = (i - 100) / 100.0, y = (j - 100) / 100.0;
            const double za = depth(a, x, y), zb = depth(b, x, y);
            if (za < zb) ++in_front;
            if (za > zb) ++behind;
        }
    }
    return in_front > 20 && behind == 0 ? 1 : behind > 20 && in_front == 0 ? -1 : 0;
}

TEST(CyclicTrio, EachTriangleIsInFrontOfTheNext) {
    const Model m = cyclic_trio();
    ASSERT_EQ(m.triangle_count(), 3u);
    const Camera from_above_right = auto_frame({{-1.4f, -1.4f, -0.4f}, {1.4f, 1.4f, 0.4f}}, 1);
    Camera from_the_front;
    from_the_front.position = {0, 0, 8};
    for (const Camera& camera : {from_the_front, from_above_right}) {
        const auto matrices = camera_matrices(camera, 1);
        ASSERT_TRUE(matrices);
        for (int i = 0; i < 3; ++i) EXPECT_EQ(nearer(m, matrices->clip_from_world, i, (i + 1) % 3), 1) << i;
    }
}

}  // namespace
}  // namespace raster
