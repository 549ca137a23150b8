// camera.cpp: checking a camera, and placing one so that a box fills the picture.
#include <raster/scene/camera.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <string>

#include <raster/scene/transform.h>
#include <raster/scene/used_vertices.h>

namespace raster {
namespace {

std::string text(double number) {
    std::array<char, 32> room;
    const auto end = std::to_chars(room.data(), room.data() + room.size(), number).ptr;
    return std::string(room.data(), end);
}
std::string text(float number) {
    std::array<char, 32> room;
    const auto end = std::to_chars(room.data(), room.data() + room.size(), number).ptr;
    return std::string(room.data(), end);
}
std::string text(const glm::vec3& v) { return text(v.x) + "," + text(v.y) + "," + text(v.z); }

bool finite(const glm::vec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

template <int C, int R>
bool finite(const mat<C, R, float>& m) {
    for (int c = 0; c < C; ++c)
        for (int r = 0; r < R; ++r)
            if (!std::isfinite(m[c][r])) return false;
    return true;
}

Error wrong(const std::string& parameter, const std::string& what) {
    return {ErrorKind::usage, parameter + ": " + what};
}

/// Below this sine of the angle between two directions they count as parallel.
constexpr double parallel_sine = 1e-6;

Status check_placement(const Camera& camera) {
    const std::pair<const char*, const glm::vec3&> points[] = {
        {"camera-position", camera.position}, {"camera-focal-point", camera.focal_point}, {"up", camera.up}};
    for (const auto& [name, point] : points)
        if (!finite(point)) return wrong(name, text(point) + " is not finite");
    if (camera.position == camera.focal_point)
        return wrong("camera-position", text(camera.position) + " is the focal point, so there is no view");
    if (camera.up == glm::vec3(0.0f)) return wrong("up", "0,0,0 is no direction");

    const glm::dvec3 view = glm::dvec3(camera.focal_point) - glm::dvec3(camera.position), up(camera.up);
    const double sine = glm::length(glm::cross(glm::normalize(view), glm::normalize(up)));
    if (sine < parallel_sine)
        return wrong("up", text(camera.up) + " is parallel to the view direction");
    return Done{};
}

Status check_lens(const Camera& camera, double aspect) {
    const float angle = camera.view_angle;
    if (!(angle > 0 && angle < 180))
        return wrong("camera-view-angle", text(angle) + " is not above 0 and below 180 degrees");
    if (!(camera.near_plane > 0) || !std::isfinite(camera.near_plane))
        return wrong("near", text(camera.near_plane) + " is not a distance above 0");
    if (!(camera.far_plane > camera.near_plane) || !std::isfinite(camera.far_plane))
        return wrong("far",
                     text(camera.far_plane) + " is not a distance above near " + text(camera.near_plane));
    if (!(aspect > 0) || !std::isfinite(aspect))
        return wrong("aspect", text(aspect) + " is not a ratio above 0");
    return Done{};
}

glm::dvec3 limited(const glm::vec3& p) {
    glm::dvec3 r;
    for (int i = 0; i < 3; ++i) r[i] = std::isnan(p[i]) ? 0 : std::clamp(double(p[i]), -1e25, 1e25);
    return r;
}

/// The corners of a box, made drawable as auto_frame promises.
std::array<glm::dvec3, 8> corners_of(const Box& box) {
    glm::dvec3 low = limited(box.min), high = limited(box.max);
    const bool empty = low.x > high.x || low.y > high.y || low.z > high.z;
    if (empty) low = high = glm::dvec3(0.0);
    if (low == high) {
        // A cube that is still a cube when its corners are rounded to float.
        const double farthest = std::max({std::abs(low.x), std::abs(low.y), std::abs(low.z)});
        const double half = std::max(0.5, farthest * 1e-3);
        low -= half;
        high += half;
    }
    std::array<glm::dvec3, 8> corners;
    for (int i = 0; i < 8; ++i)
        corners[i] = {i & 1 ? high.x : low.x, i & 2 ? high.y : low.y, i & 4 ? high.z : low.z};
    return corners;
}

/// Finds the least distance from which all points are within 90 % of the picture.
class Framing {
public:
    Framing(const Box& box, double aspect, const glm::vec3& up, double view_angle) {
        const auto corners = corners_of(box);
        centre_ = (corners[0] + corners[7]) * 0.5;
        const glm::dvec3 above = glm::normalize(glm::dvec3(up));
        // The model's right-hand side is x, unless x is (nearly) up itself.
        const glm::dvec3 x = std::abs(above.x) > 0.999 ? glm::dvec3(0, 1, 0) : glm::dvec3(1, 0, 0);
        const glm::dvec3 front = glm::normalize(glm::cross(x, above));
        const glm::dvec3 side = glm::cross(above, front);
        const auto [sin_turn, cos_turn] = sin_cos_degrees(30);
        const auto [sin_raise, cos_raise] = sin_cos_degrees(20);
        toward_eye_ = (front * cos_turn + side * sin_turn) * cos_raise + above * sin_raise;
        right_ = glm::normalize(glm::cross(above, toward_eye_));
        upward_ = glm::cross(toward_eye_, right_);
        half_height_ = 0.9 * tan_degrees(view_angle / 2);
        half_width_ = half_height_ * aspect;
    }

    void include(const glm::dvec3& point) {
        // A point at (x, y, z) from the centre, in eye axes, is seen at |x| / (distance - z) of the tangent
        // of half the angle: each gives a least distance, and the largest of them holds for all.
        const glm::dvec3 p = point - centre_;
        const double z = glm::dot(p, toward_eye_);
        distance_ = std::max(distance_, z + std::abs(glm::dot(p, right_)) / half_width_);
        distance_ = std::max(distance_, z + std::abs(glm::dot(p, upward_)) / half_height_);
    }

    Camera camera(const glm::vec3& up, float view_angle) const {
        Camera camera;
        camera.focal_point = glm::vec3(centre_);
        camera.position = glm::vec3(centre_ + toward_eye_ * distance_);
        camera.up = up;
        camera.view_angle = view_angle;
        return camera;
    }

private:
    glm::dvec3 centre_, toward_eye_, right_, upward_;
    double half_width_, half_height_, distance_ = 0;
};

}  // namespace

Result<CameraMatrices> camera_matrices(const Camera& camera, double aspect) {
    if (const Status status = check_placement(camera); !status) return status.error();
    if (const Status status = check_lens(camera, aspect); !status) return status.error();

    CameraMatrices m;
    m.eye_from_world = look_at(camera.position, camera.focal_point, camera.up);
    m.clip_from_eye = perspective(camera.view_angle, aspect, camera.near_plane, camera.far_plane);
    m.clip_from_world = product(m.clip_from_eye, m.eye_from_world);
    if (!finite(m.clip_from_eye) || m.clip_from_eye[0][0] == 0 || m.clip_from_eye[1][1] == 0)
        return wrong("camera-view-angle",
                     text(camera.view_angle) + " is too extreme with aspect " + text(aspect) + ", near " +
                         text(camera.near_plane) + " and far " + text(camera.far_plane));
    if (!finite(m.eye_from_world) || !finite(m.clip_from_world))
        return wrong("camera-position", text(camera.position) + " is too far away");
    return m;
}

Camera auto_frame(const Box& box, double aspect, const glm::vec3& up, float view_angle) {
    Framing framing(box, aspect, up, view_angle);
    for (const glm::dvec3& corner : corners_of(box)) framing.include(corner);
    return with_planes_around(framing.camera(up, view_angle), box);
}

Camera auto_frame(const Model& model, double aspect, const glm::vec3& up, float view_angle) {
    const Box box = bounding_box(model);
    const bool has_size = box.min.x < box.max.x || box.min.y < box.max.y || box.min.z < box.max.z;
    if (!has_size) return auto_frame(box, aspect, up, view_angle);
    Framing framing(box, aspect, up, view_angle);
    for_each_used_vertex(model,
                         [&](const SurfaceVertex<float>& vertex) { framing.include(limited(vertex.position)); });
    return with_planes_around(framing.camera(up, view_angle), box);
}

Camera with_planes_around(Camera camera, const Box& box) {
    const glm::dvec3 position(camera.position);
    const glm::dvec3 to_focal_point = glm::dvec3(camera.focal_point) - position;
    const glm::dvec3 view = glm::normalize(to_focal_point);
    double nearest = HUGE_VAL, farthest = -HUGE_VAL;
    for (const glm::dvec3& corner : corners_of(box)) {
        const double depth = glm::dot(corner - position, view);
        nearest = std::min(nearest, depth);
        farthest = std::max(farthest, depth);
    }
    if (!(farthest > 0)) nearest = farthest = glm::length(to_focal_point);
    // A little room, so that rounding never clips a corner away.
    const double room = 0.01 * (farthest - nearest) + 1e-4 * farthest;
    const double far_plane = std::clamp(farthest + room, 1e-30, 3e38);
    camera.far_plane = float(far_plane);
    camera.near_plane = float(std::max(nearest - room, far_plane / 1000));
    return camera;
}

}  // namespace raster
