// scene_normals_test.cpp: made-up normals against shapes whose normals are known on paper.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include <raster/scene/normals.h>

#include "random.h"

namespace raster {
namespace {

using Positions = std::vector<glm::vec3>;
using Indices = std::vector<std::uint32_t>;
using Groups = std::vector<std::uint32_t>;

const Positions cube_positions{{-1, -1, -1}, {1, -1, -1}, {1, 1, -1}, {-1, 1, -1},
                               {-1, -1, 1},  {1, -1, 1},  {1, 1, 1},  {-1, 1, 1}};
const Indices cube_indices{0, 3, 2, 0, 2, 1, 4, 5, 6, 4, 6, 7, 0, 1, 5, 0, 5, 4,
                           2, 3, 7, 2, 7, 6, 1, 2, 6, 1, 6, 5, 0, 4, 7, 0, 7, 3};
const glm::vec3 cube_faces[6] = {{0, 0, -1}, {0, 0, 1}, {0, -1, 0}, {0, 1, 0}, {1, 0, 0}, {-1, 0, 0}};

void expect_near(const glm::vec3& a, const glm::vec3& b, float tolerance = 1e-6f) {
    EXPECT_LE(glm::length(a - b), tolerance)
        << a.x << " " << a.y << " " << a.z << " instead of " << b.x << " " << b.y << " " << b.z;
}

TEST(Normals, ACubeIsSharpBelowNinetyDegreesAndRoundFromThereOn) {
    const auto sharp = make_normals(cube_positions, {cube_indices, {}, {}}, {.angle = 89.9f});
    const auto round = make_normals(cube_positions, {cube_indices, {}, {}}, {.angle = 90});
    ASSERT_EQ(sharp.size(), cube_indices.size());
    for (std::size_t c = 0; c < cube_indices.size(); ++c) {
        EXPECT_EQ(sharp[c], cube_faces[c / 6]);
        // Each corner of a cube sees its three faces as one or two triangles, so the mean leans to some; the
        // side a normal is on is certain.
        for (int k = 0; k < 3; ++k) EXPECT_GT(round[c][k] * cube_positions[cube_indices[c]][k], 0);
    }
}

TEST(Normals, PolygonsCountAsSuch) {
    // As quads, however they will be cut, a cube's corners have the diagonals for normals.
    const Indices quads{0, 3, 2, 1, 4, 5, 6, 7, 0, 1, 5, 4, 2, 3, 7, 6, 1, 2, 6, 5, 0, 4, 7, 3};
    const Indices ends{4, 8, 12, 16, 20, 24};
    const auto round = make_normals(cube_positions, {quads, ends, {}}, {.angle = 90});
    const auto sharp = make_normals(cube_positions, {quads, ends, {}}, {.angle = 89});
    for (std::size_t c = 0; c < quads.size(); ++c) {
        expect_near(round[c], glm::normalize(cube_positions[quads[c]]));
        EXPECT_EQ(sharp[c], cube_faces[c / 4]);
    }
}

TEST(Normals, FacesWithAPositionThatIsNotFiniteTakeNoPart) {
    const float nan = std::nanf("");
    const Positions p{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {nan, 0, 1}};
    const Indices t{0, 1, 2, 0, 1, 3};
    const auto normals = make_normals(p, {t, {}, {}}, {.angle = 180});
    for (int c = 0; c < 3; ++c) EXPECT_EQ(normals[c], glm::vec3(0, 0, 1));
}

TEST(Normals, TheDefaultKeepsACubeSharp) {
    EXPECT_EQ(make_normals(cube_positions, {cube_indices, {}, {}}),
              make_normals(cube_positions, {cube_indices, {}, {}}, {.angle = 0}));
}

TEST(Normals, AreUnitLengthAndPointOutOfASphere) {
    // An octahedron, each face cut in four, three times over, with the corners pushed out to the sphere.
    Positions p{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
    Indices t{0, 2, 4, 2, 1, 4, 1, 3, 4, 3, 0, 4, 2, 0, 5, 1, 2, 5, 3, 1, 5, 0, 3, 5};
    for (int level = 0; level < 3; ++level) {
        Indices finer;
        for (std::size_t i = 0; i < t.size(); i += 3) {
            std::uint32_t middle[3];
            for (int k = 0; k < 3; ++k) {
                middle[k] = std::uint32_t(p.size());  // not shared: corners meet by position
                p.push_back(glm::normalize(p[t[i + k]] + p[t[i + (k + 1) % 3]]));
            }
            for (std::uint32_t corner : {t[i], middle[0], middle[2], middle[0], t[i + 1], middle[1], middle[2],
                                         middle[1], t[i + 2], middle[0], middle[1], middle[2]})
                finer.push_back(corner);
        }
        t = finer;
    }
    const auto normals = make_normals(p, {t, {}, {}});
    for (std::size_t c = 0; c < t.size(); ++c) {
        EXPECT_NEAR(glm::length(normals[c]), 1, 1e-6);
        EXPECT_GT(glm::dot(normals[c], p[t[c]]), 0.99f);
    }
}

TEST(Normals, LargeTrianglesWeighMore) {
    // A square of area 4 lying down and one of area 1 standing up, hinged at the origin.
    const Positions p{{0, 0, 0}, {2, 0, 0}, {2, 0, 2}, {0, 0, 2}, {0, 1, 0}, {-0.0f, 0, 0}, {0, 0, 1}};
    const Indices t{0, 2, 1, 5, 6, 4};  // normals (0, 1, 0) with area 2 and (-1, 0, 0) with area 0.5
    const auto normals = make_normals(p, {t, {}, {}}, {.angle = 180});
    const glm::vec3 mean = glm::normalize(glm::vec3(-0.5f, 2, 0));
    expect_near(normals[0], mean);
    expect_near(normals[3], mean);  // -0 is the same place as 0
    EXPECT_EQ(normals[1], glm::vec3(0, 1, 0));
    EXPECT_EQ(normals[4], glm::vec3(-1, 0, 0));
}

TEST(Normals, SmoothingGroupsAreKeptApartAndOffIsFlat) {
    // A sheet bent by 30 degrees: two quads of two triangles each.
    const float c = std::sqrt(3.0f) / 2;
    const Positions p{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {1 + c, 0, 0.5f}, {1 + c, 1, 0.5f}};
    const Indices t{0, 1, 2, 0, 2, 3, 1, 4, 5, 1, 5, 2};
    const glm::vec3 left(0, 0, 1), right(-0.5f, 0, c);
    const auto seam = [&](const Groups& groups, const Creases& creases = {}) {
        const auto normals = make_normals(p, {t, {}, groups}, creases);
        expect_near(normals[0], left);
        expect_near(normals[7], right);
        return std::pair(normals[2], normals[11]);  // the same position, seen from both sides
    };
    auto [l, r] = seam({});
    EXPECT_EQ(l, r);
    std::tie(l, r) = seam({0, 0, 0, 0});
    expect_near(l, left), expect_near(r, right);
    std::tie(l, r) = seam({1, 1, 2, 2});
    expect_near(l, left), expect_near(r, right);
    std::tie(l, r) = seam({5, 5, 5, 5}, {.angle = 10});
    EXPECT_EQ(l, r);
    std::tie(l, r) = seam({5, 5, 5, 5}, {.angle = 10, .within_groups = true});
    expect_near(l, left), expect_near(r, right);
}

TEST(Normals, BothSidesOfASheetKeepTheirOwnWhenTheyCancel) {
    const Positions p{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    const Indices t{0, 1, 2, 0, 2, 1};
    const auto normals = make_normals(p, {t, {}, {}}, {.angle = 180});
    EXPECT_EQ(normals[0], glm::vec3(0, 0, 1));
    EXPECT_EQ(normals[3], glm::vec3(0, 0, -1));
}

TEST(Normals, HugeTinyAndFlatTrianglesAreFinite) {
    for (const float scale : {1e-30f, 1e-20f, 1.0f, 1e20f, 3e38f}) {
        const Positions p{{0, 0, 0}, {scale, 0, 0}, {0, scale, 0}, {scale, scale, scale}};
        const Indices t{0, 1, 2, 1, 3, 2, 0, 0, 1};
        const auto normals = make_normals(p, {t, {}, {}}, {.angle = 180});
        for (const glm::vec3& n : normals) EXPECT_NEAR(glm::length(n), 1, 1e-6) << scale;
        EXPECT_EQ(normals[0], glm::vec3(0, 0, 1)) << scale;
        EXPECT_EQ(normals[6], normals[0]) << scale;  // no area: in company it takes the company's
    }
}

TEST(Normals, AThousandTrianglesAroundOnePointShareAcrossCreases) {
    Positions p{{0, 0, 1}};
    Indices t;
    for (int i = 0; i < 1000; ++i) {
        const double angle = 2 * 3.14159265358979 * i / 1000;
        p.push_back({float(std::cos(angle)), float(std::sin(angle)), 0.0f});
        t.insert(t.end(), {0, std::uint32_t(1 + i), std::uint32_t(1 + (i + 1) % 1000)});
    }
    expect_near(make_normals(p, {t, {}, {}}, {.angle = 1})[0], {0, 0, 1}, 1e-5f);
    Groups halves(1000, 1);
    std::fill(halves.begin() + 500, halves.end(), 2);
    const auto apart = make_normals(p, {t, {}, halves}, {.angle = 1});
    EXPECT_GT(apart[0].y, 0.1f);
    EXPECT_LT(apart[3 * 600].y, -0.1f);
    const Groups off(1000, smoothing_off);
    const auto flat = make_normals(p, {t, {}, off}, {.angle = 1});
    expect_near(flat[0], glm::normalize(glm::cross(p[1] - p[0], p[2] - p[0])));
}

TEST(Normals, RotatingACornersListChangesNothing) {
    testing::Random random(5);
    Positions p;
    for (int i = 0; i < 40; ++i) p.push_back({random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)});
    Indices t, turned;
    for (int i = 0; i < 100; ++i) {
        std::uint32_t corner[3];
        for (auto& k : corner) k = std::uint32_t(random.integer(0, 39));
        if (corner[0] == corner[1] || corner[1] == corner[2] || corner[2] == corner[0]) continue;
        t.insert(t.end(), {corner[0], corner[1], corner[2]});
        turned.insert(turned.end(), {corner[1], corner[2], corner[0]});
    }
    const auto a = make_normals(p, {t, {}, {}}, {.angle = 180}), b = make_normals(p, {turned, {}, {}}, {.angle = 180});
    for (std::size_t i = 0; i < t.size(); ++i) expect_near(a[i], b[i - i % 3 + (i + 2) % 3], 1e-5f);
}

}  // namespace
}  // namespace raster
