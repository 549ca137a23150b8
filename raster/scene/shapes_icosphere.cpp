// shapes_icosphere.cpp: a sphere whose triangles are much the same size everywhere.
#include <raster/scene/shapes.h>

#include <algorithm>
#include <array>
#include <cmath>

#include <raster/math.h>
#include <raster/scene/shapes_builder.h>

namespace raster {
namespace {

constexpr double pi = 3.14159265358979323846;

/// The corners of the icosahedron, a tip up: two tips and two rings of five, of latitude atan(1/2) up and down.
std::array<glm::dvec3, 12> icosahedron_corners() {
    std::array<glm::dvec3, 12> corners;
    const double height = 1 / std::sqrt(5.0), radius = 2 * height;
    corners[0] = {0, -1, 0};
    corners[11] = {0, 1, 0};
    for (int i = 0; i < 5; ++i) {
        const auto [s, c] = sin_cos_degrees(72.0 * i);
        corners[std::size_t(1 + i)] = {-s * radius, -height, -c * radius};
        const auto [s2, c2] = sin_cos_degrees(72.0 * i + 36.0);
        corners[std::size_t(6 + i)] = {-s2 * radius, height, -c2 * radius};
    }
    return corners;
}

/// The texture coordinate around, 0 to 1 from -z by -x, within half a turn of `near`.
double around(const glm::dvec3& p, double near) {
    const double u = double(atan2(float(-p.x), float(-p.z))) / (2 * pi);
    return u + std::floor(near - u + 0.5);
}

/// One side of the icosahedron, its edges in n pieces, pushed out onto the sphere. Edges give the same bits on both
/// their sides: of three products one is 0, and two commute.
void add_side(detail::ModelBuilder& builder, const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, int n) {
    const glm::dvec3 middle = a + b + c;
    // A side is a fifth of a turn wide at most, so that from 0.1 on none begins below 0.
    const double u_middle = around(middle, 0.55);
    std::vector<detail::ModelBuilder::Index> before, row;
    for (int j = 0; j <= n; ++j) {
        row.clear();
        for (int i = 0; i + j <= n; ++i) {
            const glm::dvec3 p = (a * double(n - i - j) + b * double(i)) + c * double(j);
            const glm::dvec3 unit = p / std::sqrt(glm::dot(p, p));
            const bool is_pole = std::abs(unit.y) == 1;
            const double u = is_pole ? u_middle : std::max(around(unit, u_middle), 0.0);
            const double v = std::max(1 - double(acos(float(unit.y))) / pi, 0.0);
            row.push_back(builder.vertex(unit, unit, {u, v}));
        }
        for (std::size_t i = 0; i < row.size() && j > 0; ++i) {
            builder.triangle(before[i], before[i + 1], row[i]);
            if (i + 1 < row.size()) builder.triangle(before[i + 1], row[i + 1], row[i]);
        }
        before.swap(row);
    }
}

}  // namespace

Model icosphere(int divisions) {
    const int n = std::clamp(divisions, 1, 256);
    const std::array<glm::dvec3, 12> corner = icosahedron_corners();
    detail::ModelBuilder builder;
    for (std::size_t i = 0; i < 5; ++i) {
        const std::size_t next = (i + 1) % 5;
        const glm::dvec3 &low = corner[1 + i], &low_next = corner[1 + next];
        const glm::dvec3 &high = corner[6 + i], &high_next = corner[6 + next];
        add_side(builder, corner[0], low_next, low, n);
        add_side(builder, low, low_next, high, n);
        add_side(builder, low_next, high_next, high, n);
        add_side(builder, corner[11], high, high_next, n);
    }
    builder.part("icosphere");
    return builder.take();
}

}  // namespace raster
