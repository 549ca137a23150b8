// Models put together: indices, places, normals, mirrors.
#include <raster/scene/append.h>

#include <limits>

#include <gtest/gtest.h>

#include <raster/scene/shapes.h>
#include <raster/scene/transform.h>

#include "shapes_testing.h"

namespace raster {
namespace {

Model painted_cube(int materials, int textures) {
    Model model = cube();
    for (int i = 0; i < materials; ++i)
        model.materials.emplace_back().diffuse_texture = textures > 0 ? i % textures : -1;
    for (int i = 0; i < textures; ++i) model.textures.push_back({"t" + std::to_string(i), {}});
    if (materials > 0) model.parts[0].material = materials - 1;
    return model;
}

TEST(Append, TheSecondModelKeepsItsMaterialsAndTextures) {
    Model scene = painted_cube(2, 1);
    ASSERT_TRUE(append(scene, painted_cube(3, 2), translate({5, 0, 0})));
    ASSERT_TRUE(append(scene, cube(), glm::mat4(1.0f)));
    ASSERT_EQ(scene.parts.size(), 3u);
    EXPECT_EQ(scene.parts[1].material, 2 + 2);
    EXPECT_EQ(scene.materials[4].diffuse_texture, 1 + 0);
    EXPECT_EQ(scene.materials[3].diffuse_texture, 1 + 1);
    EXPECT_EQ(scene.textures[2].name, "t1");
    EXPECT_EQ(scene.parts[2].material, -1) << "no material stays none";
    EXPECT_EQ(scene.parts[1].first_index, 36u);
    EXPECT_EQ(scene.triangle_count(), 36u);
    EXPECT_EQ(bounding_box(scene).max, glm::vec3(6, 1, 1));
}

TEST(Append, NormalsStandOnStretchedSurfacesAndHaveUnitLength) {
    Model scene;
    ASSERT_TRUE(append(scene, sphere(24, 12), product(rotate_z(30), scale({3, 0.5f, 1}))));
    for (std::size_t i = 0; i < scene.indices.size(); i += 3) {
        const auto &a = scene.vertices[scene.indices[i]], &b = scene.vertices[scene.indices[i + 1]],
                   &c = scene.vertices[scene.indices[i + 2]];
        const glm::vec3 n = glm::cross(b.position - a.position, c.position - a.position);
        EXPECT_GT(glm::dot(glm::normalize(n), glm::normalize(a.normal + b.normal + c.normal)), 0.9f);
        EXPECT_NEAR(glm::length(glm::dvec3(a.normal)), 1, 2e-7);
    }
}

TEST(Append, AMirroredModelKeepsItsOutside) {
    Model scene;
    ASSERT_TRUE(append(scene, teapot(4), scale({-1, 1, 1})));
    Model box_in_mirror;
    ASSERT_TRUE(append(box_in_mirror, cube(), scale({1, -2, 1})));
    EXPECT_NEAR(testing::Surface(box_in_mirror).volume(), 16, 1e-6);
    EXPECT_NEAR(bounding_box(scene).min.x, -bounding_box(teapot(4)).max.x, 0);
}

TEST(Append, WhatCannotBePlacedLeavesTheSceneAsItWas) {
    Model scene = cube();
    const float infinity = std::numeric_limits<float>::infinity();
    EXPECT_FALSE(append(scene, cube(), scale({1, 0, 1})));
    EXPECT_FALSE(append(scene, cube(), translate({infinity, 0, 0})));
    EXPECT_FALSE(append(scene, cube(), scale(infinity)));
    EXPECT_FALSE(append(scene, box({0, 0, 0}, {1e38f, 1, 1}), scale(10.0f)));
    EXPECT_EQ(scene.vertices.size(), cube().vertices.size());
    EXPECT_EQ(scene.parts.size(), 1u);
}

}  // namespace
}  // namespace raster
