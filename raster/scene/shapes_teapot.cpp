// shapes_teapot.cpp: the Utah teapot: bicubic Bezier patches cut into triangles.
#include <raster/scene/shapes.h>

#include <algorithm>
#include <array>
#include <string>
#include <string_view>

#include <raster/scene/shapes_builder.h>
#include <raster/scene/shapes_teapot_data.h>

namespace raster {
namespace {

/// Weights of four control points: Bernstein's polynomials of degree 3, and their derivatives.
struct Weights {
    std::array<double, 4> value, slope;
};

/// At t = i / n. Written so that i and n - i give the same numbers in reverse: patches that share an edge in
/// opposite directions then get the same points on it, to the last bit.
Weights bernstein(int i, int n) {
    const double t = double(i) / n, s = double(n - i) / n;
    return {{s * s * s, 3 * (s * s * t), 3 * (t * t * s), t * t * t},
            {-3 * s * s, 3 * (s * s) - 6 * (s * t), 6 * (s * t) - 3 * (t * t), 3 * t * t}};
}

glm::dvec3 weigh(const std::array<double, 4>& w, const glm::dvec3 (&p)[4]) {
    return (w[0] * p[0] + w[3] * p[3]) + (w[1] * p[1] + w[2] * p[2]);
}

struct SurfacePoint {
    glm::dvec3 position, normal;
};

SurfacePoint evaluate(const glm::dvec3 (&points)[4][4], const Weights& across, const Weights& along,
                      bool first_row) {
    glm::dvec3 row[4], row_slope[4];
    for (int r = 0; r < 4; ++r) {
        row[r] = weigh(across.value, points[r]);
        row_slope[r] = weigh(across.slope, points[r]);
    }
    // Where the whole first row is one point (the knob of the lid, the middle of the bottom), the surface
    // does not move across. Close by it moves in proportion to the distance, so the mixed derivative gives
    // the direction.
    const bool pole = first_row && points[0][0] == points[0][3];
    const glm::dvec3 move_across = weigh(pole ? along.slope : along.value, row_slope);
    const glm::dvec3 move_along = weigh(along.slope, row);
    return {weigh(along.value, row), glm::cross(move_across, move_along)};
}

std::string_view part_of(int patch) {
    return patch < 4    ? "rim"
           : patch < 12 ? "body"
           : patch < 16 ? "handle"
           : patch < 20 ? "spout"
           : patch < 28 ? "lid"
                        : "bottom";
}

}  // namespace

Model teapot(int subdivisions) {
    const int n = std::clamp(subdivisions, 1, 256);
    detail::ModelBuilder builder;
    for (int patch = 0; patch < 32; ++patch) {
        glm::dvec3 points[4][4];
        for (int i = 0; i < 16; ++i) {
            const auto& p = detail::teapot_points[detail::teapot_patches[patch][i] - 1];
            points[i / 4][i % 4] = {p[0], p[2], -p[1]};  // Newell's z is up, ours is y
        }
        const auto first = detail::ModelBuilder::Index(patch * (n + 1) * (n + 1));
        for (int i = 0; i <= n; ++i) {
            for (int j = 0; j <= n; ++j) {
                const auto [position, normal] = evaluate(points, bernstein(j, n), bernstein(i, n), i == 0);
                builder.vertex(position, normal, {double(n - j) / n, double(n - i) / n});
            }
        }
        for (int i = 0; i < n; ++i) {
            for (int j = 0; j < n; ++j) {
                const auto a = first + i * (n + 1) + j, c = a + n + 2;
                builder.quad(a, a + 1, c, c - 1);
            }
        }
        if (patch == 31 || part_of(patch + 1) != part_of(patch)) builder.part(std::string(part_of(patch)));
    }
    return builder.take();
}

}  // namespace raster
