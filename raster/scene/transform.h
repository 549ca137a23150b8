// transform.h: the matrices that take points from one space to the next, with the same bits on every machine.
//
// glm::rotate, glm::lookAt and glm::perspective call the C library's sin and tan, whose bits vary; these do
// not. Each element is computed in double precision in the order written here and rounded to float once, at
// the end. Matrices are GLM's (columns, m[column][row]) and multiply column vectors from the left: clip =
// clip_from_eye * eye. Angles are in degrees; a positive angle turns counter-clockwise seen from the tip of
// the axis. The eye looks along -z; clip space is OpenGL's: the visible part is -w <= x, y, z <= w (OpenGL
// 4.6 core, section 13.7).
#pragma once

#include <cmath>

#include <glm/glm.hpp>

#include <raster/math.h>

namespace raster {

inline glm::mat4 translate(const glm::vec3& offset) {
    glm::mat4 m(1.0f);
    m[3] = glm::vec4(offset, 1.0f);
    return m;
}

inline glm::mat4 scale(const glm::vec3& factors) {
    glm::mat4 m(1.0f);
    for (int i = 0; i < 3; ++i) m[i][i] = factors[i];
    return m;
}
inline glm::mat4 scale(float factor) { return scale(glm::vec3(factor)); }

/// Turns by `degrees` around a line through the origin along `axis`, which has any length but 0 (Rodrigues
/// 1840). Multiples of 90 degrees around a coordinate axis are exact.
inline glm::mat4 rotate(double degrees, const glm::vec3& axis) {
    const auto [s, c] = sin_cos_degrees(degrees);
    const glm::dvec3 a = glm::dvec3(axis) / std::sqrt(glm::dot(glm::dvec3(axis), glm::dvec3(axis)));
    const glm::dvec3 t = a * (1.0 - c);
    return glm::mat4(glm::dmat4(t.x * a.x + c, t.x * a.y + s * a.z, t.x * a.z - s * a.y, 0,  //
                                t.y * a.x - s * a.z, t.y * a.y + c, t.y * a.z + s * a.x, 0,  //
                                t.z * a.x + s * a.y, t.z * a.y - s * a.x, t.z * a.z + c, 0,  //
                                0, 0, 0, 1));
}
inline glm::mat4 rotate_x(double degrees) { return rotate(degrees, {1, 0, 0}); }
inline glm::mat4 rotate_y(double degrees) { return rotate(degrees, {0, 1, 0}); }
inline glm::mat4 rotate_z(double degrees) { return rotate(degrees, {0, 0, 1}); }

/// The product a * b; each element is summed in double precision and rounded once.
inline glm::mat4 product(const glm::mat4& a, const glm::mat4& b) {
    glm::mat4 m;
    for (int column = 0; column < 4; ++column) {
        for (int row = 0; row < 4; ++row) {
            double sum = 0;
            for (int k = 0; k < 4; ++k) sum += double(a[k][row]) * double(b[column][k]);
            m[column][row] = float(sum);
        }
    }
    return m;
}

/// Eye space from world space: the eye at `position`, looking at `focal_point`, `up` upwards on the picture.
/// The three must not lie on one line; camera_matrices (camera.h) checks that and says so in words.
inline glm::mat4 look_at(const glm::vec3& position, const glm::vec3& focal_point, const glm::vec3& up) {
    const glm::dvec3 p(position);
    const glm::dvec3 back = glm::normalize(p - glm::dvec3(focal_point));
    const glm::dvec3 right = glm::normalize(glm::cross(glm::dvec3(up), back));
    const glm::dvec3 above = glm::cross(back, right);
    return glm::mat4(glm::dmat4(right.x, above.x, back.x, 0,  //
                                right.y, above.y, back.y, 0,  //
                                right.z, above.z, back.z, 0,  //
                                -glm::dot(right, p), -glm::dot(above, p), -glm::dot(back, p), 1));
}

/// Clip space from eye space. `view_angle` is the vertical angle in degrees, above 0 and below 180; `aspect`
/// is width over height; 0 < near_plane < far_plane are distances along -z. The near plane goes to z = -w,
/// the far one to z = w.
inline glm::mat4 perspective(double view_angle, double aspect, double near_plane, double far_plane) {
    const double focal_length = 1.0 / tan_degrees(view_angle / 2);
    const double depth = near_plane - far_plane;
    glm::mat4 m(0.0f);
    m[0][0] = float(focal_length / aspect);
    m[1][1] = float(focal_length);
    m[2][2] = float((far_plane + near_plane) / depth);
    m[2][3] = -1.0f;
    m[3][2] = float(2 * far_plane * near_plane / depth);
    return m;
}

/// Clip space from eye space without foreshortening: the box left..right, bottom..top,
/// -near_plane..-far_plane of eye space fills the picture.
inline glm::mat4 orthographic(double left, double right, double bottom, double top, double near_plane,
                              double far_plane) {
    glm::mat4 m(1.0f);
    m[0][0] = float(2 / (right - left));
    m[1][1] = float(2 / (top - bottom));
    m[2][2] = float(-2 / (far_plane - near_plane));
    m[3][0] = float(-(right + left) / (right - left));
    m[3][1] = float(-(top + bottom) / (top - bottom));
    m[3][2] = float(-(far_plane + near_plane) / (far_plane - near_plane));
    return m;
}

/// What takes normals along where `m` takes points: the inverse transpose of its upper left 3 by 3. The
/// results are not unit vectors in general. A matrix that flattens space has no inverse; then the cofactors
/// alone are given, which point the same way.
inline glm::mat3 normal_matrix(const glm::mat4& m) {
    const glm::dvec3 x(m[0]), y(m[1]), z(m[2]);
    const glm::dvec3 yz = glm::cross(y, z), zx = glm::cross(z, x), xy = glm::cross(x, y);
    const double determinant = glm::dot(x, yz);
    const double factor = determinant == 0 ? 1 : 1 / determinant;
    return glm::mat3(glm::dmat3(yz * factor, zx * factor, xy * factor));
}

}  // namespace raster
