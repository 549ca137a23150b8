// shapes_round.cpp: surfaces of revolution, and the round solids that are some.
#include <raster/scene/shapes.h>

#include <algorithm>
#include <cmath>

#include <raster/math.h>
#include <raster/scene/shapes_builder.h>

namespace raster {
namespace {

/// The normal on the right of the way from a to b.
glm::dvec2 right_of(const glm::dvec2& a, const glm::dvec2& b) {
    const glm::dvec2 d = b - a;
    return glm::dvec2(d.y, -d.x) / std::sqrt(glm::dot(d, d));
}

/// A circle of the profile plane from one angle to another in degrees, counted from the outward direction
/// upwards.
std::vector<ProfilePoint> arc(const glm::dvec2& centre, double radius, double from, double to, int steps) {
    std::vector<ProfilePoint> profile;
    for (int j = 0; j <= steps; ++j) {
        const auto [s, c] = sin_cos_degrees(from + (to - from) * j / steps);
        profile.push_back({centre + radius * glm::dvec2(c, s), {c, s}});
    }
    return profile;
}

Model named(const std::vector<ProfilePoint>& profile, int segments, const char* name) {
    Model model = surface_of_revolution(profile, segments);
    model.parts[0].name = name;
    return model;
}

}  // namespace

std::vector<ProfilePoint> smooth_profile(std::span<const glm::dvec2> points) {
    std::vector<ProfilePoint> profile;
    const std::size_t n = points.size();
    if (n < 2) return profile;
    const bool closed = points.front() == points.back();
    for (std::size_t i = 0; i < n; ++i) {
        // The ends of a closed profile have each other's neighbours.
        const glm::dvec2& p = points[i];
        const glm::dvec2& before = i > 0 ? points[i - 1] : closed ? points[n - 2] : p;
        const glm::dvec2& after = i + 1 < n ? points[i + 1] : closed ? points[1] : p;
        glm::dvec2 normal(0.0);
        if (before != p) normal += right_of(before, p);
        if (after != p) normal += right_of(p, after);
        const double length = std::sqrt(glm::dot(normal, normal));
        // A profile that turns back on itself has no mean; then it is outward.
        profile.push_back({p, length > 1e-9 ? normal / length : glm::dvec2(1, 0)});
    }
    return profile;
}

Model surface_of_revolution(std::span<const ProfilePoint> profile, int segments) {
    const int n = std::clamp(segments, 3, 1024);
    const int rings = profile.size() < 2 ? 0 : int(profile.size()) - 1;
    detail::ModelBuilder builder;
    for (int j = 0; rings > 0 && j <= rings; ++j) {
        const auto& [position, normal] = profile[j];
        for (int i = 0; i <= n; ++i) {
            // The last column repeats the first one's place, not its texture coordinate.
            const auto [s, c] = sin_cos_degrees(360.0 * (i % n) / n);
            const glm::dvec3 radial(-s, 0, -c);
            // At a pole each triangle has its own tip, in the middle of its strip of the texture.
            const double u = position.x == 0 && i < n ? i + 0.5 : i;
            builder.vertex(radial * position.x + glm::dvec3(0, position.y, 0),
                           radial * normal.x + glm::dvec3(0, normal.y, 0), {u / n, double(j) / rings});
        }
    }
    for (int j = 0; j < rings; ++j) {
        for (int i = 0; i < n; ++i) {
            const auto a = detail::ModelBuilder::Index(j * (n + 1) + i), c = a + n + 2;
            if (profile[j].position.x == 0)
                builder.triangle(a, c, c - 1);
            else if (profile[j + 1].position.x == 0)
                builder.triangle(a, a + 1, c - 1);
            else
                builder.quad(a, a + 1, c, c - 1);
        }
    }
    builder.part("surface_of_revolution");
    return builder.take();
}

Model sphere(int segments, int rings) {
    return named(arc({0, 0}, 1, -90, 90, std::clamp(rings, 2, 1024)), segments, "sphere");
}

Model torus(float tube_radius, int segments, int sides) {
    const double tube = tube_radius > 0.001f ? std::min(double(tube_radius), 0.999) : 0.001;  // NaN too
    return named(arc({1, 0}, tube, -180, 180, std::clamp(sides, 3, 1024)), segments, "torus");
}

Model bowl(int segments, int rings) {
    return named(arc({0, 0}, 1, -90, 0, std::clamp(rings, 1, 1024)), segments, "bowl");
}

}  // namespace raster
