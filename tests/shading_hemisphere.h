// shading_hemisphere.h: sums over the directions above a surface, for tests of energy.
#pragma once

#include <raster/shading/reflectance.h>

#include "shading_testing.h"

namespace raster::testing {

/// A direction above the surface with the normal +z.
inline glm::vec3 direction_above(float cosine, float azimuth) {
    const float sine = std::sqrt(std::max(1 - cosine * cosine, 0.0f));
    return {sine * std::cos(azimuth), sine * std::sin(azimuth), cosine};
}

/// The mean over the directions above +z, each once in a grid with a seeded place in its cell: the integral over the
/// hemisphere divided by 2 pi. Cells are narrow where `toward` points, if it is given: the grid's azimuth starts there.
template <class Function>
auto hemisphere_mean(Random& random, int steps, const Function& f) {
    auto sum = f(glm::vec3(0, 0, 1)) * 0.0f;
    for (int i = 0; i < steps; ++i) {
        decltype(sum) row = sum * 0.0f;
        for (int j = 0; j < 2 * steps; ++j) {
            const float c = (float(i) + random.uniform(0, 1)) / float(steps);
            const float phi = (float(j) + random.uniform(0, 1)) * 3.14159265f / float(steps);
            row += f(direction_above(c, phi));
        }
        sum += row / float(2 * steps);
    }
    return sum / float(steps);
}

/// A surface with the normal +z and the grain along x, seen from v.
inline Frame<float> flat_frame(const glm::vec3& v) {
    return make_frame(glm::vec3(0, 0, 1), v, glm::vec3(1, 0, 0));
}

/// How much of the light that comes from everywhere alike goes to v, with kd and ks: 1 is all. By reciprocity also how
/// much of the light from v is reflected.
template <class Model>
glm::vec3 albedo(const Model& model, const glm::vec3& v, float kd, float ks, int steps = 150) {
    Random random(9);
    const auto frame = flat_frame(v);
    return 2.0f * hemisphere_mean(random, steps, [&](const glm::vec3& l) {
        const auto value = model.evaluate(frame, l);
        return value.diffuse * kd + value.specular * ks;
    });
}

}  // namespace raster::testing
