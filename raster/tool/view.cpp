// view.cpp: from camera flags to matrices.
#include "view.h"

#include <algorithm>
#include <cmath>

#include <raster/math.h>

namespace raster::tool {
namespace {

/// Turns v around an axis by an angle, in double precision (Rodrigues 1840).
glm::dvec3 turned(const glm::dvec3& v, double degrees, const glm::dvec3& axis) {
    const auto [s, c] = sin_cos_degrees(degrees);
    const glm::dvec3 a = glm::normalize(axis);
    return v * c + glm::cross(a, v) * s + a * (glm::dot(a, v) * (1.0 - c));
}

/// The camera moved around its focal point: to the right by `azimuth`, up by `elevation` degrees.
Camera orbited(Camera camera, double azimuth, double elevation) {
    const glm::dvec3 focal_point(camera.focal_point), up(camera.up);
    glm::dvec3 arm = glm::dvec3(camera.position) - focal_point;
    if (azimuth != 0) arm = turned(arm, azimuth, up);
    const glm::dvec3 left = glm::cross(arm, up);
    if (elevation != 0 && left != glm::dvec3(0.0)) arm = turned(arm, elevation, left);
    if (azimuth != 0 || elevation != 0) camera.position = glm::vec3(focal_point + arm);
    return camera;
}

/// A box that looks as large from every side around `up`: what turns inside it stays inside the picture.
Box turnable(const Box& box, const glm::vec3& up) {
    const glm::vec3 centre = box.min * 0.5f + box.max * 0.5f, half = box.max * 0.5f - box.min * 0.5f;
    const glm::vec3 axis = glm::normalize(up);
    const float height = glm::dot(glm::abs(axis), half);
    float radius = 0;
    for (const float x : {half.x, -half.x}) {
        for (const float y : {half.y, -half.y}) {
            const glm::vec3 corner(x, y, half.z);
            radius = std::max(radius, glm::length(corner - axis * glm::dot(corner, axis)));
        }
    }
    const glm::vec3 reach = glm::abs(axis) * height + glm::sqrt(glm::max(1.0f - axis * axis, 0.0f)) * radius;
    return {centre - reach, centre + reach};
}

Result<float> parse_view_angle(std::string_view text) {
    Result<float> angle = parse_number(text);
    if (angle && !(*angle > 0 && *angle < 180))
        return Error{ErrorKind::usage, in_quotes(text) + " is not above 0 and below 180 degrees"};
    return angle;
}

Result<float> parse_distance(std::string_view text) {
    Result<float> distance = parse_number(text);
    if (distance && !(*distance > 0)) return Error{ErrorKind::usage, in_quotes(text) + " is no distance above 0"};
    return distance;
}

}  // namespace

void add_view_flags(CLI::App& app, ViewFlags& flags) {
    const auto angle = [](std::string_view text) { return parse_number_within(text, -360.0f, 360.0f); };
    add_value(app, "-s,--size", "WxH", flags.size, parse_size,
              "Size of the picture in pixels, at most 16384 a side and 134217728 in all. [800x600]")
        ->group("Picture");

    const auto camera = [](CLI::Option* option) { option->group("Camera"); };
    camera(add_value(app, "--camera-position", "X,Y,Z", flags.position, parse_vector,
                     "Where the eye is. [30 degrees right of the front and 20 above, so that the model fills 90 % of"
                     " the picture; the front is +Z, or -Y where up is Z]"));
    camera(add_value(app, "--camera-focal-point", "X,Y,Z", flags.focal_point, parse_vector,
                     "What the eye looks at. [the middle of the model]"));
    camera(add_value(app, "--up", "DIRECTION", flags.up, parse_direction,
                     "What is up on the picture: +X, -X, +Y, -Y, +Z, -Z or X,Y,Z. [+Y]"));
    camera(add_value(app, "--camera-view-angle", "DEG", flags.view_angle, parse_view_angle,
                     "Vertical view angle in degrees, above 0 and below 180. [30]"));
    camera(add_value(app, "--camera-azimuth-angle,--camera-azimuth", "DEG", flags.azimuth, angle,
                     "Then moves the eye this far to the right, around the focal point; -360 to 360. [0]"));
    camera(add_value(app, "--camera-elevation-angle,--camera-elevation", "DEG", flags.elevation, angle,
                     "Then moves the eye this far up, around the focal point; -360 to 360. [0]"));
    camera(add_value(app, "--near", "D", flags.near_plane, parse_distance,
                     "Distance of the near plane, above 0: what is nearer is clipped away. [just before the model]"));
    camera(add_value(app, "--far", "D", flags.far_plane, parse_distance,
                     "Distance of the far plane, beyond the near one. [just behind the model]"));
    camera(add_value(app, "--camera-json", "FILE", flags.json, parse_path,
                     "Takes size and camera from a file that --camera-json-out or `raster info --json` wrote: the same"
                     " matrices to the last bit. Excludes the flags above."));
}

std::string ViewFlags::first_camera_flag() const {
    const std::pair<bool, const char*> given[] = {{position.has_value(), "--camera-position"},
                                                  {focal_point.has_value(), "--camera-focal-point"},
                                                  {up.has_value(), "--up"},
                                                  {view_angle.has_value(), "--camera-view-angle"},
                                                  {azimuth.has_value(), "--camera-azimuth-angle"},
                                                  {elevation.has_value(), "--camera-elevation-angle"},
                                                  {near_plane.has_value(), "--near"},
                                                  {far_plane.has_value(), "--far"}};
    for (const auto& [is_given, name] : given)
        if (is_given) return name;
    return "";
}

Result<ViewPlan> ViewPlan::make(const ViewFlags& flags) {
    ViewPlan plan;
    plan.flags_ = flags;
    plan.size_ = flags.size.value_or(Size{});
    if (!flags.json.empty()) {
        const std::string other = flags.first_camera_flag();
        if (!other.empty())
            return Error{ErrorKind::usage,
                         other + " and --camera-json exclude each other: the file has the whole camera"};
        Result<View> view = read_camera_json(flags.json);
        if (!view) return view.error();
        plan.file_view_ = std::move(*view);
        const Size& size = plan.file_view_->size;
        // A larger or smaller picture of the same shape shows the same through the same matrices.
        if (flags.size &&
            std::int64_t(flags.size->width) * size.height != std::int64_t(size.width) * flags.size->height)
            return Error{ErrorKind::usage, "--size: " + to_text(*flags.size) + " has another shape than the " +
                                               to_text(size) + " that " + flags.json + " is for"};
        plan.size_ = flags.size.value_or(size);
        plan.file_view_->size = plan.size_;
    } else if (flags.position) {
        // Where no model is needed to see a mistake, it is told before one is loaded.
        Camera camera;
        camera.position = *flags.position;
        camera.up = flags.up.value_or(camera.up);
        if (flags.focal_point) {
            camera.focal_point = *flags.focal_point;
            if (const Result<View> view =
                    plan.finish(orbited(camera, flags.azimuth.value_or(0), flags.elevation.value_or(0)));
                !view)
                return view.error();
        }
    }
    if (flags.near_plane && flags.far_plane && !(*flags.near_plane < *flags.far_plane))
        return Error{ErrorKind::usage,
                     "--far: " + to_text(*flags.far_plane) + " is not beyond --near " + to_text(*flags.near_plane)};
    return plan;
}

Result<View> ViewPlan::finish(const Camera& camera) const {
    const Result<CameraMatrices> matrices = camera_matrices(camera, aspect());
    if (!matrices) return Error{matrices.error().kind, "--" + matrices.error().message};
    return View{size_, camera, *matrices};
}

Camera ViewPlan::placed(const Model& model, bool spinning) const {
    const Box box = bounding_box(model);
    const glm::vec3 up = flags_.up.value_or(glm::vec3(0, 1, 0));
    const float view_angle = flags_.view_angle.value_or(30.0f);
    // Framing is defined for these angles; beyond them the eye stays where they end.
    const float framed = glm::clamp(view_angle, 1.0f, 170.0f);
    Camera camera =
        spinning ? auto_frame(turnable(box, up), aspect(), up, framed) : auto_frame(model, aspect(), up, framed);
    camera.view_angle = view_angle;
    if (flags_.position) camera.position = *flags_.position;
    if (flags_.focal_point) camera.focal_point = *flags_.focal_point;
    camera = orbited(camera, flags_.azimuth.value_or(0.0f), flags_.elevation.value_or(0.0f));
    return with_planes(camera, box);
}

Camera ViewPlan::with_planes(Camera camera, const Box& model) const {
    camera = with_planes_around(camera, model);
    if (flags_.near_plane) camera.near_plane = *flags_.near_plane;
    if (flags_.far_plane) camera.far_plane = *flags_.far_plane;
    return camera;
}

Result<View> ViewPlan::view_of(const Model& model) const {
    return file_view_ ? *file_view_ : finish(placed(model, false));
}

Result<View> ViewPlan::turned_view_of(const Model& model, int step, int steps) const {
    return finish(with_planes(orbited(placed(model, true), 360.0 * step / steps, 0), bounding_box(model)));
}

}  // namespace raster::tool
