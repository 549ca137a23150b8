// shading_testing.h: seeded directions, packs from scalars, and small meshes for the shading tests.
#pragma once

#include <bit>
#include <cmath>
#include <vector>

#include <raster/scene/model.h>

#include "random.h"

namespace raster::testing {

inline glm::vec3 unit_vector(Random& random) {
    for (;;) {
        const float x = random.uniform(-1, 1), y = random.uniform(-1, 1), z = random.uniform(-1, 1);
        const float squared = x * x + y * y + z * z;
        if (squared > 0.01f && squared <= 1.0f) return glm::vec3(x, y, z) / std::sqrt(squared);
    }
}

/// The direction at an angle from +z in the plane of x and z.
inline glm::vec3 at_degrees(double degrees) {
    const double radians = degrees * 3.14159265358979323846 / 180.0;
    return {float(std::sin(radians)), 0.0f, float(std::cos(radians))};
}

template <class F>
void set_lane(F& pack, int i, float value) {
    if constexpr (lanes<F> == 1) {
        pack = value;
    } else {
        pack.v[i] = value;
    }
}

inline std::uint32_t bits_of(float x) { return std::bit_cast<std::uint32_t>(x); }

inline SurfaceVertex<float> vertex_at(glm::vec3 position, glm::vec3 normal = {0, 0, 1}, glm::vec2 uv = {0, 0},
                                      glm::vec3 color = glm::vec3(1.0f)) {
    return {position, normal, uv, color};
}

/// Appends a quadrilateral as two triangles; its corners run counter-clockwise seen from the tip of the normal.
inline void add_quad(Model& model, const std::array<glm::vec3, 4>& corners, glm::vec3 normal, int material = -1) {
    const auto first = std::uint32_t(model.vertices.size());
    const std::array<glm::vec2, 4> uv = {glm::vec2(0, 0), glm::vec2(1, 0), glm::vec2(1, 1), glm::vec2(0, 1)};
    for (std::size_t i = 0; i < 4; ++i) model.vertices.push_back(vertex_at(corners[i], normal, uv[i]));
    model.parts.push_back({"quad", material, std::uint32_t(model.indices.size()), 6});
    for (const std::uint32_t i : {0u, 1u, 2u, 0u, 2u, 3u}) model.indices.push_back(first + i);
}

/// A sphere of radius 1 around the origin with exact normals; `slices` around the z axis, half as many stacks.
inline Model sphere(int slices, float share_of_height = 1.0f) {
    Model model;
    const int stacks = slices / 2;
    for (int i = 0; i <= stacks; ++i) {
        for (int j = 0; j <= slices; ++j) {
            const double theta = 3.14159265358979 * share_of_height * i / stacks, phi = 6.28318530717959 * j / slices;
            const glm::vec3 p(float(std::sin(theta) * std::cos(phi)), float(std::sin(theta) * std::sin(phi)),
                              float(std::cos(theta)));
            model.vertices.push_back(vertex_at(p, p, {float(j) / float(slices), float(i) / float(stacks)}));
        }
    }
    for (int i = 0; i < stacks; ++i) {
        for (int j = 0; j < slices; ++j) {
            const auto a = std::uint32_t(i * (slices + 1) + j), b = a + 1, c = a + std::uint32_t(slices) + 1, d = c + 1;
            if (i > 0) model.indices.insert(model.indices.end(), {a, c, b});
            if (i + 1 < stacks || share_of_height < 1.0f) model.indices.insert(model.indices.end(), {b, c, d});
        }
    }
    model.parts.push_back({"sphere", -1, 0, std::uint32_t(model.indices.size())});
    return model;
}

}  // namespace raster::testing
