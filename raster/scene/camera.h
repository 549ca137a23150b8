// camera.h: where the eye is, what it looks at and how much it sees; and a camera that shows a whole model.
#pragma once

#include <glm/glm.hpp>

#include <raster/result.h>
#include <raster/scene/model.h>

namespace raster {

/// A perspective camera in world space. The words are those of VTK and f3d.
struct Camera {
    glm::vec3 position{0.0f, 0.0f, 5.0f};
    glm::vec3 focal_point{0.0f};     ///< is in the middle of the picture; its distance does not matter
    glm::vec3 up{0.0f, 1.0f, 0.0f};  ///< any length, not along the view direction
    float view_angle = 30.0f;        ///< vertical, in degrees, above 0 and below 180
    float near_plane = 0.1f;         ///< distances along the view direction, 0 < near_plane < far_plane:
    float far_plane = 100.0f;        ///< what is nearer or farther is clipped away
};

/// The same camera as matrices, each element rounded to float once.
struct CameraMatrices {
    glm::mat4 eye_from_world;
    glm::mat4 clip_from_eye;
    glm::mat4 clip_from_world;  ///< product(clip_from_eye, eye_from_world) of transform.h
};

/// The matrices of a camera for pictures of width / height = `aspect`. An error of kind usage whose message
/// starts with the parameter's name (camera-position, camera-focal-point, up, camera-view-angle, near, far,
/// aspect) if a number is not finite or out of its range, the eye is at the focal point, up is 0 or along the
/// view direction, or the numbers are so extreme that a matrix would leave the range of float.
Result<CameraMatrices> camera_matrices(const Camera& camera, double aspect);

/// A camera whose picture a model of this box just fills: every corner lies within 90 % of the picture's
/// width and height, as in f3d, and at least one on that limit. It looks at the centre of the box from the
/// front, 30 degrees to the right and 20 above; the front is +z when up is y and -y when up is z. The planes
/// enclose the box. An empty box becomes a unit cube at the origin, a single point one around the point, NaN
/// becomes 0 and coordinates are limited to 1e25: the result is valid for view angles from 1 to 170 degrees,
/// aspects from 0.001 to 1000 and any `up` but 0.
Camera auto_frame(const Box& box, double aspect, const glm::vec3& up = {0.0f, 1.0f, 0.0f},
                  float view_angle = 30.0f);
/// The same with the model's own vertices in place of the corners of its box: as near as the shape allows.
Camera auto_frame(const Model& model, double aspect, const glm::vec3& up = {0.0f, 1.0f, 0.0f},
                  float view_angle = 30.0f);

/// The camera with near and far plane around the box, whatever side it is on: the nearest corner is in front
/// of the near plane, if that leaves near_plane >= far_plane / 1000, so that depth keeps its precision. A box
/// wholly behind the eye gives the planes of a box at the focal point.
Camera with_planes_around(Camera camera, const Box& box);

}  // namespace raster
