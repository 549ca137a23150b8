// scene_camera_test.cpp: matrices against their definitions, cameras that frame boxes, and every bad camera
// refused.
#include <raster/scene/camera.h>
#include <raster/scene/shapes.h>
#include <raster/scene/transform.h>

#include <array>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "random.h"

namespace raster {
namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();
constexpr float nan = std::numeric_limits<float>::quiet_NaN();

glm::dvec4 apply(const glm::mat4& m, const glm::vec3& p) {
    glm::dvec4 r(0.0);
    const glm::dvec4 v(p, 1.0);
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 4; ++row) r[row] += double(m[column][row]) * v[column];
    return r;
}

void expect_near(const glm::dvec3& a, const glm::dvec3& b, double tolerance) {
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(a[i], b[i], tolerance) << "component " << i;
}

std::array<glm::vec3, 8> corners(const Box& b) {
    std::array<glm::vec3, 8> r;
    for (int i = 0; i < 8; ++i)
        r[i] = {i & 1 ? b.max.x : b.min.x, i & 2 ? b.max.y : b.min.y, i & 4 ? b.max.z : b.min.z};
    return r;
}

TEST(Transform, TranslateAndScaleMovePointsAsTheySay) {
    expect_near(apply(translate({1, 2, 3}), {10, 20, 30}), {11, 22, 33}, 0);
    expect_near(apply(scale({2, 3, 4}), {1, 10, 100}), {2, 30, 400}, 0);
    expect_near(apply(scale(0.5f), {1, 10, 100}), {0.5, 5, 50}, 0);
}

TEST(Transform, AQuarterTurnIsExactAndCounterClockwise) {
    expect_near(apply(rotate_x(90), {0, 1, 0}), {0, 0, 1}, 0);
    expect_near(apply(rotate_y(90), {0, 0, 1}), {1, 0, 0}, 0);
    expect_near(apply(rotate_z(90), {1, 0, 0}), {0, 1, 0}, 0);
    EXPECT_EQ(rotate_z(360), glm::mat4(1.0f));
    EXPECT_EQ(rotate_x(-90), rotate_x(270));
}

