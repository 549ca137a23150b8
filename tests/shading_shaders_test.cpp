// The flat, Gouraud and Phong shaders: lanes equal the scalar, what each of them computes and what it misses.
#include <gtest/gtest.h>

#include "shading_scene.h"

namespace {

using namespace raster;
using namespace raster::testing;

TEST(PixelShader, IsTheFormulaAtEveryPixel) {
    Light bulb;
    bulb.kind = LightKind::point;
    bulb.position = {0.5f, 1, 0};
    bulb.ambient = {9, 9, 9};  // summed up by the uniforms, not here
    bulb.diffuse = {1, 0.5f, 0.25f};
    bulb.specular = {0.25f, 0.5f, 1};
    bulb.attenuation = {0.25f, 0.25f, 0.25f};
    const Scene scene({bulb});
    const auto target = draw_scene(PixelShader<Phong, Detail::plain>{scene.u, {10}}, {slanted});
    // The plane of the triangle, to find each pixel's point by its own ray.
    const glm::dvec3 a(slanted[0].position), b(slanted[1].position), c(slanted[2].position);
    const glm::dvec3 plane = glm::cross(b - a, c - a);
    for_each_drawn(target, [&](int x, int y, glm::vec4 color) {
        const glm::dvec3 ray((x + 0.5) / 32 - 1, 1 - (y + 0.5) / 32, -1);
        const glm::dvec3 p = ray * (glm::dot(plane, a) / glm::dot(plane, ray));
        const glm::dvec3 n(0, 0, 1), to_light = glm::dvec3(bulb.position) - p, l = glm::normalize(to_light);
        const glm::dvec3 v = glm::normalize(-p), r = 2 * glm::dot(n, l) * n - l;
        const double d = glm::length(to_light), f = std::min(1.0, 1 / (0.25 + 0.25 * d + 0.25 * d * d));
        for (int i = 0; i < 3; ++i) {
            const SurfaceMaterial& m = scene.u.material;
            const double expected =
                m.emission[i] + double(scene.u.ambient[i]) * m.ambient[i] +
                f * bulb.diffuse[i] * m.diffuse[i] * std::max(0.0, glm::dot(n, l)) +
                f * bulb.specular[i] * m.specular[i] * std::pow(std::max(0.0, glm::dot(r, v)), 10.0);
            ASSERT_NEAR(color[i], expected, 2e-5) << x << " " << y;
        }
    });
}

TEST(GouraudShader, EqualsPhongShadingWhereTheNormalIsConstantAndTheLightParallel) {
    Scene scene;
    scene.u.material.specular = glm::vec3(0.0f);
    for (const bool two_sided : {false, true}) {
        scene.u.two_sided = two_sided;
        const auto pixel = draw_scene(PixelShader<Lambert, Detail::mapped>{scene.u, {}}, {slanted});
        const auto vertex = draw_scene(GouraudShader<Detail::mapped>{scene.u, {Lambert{}}}, {slanted});
        for_each_drawn(pixel, [&](int x, int y, glm::vec4 color) {
            for (int c = 0; c < 4; ++c) ASSERT_NEAR(color[c], vertex.color(x, y)[c], 1e-6);
        });
    }
}

TEST(GouraudShader, MissesTheHighlightInTheMiddleOfATriangle) {
    // Normals that lean outwards at the corners: the highlight is inside.
    std::vector<SurfaceVertex<float>> bulge = {vertex_at({-1, -1, -2}, glm::normalize(glm::vec3(-1, -1, 1))),
                                               vertex_at({1, -1, -2}, glm::normalize(glm::vec3(1, -1, 1))),
                                               vertex_at({0, 1, -2}, glm::normalize(glm::vec3(0, 1, 1)))};
    const Scene scene;
    const auto brightest = [&](const Target& target) {
        float most = 0;
        for (const glm::vec4& c : target.color_float()) most = std::max(most, c.x);
        return most;
    };
    const float phong = brightest(draw_scene(PixelShader<Phong, Detail::plain>{scene.u, {50}}, {bulge}));
    const float gouraud = brightest(draw_scene(GouraudShader<Detail::plain>{scene.u, {Phong{50}}}, {bulge}));
    EXPECT_NEAR(phong, 0.01f + 0.05f + 0.8f + 0.3f, 0.06f);
    EXPECT_LT(gouraud, 0.7f);
}

TEST(FlatShader, GivesATriangleOneColourLitAtItsCentroidWithItsOwnNormal) {
    const Scene scene(three_kinds_of_light());
    auto vertices = slanted;
    for (auto& v : vertices) v.normal = glm::normalize(glm::vec3(3, 1, -2));  // is not asked
    const RuntimeModel model{Phong{10}};
    const auto faces = light_faces(scene.u, model, {vertices});
    const auto target = draw_scene(FlatShader<Detail::plain>{scene.u, faces}, {vertices});
    const glm::vec3 a = slanted[0].position, b = slanted[1].position, c = slanted[2].position;
    const glm::vec3 n = glm::normalize(glm::cross(b - a, c - a)), p = (a + b + c) / 3.0f;
    const Lit<float> lit = illuminate(model, scene.u.lights, frame_at(scene.u, model, n, p), p);
    const glm::vec4 expected = plain_sum(scene.u.material, scene.u.ambient, lit);
    EXPECT_GT(expected.x, 0.3f);
    const glm::vec4 first = target.color(32, 36);
    for_each_drawn(target, [&](int, int, glm::vec4 color) { ASSERT_EQ(color, first); });
    for (int i = 0; i < 4; ++i) EXPECT_NEAR(first[i], expected[i], 1e-5f);
}

TEST(FlatShader, StaysOneColourWhereTheTriangleIsClipped) {
    const Scene scene;
    const std::vector<SurfaceVertex<float>> through = {vertex_at({-1, -1, 1}), vertex_at({3, -1, -4}),
                                                       vertex_at({-1, 2, -4})};
    const auto faces = light_faces(scene.u, {Lambert{}}, {through});
    const auto target = draw_scene(FlatShader<Detail::plain>{scene.u, faces}, {through});
    const glm::vec4 expected = plain_sum(scene.u.material, scene.u.ambient, faces[0].lit);
    for_each_drawn(target, [&](int, int, glm::vec4 color) { ASSERT_EQ(color, expected); });
}

/// An open bowl: the lower half of a sphere, hollow side towards the eye, outside normals.
std::vector<SurfaceVertex<float>> bowl_vertices(const Model& bowl) {
    auto vertices = bowl.vertices;
    for (auto& v : vertices) {
        v.position = glm::vec3(v.position.x, v.position.y, -v.position.z - 2.0f);  // opening to +z, the eye
        v.normal = glm::vec3(v.normal.x, v.normal.y, -v.normal.z);
    }
    return vertices;
}

TEST(TwoSided, LightsTheInsideOfAnOpenBowlAndOneSidedLeavesItDark) {
    const Model bowl = sphere(32, 0.5f);
    const auto vertices = bowl_vertices(bowl);
    std::vector<std::uint32_t> indices = bowl.indices;
    for (std::size_t i = 0; i < indices.size(); i += 3) std::swap(indices[i], indices[i + 1]);  // mirrored above
    const Mesh<SurfaceVertex<float>> mesh{vertices, indices};

    Scene scene;  // light along the view
    scene.u.ambient = scene.u.material.emission = glm::vec3(0.0f);
    const auto middle = [&](const auto& shader) { return draw_scene(shader, mesh).color(32, 32).x; };
    const auto by_frequency = [&] {
        const auto faces = light_faces(scene.u, {Lambert{}}, mesh);
        return std::array{middle(PixelShader<Lambert, Detail::plain>{scene.u, {}}),
                          middle(GouraudShader<Detail::mapped>{scene.u, {Lambert{}}}),
                          middle(FlatShader<Detail::plain>{scene.u, faces})};
    };
    scene.u.two_sided = false;
    for (const float dark : by_frequency()) EXPECT_EQ(dark, 0.0f);
    scene.u.two_sided = true;
    for (const float lit : by_frequency()) EXPECT_NEAR(lit, 0.8f, 0.03f);

    // Lit from behind, the outside gets the light; the inside gets none, whichever way.
    scene.lights[0].direction_eye = {0, 0, 1};
    for (const float dark : by_frequency()) EXPECT_EQ(dark, 0.0f);
    scene.u.two_sided = false;  // the normals point to the light, away from the eye: "lit through"
    for (const float lit : by_frequency()) EXPECT_NEAR(lit, 0.8f, 0.03f);
}

TEST(TwoSided, ChangesNothingOnAClosedSurface) {
    const Model ball = sphere(24);
    auto vertices = ball.vertices;
    for (auto& v : vertices) v.position.z -= 3;
    Scene scene(three_kinds_of_light());
    const Mesh<SurfaceVertex<float>> mesh{vertices, ball.indices};
    State state;
    const auto one = draw_scene(PixelShader<Phong, Detail::plain>{scene.u, {9}}, mesh, state);
    scene.u.two_sided = true;
    const auto two = draw_scene(PixelShader<Phong, Detail::plain>{scene.u, {9}}, mesh, state);
    EXPECT_EQ(one.color_float(), two.color_float());
}

TEST(Shaders, SurviveNormalsThatAreZeroAndPositionsAtTheEyeOrTheLight) {
    Light bulb;
    bulb.kind = LightKind::point;
    bulb.position = {0, 0, -2};
    Scene scene({bulb});
    const glm::vec3 zero(0.0f);
    const std::vector<SurfaceVertex<float>> broken = {vertex_at({-2, -2, -2}, zero), vertex_at({2, -2, -2}, {0, 0, 1}),
                                                      vertex_at({0, 2, -2}, {0, 0, -1})};  // normals that cancel
    for (const bool two_sided : {false, true}) {
        scene.u.two_sided = two_sided;
        const auto faces = light_faces(scene.u, {Phong{}}, {broken});
        const auto expect_numbers = [](const Target& target) {
            for_each_drawn(target, [&](int x, int y, glm::vec4 color) {
                for (int c = 0; c < 4; ++c) ASSERT_TRUE(color[c] >= 0 && color[c] < 10) << x << " " << y;
            });
            for (int e = 0; e < target.extra_channels(); ++e)
                for (const float v : target.extra(e)) ASSERT_EQ(v, v);
        };
        expect_numbers(draw_scene(PixelShader<BlinnPhong, Detail::plain>{scene.u, {}}, {broken}));
        expect_numbers(draw_scene(PixelShader<RuntimeModel, Detail::terms>{scene.u, {Phong{}}}, {broken}));
        expect_numbers(draw_scene(GouraudShader<Detail::terms>{scene.u, {BlinnPhong{}}}, {broken}));
        expect_numbers(draw_scene(FlatShader<Detail::terms>{scene.u, faces}, {broken}));
    }
    const PixelShader<BlinnPhong, Detail::plain> shader{scene.u, {}};
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const glm::vec4 at_eye = shader.fragment<float>({{0, 0, 1}, {0, 0, 0}}, {});
    const glm::vec4 no_number = shader.fragment<float>({{nan, nan, nan}, {nan, 0, -1}}, {});
    scene.u.material.vertex_colors = true;
    const PixelShader<BlinnPhong, Detail::mapped> mapped{scene.u, {}};
    const glm::vec4 no_color = mapped.fragment<float>({{0, 0, 1}, {0, 0, -3}, {nan, nan}, {nan, -1, nan}}, {});
    for (int c = 0; c < 4; ++c) {
        EXPECT_TRUE(at_eye[c] >= 0 && at_eye[c] < 10);
        EXPECT_TRUE(no_number[c] >= 0 && no_number[c] < 10);
        EXPECT_TRUE(no_color[c] >= 0 && no_color[c] < 10);
    }
}

TEST(Shaders, MultiplyTexturesAndVertexColoursIntoTheMaterial) {
    Image8 image(1, 1, 4);
    image.samples = {255, 51, 0, 102};
    Scene scene(std::vector<Light>{});
    scene.texture = pack_texture(image);
    const TextureView view(scene.texture);
    SurfaceMaterial& m = scene.u.material;
    m.alpha = 0.5f;
    m.diffuse_texture = m.ambient_texture = m.specular_texture = m.emission_texture = m.alpha_texture = view;
    const glm::vec3 vertex_color(0.5f, 0.25f, 1);
    const auto colors = [&] { return mapped_colors<float>(m, {0.5f, 0.5f}, vertex_color); };
    const auto near = [](glm::vec3 a, glm::vec3 b) { return glm::distance(a, b) < 1e-6f; };
    EXPECT_PRED2(near, colors().diffuse, glm::vec3(0.8f, 0.12f, 0));
    EXPECT_PRED2(near, colors().ambient, glm::vec3(0.5f, 0.05f, 0));
    EXPECT_PRED2(near, colors().specular, glm::vec3(0.3f, 0.06f, 0));
    EXPECT_PRED2(near, colors().emission, glm::vec3(0.01f, 0.004f, 0));
    EXPECT_NEAR(colors().alpha, 0.5f, 1e-6f);  // the red channel
    m.alpha_texture_has_alpha = true;
    EXPECT_NEAR(colors().alpha, 0.2f, 1e-6f);
    m.vertex_colors = true;
    EXPECT_PRED2(near, colors().diffuse, glm::vec3(0.4f, 0.03f, 0));
    EXPECT_PRED2(near, colors().ambient, glm::vec3(0.25f, 0.0125f, 0));
    EXPECT_PRED2(near, colors().specular, glm::vec3(0.3f, 0.06f, 0));
    m.ambient_is_diffuse = true;
    m.ambient = {1, 1, 0.5f};
    EXPECT_PRED2(near, colors().ambient, glm::vec3(0.4f, 0.03f, 0));
}

TEST(Shaders, AnswerWhatColourRedLightMakesOfWhiteAndGreen) {
    Light red;
    red.diffuse = red.specular = {1, 0, 0};
    Scene scene({red});
    scene.u.ambient = scene.u.material.emission = glm::vec3(0.0f);
    scene.u.material.specular = glm::vec3(0.0f);
    const auto color = [&](glm::vec3 diffuse, glm::vec3 specular) {
        scene.u.material.diffuse = diffuse;
        scene.u.material.specular = specular;
        const PixelShader<Phong, Detail::plain> shader{scene.u, {10}};
        return glm::vec3(shader.fragment<float>({{0, 0, 1}, {0, 0, -1}}, {}));
    };
    EXPECT_EQ(color({1, 1, 1}, {0, 0, 0}), glm::vec3(1, 0, 0));
    EXPECT_EQ(color({0, 1, 0}, {0, 0, 0}), glm::vec3(0, 0, 0));
    EXPECT_EQ(color({0, 1, 0}, {1, 1, 1}), glm::vec3(1, 0, 0));  // the highlight has the light's colour
}

}  // namespace
