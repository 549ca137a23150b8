// triangulate.cpp: polygons onto a plane; fans where they do. The ears are in triangulate_ears.cpp.
#include <raster/scene/triangulate.h>

#include <algorithm>
#include <cmath>

namespace raster {
namespace {

/// Newell's method: the sum of the edges' cross products is twice the vector area, also of a bent polygon.
glm::dvec3 vector_area(std::span<const glm::vec3> corners) {
    glm::dvec3 sum(0.0);
    const glm::dvec3 origin(corners[0]);
    for (std::size_t i = 1; i + 1 < corners.size(); ++i)
        sum += glm::cross(glm::dvec3(corners[i]) - origin, glm::dvec3(corners[i + 1]) - origin);
    return sum;
}

/// A coordinate system across the polygon's normal, for polygons that are not flat.
struct FacePlane {
    glm::dvec3 origin, u, v;  ///< u and v so long that all corners have coordinates from -2 to 2
    bool is_bent;

    glm::vec2 project(const glm::vec3& p) const {
        const glm::dvec3 d = glm::dvec3(p) - origin;
        return glm::vec2(glm::dvec2(glm::dot(d, u), glm::dot(d, v)));
    }
};

FacePlane make_plane(std::span<const glm::vec3> corners, const glm::dvec3& area) {
    const double length = std::sqrt(glm::dot(area, area));
    if (!(length > 0)) return {};
    const glm::dvec3 n = area / length;
    double out = 0, extent = 0;
    for (const glm::vec3& p : corners) {
        const glm::dvec3 d = glm::dvec3(p) - glm::dvec3(corners[0]);
        out = std::max(out, std::abs(glm::dot(d, n)));
        extent = std::max({extent, std::abs(d.x), std::abs(d.y), std::abs(d.z)});
    }
    // Across the axis that is farthest from the normal.
    const glm::dvec3 size = glm::abs(n);
    glm::dvec3 axis(0, 0, 1);
    if (size.x <= size.y && size.x <= size.z) {
        axis = {1, 0, 0};
    } else if (size.y <= size.z) {
        axis = {0, 1, 0};
    }
    const glm::dvec3 u = glm::cross(axis, n), v = glm::cross(n, u);
    return {glm::dvec3(corners[0]), u / (std::sqrt(glm::dot(u, u)) * extent), v / (std::sqrt(glm::dot(v, v)) * extent),
            out > 1e-4 * extent};
}

}  // namespace

bool has_zero_area(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
    const glm::dvec3 n = glm::cross(glm::dvec3(b) - glm::dvec3(a), glm::dvec3(c) - glm::dvec3(a));
    return n.x == 0 && n.y == 0 && n.z == 0;
}

void Triangulator::operator()(std::span<const glm::vec3> corners, std::vector<std::uint32_t>& triangles) {
    if (corners.size() < 3) return;
    if (corners.size() == 3) {
        if (!has_zero_area(corners[0], corners[1], corners[2])) triangles.insert(triangles.end(), {0, 1, 2});
        return;
    }
    corners_ = corners;
    triangles_ = &triangles;
    const bool has_plane = project();
    if (ring_.size() < 3) return;
    if (!has_plane) return fan_in_space(0);
    if (fan_from(0) || (ring_.size() == 4 && fan_from(1))) return;
    clip_ears();
}

/// Fills ring_ with the corners as seen, without repetitions in a row. False if there is nowhere to see them from.
bool Triangulator::project() {
    const glm::dvec3 area = vector_area(corners_);
    const glm::dvec3 size = glm::abs(area);
    // Two of the three coordinates, in the order that makes the area positive. They are exact, unlike those along
    // the normal, so whatever is collinear stays so.
    int u = 0, v = 1;
    double chosen = area.z;
    if (size.x > size.y && size.x > size.z) {
        u = 1, v = 2, chosen = area.x;
    } else if (size.y > size.z) {
        u = 2, v = 0, chosen = area.y;
    }
    if (chosen < 0) std::swap(u, v);
    const FacePlane plane = make_plane(corners_, area);

    ring_.clear();
    const glm::vec3* last = &corners_.back();
    for (std::uint32_t i = 0; i < corners_.size(); ++i) {
        const glm::vec3& p = corners_[i];
        const glm::vec2 at = plane.is_bent ? plane.project(p) : glm::vec2(p[u], p[v]);
        if (p != *last) ring_.push_back({at, i, 0, 0, 0, 0, false, true});
        last = &p;
    }
    left_ = std::uint32_t(ring_.size());
    for (std::uint32_t i = 0; i < left_; ++i) {
        ring_[i].previous = i == 0 ? left_ - 1 : i - 1;
        ring_[i].next = i + 1 == left_ ? 0 : i + 1;
    }
    return chosen != 0;
}

/// Twice the signed area of abc, positive if it runs counter-clockwise. The differences of floats are exact in
/// double unless their exponents lie far apart, so for sane polygons the sign is too.
double Triangulator::signed_area(const glm::vec2& a, const glm::vec2& b, const glm::vec2& c) {
    const glm::dvec2 p(a), q(b), r(c);
    return (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x);
}

double Triangulator::turn(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
    return signed_area(ring_[a].at, ring_[b].at, ring_[c].at);
}

/// The fan is right if the directions from the apex to the other corners all turn one way: then the apex sees all of
/// the polygon.
bool Triangulator::fan_from(std::uint32_t apex) {
    const auto n = std::uint32_t(ring_.size());
    const auto nth = [&](std::uint32_t i) { return apex + i < n ? apex + i : apex + i - n; };
    for (std::uint32_t i = 1; i + 1 < n; ++i)
        if (!(turn(apex, nth(i), nth(i + 1)) > 0)) return false;
    fan_in_space(apex);
    return true;
}

/// A fan from the apex over what is left, whatever its shape. For what has no plane to be seen on, such as a bow tie
/// of equal halves, it is as good as any.
void Triangulator::fan_in_space(std::uint32_t apex) {
    for (std::uint32_t b = ring_[apex].next; left_ > 2 && ring_[b].next != apex; b = ring_[b].next)
        emit(apex, b, ring_[b].next);
}

void Triangulator::emit(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    const std::uint32_t corner[] = {ring_[a].corner, ring_[b].corner, ring_[c].corner};
    if (!has_zero_area(corners_[corner[0]], corners_[corner[1]], corners_[corner[2]]))
        triangles_->insert(triangles_->end(), std::begin(corner), std::end(corner));
}

}  // namespace raster