TEST(Transform, RotationsKeepLengthsAxisAndAngle) {
    testing::Random random(1);
    for (int i = 0; i < 200; ++i) {
        const glm::vec3 axis(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
        const double degrees = random.uniform(-720, 720);
        const glm::mat4 m = rotate(degrees, axis);
        const glm::dvec3 unit = glm::dvec3(axis) / glm::length(glm::dvec3(axis));
        expect_near(apply(m, axis), axis, 1e-6);
        const glm::vec3 across = glm::vec3(glm::normalize(glm::cross(unit, glm::dvec3(0.3, 0.5, -0.8))));
        const glm::dvec3 turned = apply(m, across);
        const double radians = std::remainder(degrees, 360.0) * std::acos(-1.0) / 180;
        EXPECT_NEAR(glm::dot(turned, glm::dvec3(across)), std::cos(radians), 1e-6);
        EXPECT_NEAR(glm::dot(glm::cross(glm::dvec3(across), turned), unit), std::sin(radians), 1e-6);
    }
}

TEST(Transform, ProductAppliesTheRightMatrixFirst) {
    const glm::mat4 m = product(translate({5, 0, 0}), rotate_z(90));
    expect_near(apply(m, {1, 0, 0}), {5, 1, 0}, 0);
}

TEST(Transform, LookAtPutsTheEyeAtTheOriginAndTheFocalPointOnMinusZ) {
    testing::Random random(2);
    for (int i = 0; i < 200; ++i) {
        const auto point = [&] {
            const float x = random.uniform(-9, 9), y = random.uniform(-9, 9), z = random.uniform(-9, 9);
            return glm::vec3(x, y, z);
        };
        const glm::vec3 eye = point(), focus = point(), up = point();
        const glm::mat4 m = look_at(eye, focus, up);
        expect_near(apply(m, eye), {0, 0, 0}, 1e-5);
        expect_near(apply(m, focus), {0, 0, -glm::length(glm::dvec3(focus) - glm::dvec3(eye))}, 1e-5);
        const glm::dvec3 above = glm::dvec3(apply(m, focus + up));
        EXPECT_NEAR(above.x, 0, 1e-5);
        EXPECT_GT(above.y, 0);
        const glm::dmat3 rotation = glm::dmat3(glm::mat3(m));
        EXPECT_NEAR(glm::determinant(rotation), 1, 1e-6) << "a rotation, not a reflection";
    }
}

TEST(Transform, PerspectiveTakesTheFrustumToTheClipCube) {
    const double angle = 40, aspect = 1.5, near_plane = 0.5, far_plane = 80;
    const glm::mat4 m = perspective(angle, aspect, near_plane, far_plane);
    for (double depth : {near_plane, far_plane}) {
        const double top = depth * std::tan(angle / 2 * std::acos(-1.0) / 180);
        const glm::dvec4 clip = apply(m, glm::vec3(-top * aspect, top, -depth));
        EXPECT_NEAR(clip.w, depth, 1e-5);
        EXPECT_NEAR(clip.x / clip.w, -1, 1e-6);
        EXPECT_NEAR(clip.y / clip.w, 1, 1e-6);
        EXPECT_NEAR(clip.z / clip.w, depth == near_plane ? -1 : 1, 1e-6);
    }
}

TEST(Transform, PerspectiveOfARightAngleHasFocalLengthOne) {
    const glm::mat4 m = perspective(90, 2, 1, 3);
    EXPECT_EQ(m[0][0], 0.5f);
    EXPECT_EQ(m[1][1], 1.0f);
    EXPECT_EQ(m[2][2], -2.0f);
    EXPECT_EQ(m[3][2], -3.0f);
    EXPECT_EQ(m[2][3], -1.0f);
    EXPECT_EQ(m[3][3], 0.0f);
}

TEST(Transform, OrthographicTakesItsBoxToTheClipCube) {
    const glm::mat4 m = orthographic(-2, 6, 1, 5, 0.5, 10.5);
    expect_near(apply(m, {-2, 1, -0.5f}), {-1, -1, -1}, 1e-6);
    expect_near(apply(m, {6, 5, -10.5f}), {1, 1, 1}, 1e-6);
    EXPECT_EQ(apply(m, {1, 2, -3}).w, 1.0);
}

TEST(Transform, NormalMatrixKeepsNormalsPerpendicularAndOutward) {
    testing::Random random(3);
    const auto any = [&] { return random.uniform(-1.0f, 1.0f); };
    for (int i = 0; i < 200; ++i) {
        glm::mat4 m(1.0f);
        for (int k = 0; k < 12; ++k) m[k / 3][k % 3] = any();
        glm::dvec3 tangent, normal;
        for (int k = 0; k < 3; ++k) tangent[k] = any();
        for (int k = 0; k < 3; ++k) normal[k] = any();
        normal -= tangent * (glm::dot(normal, tangent) / glm::dot(tangent, tangent));
        const glm::dvec3 moved_tangent = glm::dmat3(glm::mat3(m)) * tangent;
        const glm::dvec3 moved_normal = glm::dmat3(normal_matrix(m)) * normal;
        const double size = glm::length(moved_tangent) * glm::length(moved_normal);
        EXPECT_NEAR(glm::dot(moved_tangent, moved_normal), 0, 1e-5 * size);
        // A point above the surface stays above it: (M n) . (N n) = n . n.
        EXPECT_GT(glm::dot(glm::dmat3(glm::mat3(m)) * normal, moved_normal), 0);
    }
    const glm::mat3 flat = normal_matrix(scale({1, 1, 0}));
    EXPECT_EQ(flat * glm::vec3(0, 0, 1), glm::vec3(0, 0, 1)) << "a flattened model still has a normal";
}

// ---------------------------------------------------------------------------------------------- framing

TEST(Camera, AutoFrameFillsNineTenthsOfThePicture) {
    testing::Random random(4);
    for (int i = 0; i < 500; ++i) {
        Box box;
        const float size = raster::exp2(random.uniform(-20, 20));
        for (int k = 0; k < 3; ++k) {
            box.min[k] = random.uniform(-3, 3) * size;
            box.max[k] = box.min[k] + random.uniform(0, 2) * size;
        }
        const double aspect = random.uniform(0.2f, 5.0f);
        const glm::vec3 ups[] = {{0, 1, 0}, {0, 0, 1}, {1, 0, 0}, {0, -3, 0}, {-1, 0.01f, 0}, {1, 2, 3}};
        const Camera camera = auto_frame(box, aspect, ups[i % 6], random.uniform(5, 120));
        const auto m = camera_matrices(camera, aspect);
        ASSERT_TRUE(m) << m.error().message;
        double widest = 0;
        for (const glm::vec3& corner : corners(box)) {
            const glm::dvec4 clip = apply(m->clip_from_world, corner);
            ASSERT_GT(clip.w, 0);
            widest = std::fmax(widest, std::fmax(std::fabs(clip.x), std::fabs(clip.y)) / clip.w);
            EXPECT_LT(std::fabs(clip.z), clip.w) << "between near and far plane";
        }
        EXPECT_NEAR(widest, 0.9, 1e-3);
    }
}

TEST(Camera, AutoFrameLooksFromTheFrontRightAndAbove) {
    const Box box{glm::vec3(-1), glm::vec3(1)};
    const Camera y_up = auto_frame(box, 1);
    EXPECT_GT(y_up.position.z, y_up.position.x);
    EXPECT_GT(y_up.position.x, 0);
    EXPECT_GT(y_up.position.y, 0);
    EXPECT_EQ(y_up.focal_point, glm::vec3(0));
    EXPECT_EQ(y_up.view_angle, 30);
    const Camera z_up = auto_frame(box, 1, {0, 0, 1});
    EXPECT_LT(z_up.position.y, -z_up.position.x);
    EXPECT_GT(z_up.position.x, 0);
    EXPECT_GT(z_up.position.z, 0);
}

TEST(Camera, AutoFrameOfAnyBoxIsValid) {
    const float huge = std::numeric_limits<float>::max();
    const Box boxes[] = {
        {glm::vec3(1), glm::vec3(-1)},
        {glm::vec3(0), glm::vec3(0)},
        {glm::vec3(1e6f), glm::vec3(1e6f)},
        {glm::vec3(1e-40f), glm::vec3(2e-40f)},
        {glm::vec3(-huge), glm::vec3(huge)},
        {glm::vec3(-infinity), glm::vec3(infinity)},
        {glm::vec3(huge), glm::vec3(-huge)},
        {glm::vec3(nan), glm::vec3(nan)},
        {glm::vec3(0), glm::vec3(0, 0, 1)},
        {glm::vec3(1e30f, 0, 0), glm::vec3(1e30f, 1e-30f, 0)},
    };
    for (const Box& box : boxes)
        for (double aspect : {0.001, 1.0, 1000.0})
            for (float angle : {1.0f, 30.0f, 170.0f}) {
                const auto m = camera_matrices(auto_frame(box, aspect, {0, 1, 0}, angle), aspect);
                EXPECT_TRUE(m) << m.error().message << " for a box from " << box.min.x << ", " << box.min.y;
            }
}

TEST(Camera, AutoFrameOfAModelFillsNineTenthsWithItsVertices) {
    for (const Model& model : {sphere(), teapot(3), tetrahedron(), plane(1)}) {
        for (double aspect : {0.5, 1.0, 2.0}) {
            const auto m = camera_matrices(auto_frame(model, aspect), aspect);
            ASSERT_TRUE(m);
            double widest = 0;
            for (std::uint32_t i : model.indices) {
                const glm::dvec4 clip = apply(m->clip_from_world, model.vertices[i].position);
                widest = std::fmax(widest, std::fmax(std::fabs(clip.x), std::fabs(clip.y)) / clip.w);
                EXPECT_LT(std::fabs(clip.z), clip.w);
            }
            EXPECT_NEAR(widest, 0.9, 1e-5);
        }
    }
    EXPECT_TRUE(camera_matrices(auto_frame(Model{}, 1), 1)) << "of nothing too";
    EXPECT_TRUE(camera_matrices(auto_frame(box({2, 2, 2}, {2, 2, 2}), 1), 1)) << "and of a point";
}

TEST(Camera, PlanesEncloseTheBoxFromAnyPosition) {
    testing::Random random(5);
    const Box box{{-1, -2, -3}, {4, 5, 6}};
    for (int i = 0; i < 300; ++i) {
        Camera camera;
        for (int k = 0; k < 3; ++k) camera.position[k] = random.uniform(-30, 30);
        camera.focal_point = {1.5f, 1.5f, 1.5f};
        camera = with_planes_around(camera, box);
        ASSERT_TRUE(camera_matrices(camera, 1.0));
        const glm::dvec3 view = glm::normalize(glm::dvec3(camera.focal_point - camera.position));
        double nearest = 1e30, farthest = -1e30;
        for (const glm::vec3& corner : corners(box)) {
            const double depth = glm::dot(glm::dvec3(corner) - glm::dvec3(camera.position), view);
            nearest = std::fmin(nearest, depth);
            farthest = std::fmax(farthest, depth);
        }
        EXPECT_GT(camera.far_plane, farthest);
        EXPECT_LT(camera.far_plane, farthest * 1.05);
        EXPECT_GE(camera.near_plane, camera.far_plane * 0.00099f);
        if (nearest > farthest / 20) {
            EXPECT_LT(camera.near_plane, nearest);
        }
    }
}

TEST(Camera, ABoxBehindTheEyeStillGivesValidPlanes) {
    Camera camera;
    camera.position = {0, 0, 5};
    camera.focal_point = {0, 0, 9};
    camera = with_planes_around(camera, {glm::vec3(-1), glm::vec3(1)});
    EXPECT_TRUE(camera_matrices(camera, 1));
    EXPECT_GT(camera.far_plane, 4);
    EXPECT_LT(camera.near_plane, 4);
}

// ------------------------------------------------------------------------------------------ bad cameras

/// The message of the error that a change to a good camera gives; empty if it gives none.
template <class Change>
std::string refusal(Change change, double aspect = 1.0) {
    Camera camera;
    change(camera);
    const auto m = camera_matrices(camera, aspect);
    if (m) return "";
    EXPECT_EQ(m.error().kind, ErrorKind::usage);
    return m.error().message;
}

/// The parameter that the refusal names.
template <class Change>
std::string blamed(Change change, double aspect = 1.0) {
    const std::string message = refusal(change, aspect);
    return message.substr(0, message.find(": "));
}

TEST(Camera, TheDefaultIsValid) {
    EXPECT_EQ(refusal([](Camera&) {}), "");
}

TEST(Camera, AnEyeAtTheFocalPointIsRefused) {
    EXPECT_EQ(refusal([](Camera& c) { c.position = c.focal_point = {1, 2, 3}; }),
              "camera-position: 1,2,3 is the focal point, so there is no view");
}

TEST(Camera, AnUpAlongTheViewIsRefused) {
    EXPECT_EQ(refusal([](Camera& c) { c.up = {0, 0, -2}; }), "up: 0,0,-2 is parallel to the view direction");
    EXPECT_EQ(refusal([](Camera& c) { c.up = {0, 0, 7}; }), "up: 0,0,7 is parallel to the view direction");
    EXPECT_EQ(refusal([](Camera& c) { c.up = {0, 0, 0}; }), "up: 0,0,0 is no direction");
    EXPECT_EQ(refusal([](Camera& c) { c.up = {0, 1e-3f, 1}; }), "") << "a slanted up is fine";
}

TEST(Camera, PlanesOutOfOrderAreRefused) {
    EXPECT_EQ(refusal([](Camera& c) { c.near_plane = 0; }), "near: 0 is not a distance above 0");
    EXPECT_EQ(refusal([](Camera& c) { c.near_plane = -1; }), "near: -1 is not a distance above 0");
    EXPECT_EQ(refusal([](Camera& c) { c.far_plane = 0.1f; }), "far: 0.1 is not a distance above near 0.1");
    EXPECT_EQ(refusal([](Camera& c) { c.near_plane = 200; }), "far: 100 is not a distance above near 200");
}

TEST(Camera, ViewAnglesOutsideAHalfTurnAreRefused) {
    for (float angle : {0.0f, -30.0f, 180.0f, 360.0f, infinity, -infinity, nan})
        EXPECT_EQ(blamed([&](Camera& c) { c.view_angle = angle; }), "camera-view-angle") << angle;
    EXPECT_EQ(refusal([](Camera& c) { c.view_angle = 180; }),
              "camera-view-angle: 180 is not above 0 and below 180 degrees");
}

TEST(Camera, NumbersThatAreNotFiniteAreRefusedByName) {
    for (float bad : {nan, infinity, -infinity}) {
        for (int i = 0; i < 3; ++i) {
            EXPECT_EQ(blamed([&](Camera& c) { c.position[i] = bad; }), "camera-position");
            EXPECT_EQ(blamed([&](Camera& c) { c.focal_point[i] = bad; }), "camera-focal-point");
            EXPECT_EQ(blamed([&](Camera& c) { c.up[i] = bad; }), "up");
        }
        EXPECT_EQ(blamed([&](Camera& c) { c.near_plane = bad; }), "near");
        EXPECT_EQ(blamed([&](Camera& c) { c.far_plane = bad; }), "far");
        EXPECT_EQ(blamed([](Camera&) {}, bad), "aspect");
    }
    EXPECT_EQ(blamed([](Camera&) {}, 0.0), "aspect");
    EXPECT_EQ(blamed([](Camera&) {}, -1.0), "aspect");
}

TEST(Camera, AnyCameraGivesFiniteMatricesOrAnError) {
    testing::Random random(6);
    int valid = 0;
    for (int i = 0; i < 20000; ++i) {
        const auto any = [&] {
            switch (random.integer(0, 3)) {
                case 0: return as_float(std::int32_t(random.bits()));
                case 1: return random.uniform(-200, 200);
                case 2: return float(random.integer(-1, 2));
                default: return raster::exp2(random.uniform(-126, 127));
            }
        };
        Camera c;
        for (int k = 0; k < 3; ++k) c.position[k] = any();
        for (int k = 0; k < 3; ++k) c.focal_point[k] = any();
        for (int k = 0; k < 3; ++k) c.up[k] = any();
        c.view_angle = any();
        c.near_plane = any();
        c.far_plane = any();
        const auto m = camera_matrices(c, any());
        if (!m) continue;
        ++valid;
        for (const glm::mat4& matrix : {m->eye_from_world, m->clip_from_eye, m->clip_from_world})
            for (int k = 0; k < 16; ++k) ASSERT_TRUE(std::isfinite(matrix[k / 4][k % 4]));
    }
    EXPECT_GT(valid, 200) << "the test must reach the matrices";
}

}  // namespace
}  // namespace raster
