// Pictures of models: options, materials, transparency, extra planes, and that an observer sees the very same draws.
#include <gtest/gtest.h>
#include <raster/scene/draw_plan.h>
#include <raster/scene/transform.h>

#include "shading_testing.h"

namespace {

using namespace raster;
using namespace raster::testing;

/// Looks along -z from a distance of 5; 64 by 64 pixels show 2.68 units at the origin.
CameraMatrices camera() { return *camera_matrices(Camera{}, 1.0); }

Target picture(const Model& model, const RenderOptions& options = {}, int planes = 0) {
    Target target(64, 64, ColorFormat::rgba8, DepthFormat::unorm24, planes);
    render(target, model, camera(), options);
    return target;
}

std::array<glm::vec3, 4> square(float x0, float y0, float x1, float y1, float z) {
    return {glm::vec3(x0, y0, z), {x1, y0, z}, {x1, y1, z}, {x0, y1, z}};
}

/// A model that uses everything: textures, vertex colours, several materials, one of them transparent.
Model mixed_model() {
    Model model = sphere(16);
    for (auto& v : model.vertices) v.color = glm::vec3(0.5f) + 0.5f * v.normal;
    Random random(41);
    Image8 image(8, 8, 3);
    for (auto& s : image.samples) s = std::uint8_t(random.integer(0, 255));
    model.textures.push_back({"noise.png", image});
    model.materials.resize(3);
    model.materials[0].specular = glm::vec3(0.5f);
    model.materials[1].diffuse_texture = 0;
    model.materials[2].alpha = 0.5f;
    model.materials[2].emission = {0.2f, 0, 0};
    model.parts[0].material = 0;
    add_quad(model, square(-1.2f, -1.2f, 0, 0, 0.5f), {0, 0, 1}, 1);
    add_quad(model, square(-0.5f, -0.5f, 1.2f, 1.2f, 1.5f), {0, 0, 1}, 2);
    add_quad(model, square(-1.2f, 0.2f, 0.3f, 1.2f, 1.2f), {0, 0, -1}, 2);
    add_quad(model, square(-1.3f, -1.3f, 1.3f, 1.3f, -1.5f), {0, 0, 1});
    return model;
}

const std::array frequencies = {ShadingFrequency::flat, ShadingFrequency::gouraud, ShadingFrequency::phong};

TEST(Render, ShowsTheBackgroundAndCountsTriangles) {
    RenderOptions options;
    options.background = {0, 1, 0, 1};
    Target target(8, 8);
    const DrawCounts none = render(target, Model{}, camera(), options);
    EXPECT_EQ(none.submitted, 0);
    for (const std::uint32_t pixel : target.color8()) EXPECT_EQ(pixel, 0xff00ff00u);

    const Model model = mixed_model();
    const DrawCounts counts = render(target, model, camera(), options);
    EXPECT_EQ(std::size_t(counts.submitted), model.triangle_count());
    EXPECT_EQ(counts.drawn + counts.zero_area, counts.submitted);
}

TEST(Render, LightsAWhiteSquareAsTheOptionsSay) {
    Model model;
    add_quad(model, square(-1, -1, 1, 1, 0), {0, 0, 1});
    RenderOptions options;
    Light light;
    light.direction = {0, -0.8f, -0.6f};
    light.ambient = glm::vec3(0.1f);
    options.lights = {light};
    options.default_material = Material{};
    options.default_material.diffuse = glm::vec3(0.5f);
    for (const ShadingFrequency frequency : frequencies) {
        options.frequency = frequency;
        const glm::vec4 color = picture(model, options).color(32, 32);
        EXPECT_NEAR(color.x, 0.5f * 0.1f + 0.5f * 0.6f, 0.003f);
        EXPECT_EQ(color.w, 1.0f);
    }
    options.ambient_color = AmbientColor::material;  // which has none
    EXPECT_NEAR(picture(model, options).color(32, 32).x, 0.3f, 0.003f);
    options.lights.push_back(light);
    EXPECT_NEAR(picture(model, options).color(32, 32).x, 0.6f, 0.003f);
    options.lights.clear();
    EXPECT_EQ(picture(model, options).color(32, 32).x, 0.0f);
}

TEST(Render, LooksGoodFromTheFrontByDefaultWhicheverWayThingsFace) {
    for (const glm::vec3 normal : {glm::vec3(0, 0, 1), glm::vec3(0, 0, -1)}) {
        Model model;
        auto corners = square(-1, -1, 1, 1, 0);
        if (normal.z < 0) std::swap(corners[1], corners[3]);
        add_quad(model, corners, normal);
        for (const ShadingFrequency frequency : frequencies) {
            RenderOptions options;
            options.frequency = frequency;
            const float value = picture(model, options).color(32, 32).x;
            EXPECT_GT(value, 0.6f);
            EXPECT_LT(value, 0.95f);
        }
    }
}

TEST(Render, TakesTheExponentFromTheMaterialOrFromTheOptions) {
    Model model;
    add_quad(model, square(-1, -1, 1, 1, 0), {0, 0, 1}, 0);
    model.materials.resize(1);
    model.materials[0].diffuse = glm::vec3(0.0f);
    model.materials[0].specular = glm::vec3(1.0f);
    model.materials[0].shininess = 8;
    RenderOptions options;
    Light light;
    light.direction = -at_degrees(30);  // r v = cos 30 in the middle
    options.lights = {light};
    options.reflectance = Phong{2};
    EXPECT_NEAR(picture(model, options).color(32, 32).x, std::pow(0.75, 4), 0.01);
    options.reflectance_from_material = false;
    EXPECT_NEAR(picture(model, options).color(32, 32).x, 0.75, 0.01);
    model.materials[0].illumination = 1;  // no highlight
    EXPECT_EQ(picture(model, options).color(32, 32).x, 0.0f);
}

TEST(Render, SeesParallelLightTheSameEverywhereWithoutPerspective) {
    CameraMatrices m;
    m.eye_from_world = look_at({0, 0, 5}, {0, 0, 0}, {0, 1, 0});
    m.clip_from_eye = orthographic(-1, 1, -1, 1, 1, 10);
    m.clip_from_world = product(m.clip_from_eye, m.eye_from_world);
    Model model;
    add_quad(model, square(-1, -1, 1, 1, 0), {0, 0, 1});
    Target target(64, 64);
    RenderOptions options;
    options.reflectance = Phong{};
    render(target, model, m, options);
    EXPECT_EQ(target.color(2, 2), target.color(60, 61));
    EXPECT_NE(picture(model, options).color(14, 14), picture(model, options).color(50, 50));  // the highlight's side
}

TEST(Render, DrawsWhatIsSeeThroughLastAndBackToFront) {
    // Listed front to back: the near pane first, then the far one, then the wall.
    Model model;
    model.materials.resize(3);
    for (auto& m : model.materials) m.illumination = 0;
    model.materials[0].diffuse = {1, 0, 0};
    model.materials[0].alpha = 0.5f;
    model.materials[1].diffuse = {0, 1, 0};
    model.materials[1].alpha = 0.25f;
    model.materials[2].diffuse = {0, 0, 1};
    add_quad(model, square(-1, -1, 1, 1, 1), {0, 0, 1}, 0);
    add_quad(model, square(-1, -1, 1, 1, 0.5f), {0, 0, 1}, 1);
    add_quad(model, square(-1, -1, 1, 1, 0), {0, 0, 1}, 2);
    const glm::vec3 expected(0.5f, 0.125f, 0.375f);
    for (const Visibility visibility : {Visibility::zbuffer, Visibility::painter}) {
        RenderOptions options;
        options.visibility = visibility;
        const glm::vec3 color(picture(model, options).color(32, 32));
        EXPECT_LT(glm::distance(color, expected), 0.01f);
    }
    RenderOptions options;
    options.blend = false;
    EXPECT_EQ(picture(model, options).color(32, 32), glm::vec4(1, 0, 0, 1));
    // A pane behind the wall is hidden, one that is never written to the depth buffer hides nothing.
    for (auto& v : model.vertices) v.position.z = -v.position.z;
    EXPECT_EQ(picture(model).color(32, 32), glm::vec4(0, 0, 1, 1));
}

TEST(Render, ReadsAlphaAndColourFromTextures) {
    Model model;
    model.textures.resize(1);
    model.textures[0].image = Image8(2, 1, 4);
    model.textures[0].image.samples = {255, 0, 0, 0, 0, 255, 0, 255};  // clear red, solid green
    model.materials.resize(1);
    model.materials[0].illumination = 0;
    model.materials[0].diffuse = glm::vec3(1.0f);
    model.materials[0].diffuse_texture = model.materials[0].alpha_texture = 0;
    add_quad(model, square(-1, -1, 1, 1, 0), {0, 0, 1}, 0);
    RenderOptions options;
    options.filter = Filter::nearest;
    options.background = {0, 0, 1, 1};
    const Target target = picture(model, options);
    EXPECT_EQ(target.color(20, 32), glm::vec4(0, 0, 1, 1));
    EXPECT_EQ(target.color(44, 32), glm::vec4(0, 1, 0, 1));
    options.textures = false;
    EXPECT_EQ(picture(model, options).color(20, 32), glm::vec4(1, 1, 1, 1));
}

TEST(Render, FillsTheExtraPlanesWithoutChangingThePicture) {
    const Model model = mixed_model();
    for (const ShadingFrequency frequency : frequencies) {
        RenderOptions options;
        options.frequency = frequency;
        options.blend = false;
        const Target plain = picture(model, options), planes = picture(model, options, shaded_plane::count);
        std::size_t drawn = 0;
        for (int y = 0; y < 64; ++y) {
            for (int x = 0; x < 64; ++x) {
                const std::size_t i = planes.index(x, y);
                const auto plane = [&](int first, int channel) { return planes.extra(first + channel)[i]; };
                const glm::vec4 color = planes.color(x, y);
                if (frequency == ShadingFrequency::gouraud) {
                    ASSERT_LE(glm::distance(plain.color(x, y), color), 2 / 255.0f);
                } else {
                    ASSERT_EQ(plain.color(x, y), color);
                }
                const float triangle = plane(shaded_plane::triangle, 0);
                ASSERT_EQ(triangle == 0, planes.depth()[i] == 0xffffffu);
                if (triangle == 0) continue;
                ++drawn;
                ASSERT_LE(triangle, float(model.triangle_count()));
                for (int c = 0; c < 3; ++c) {
                    const float sum = plane(shaded_plane::emission, c) + plane(shaded_plane::ambient, c) +
                                      plane(shaded_plane::diffuse, c) + plane(shaded_plane::specular, c);
                    ASSERT_NEAR(std::min(sum, 1.0f), color[c], 0.51f / 255);
                }
                const glm::vec3 n(plane(shaded_plane::normal, 0), plane(shaded_plane::normal, 1),
                                  plane(shaded_plane::normal, 2));
                ASSERT_NEAR(glm::length(n), 1, 1e-5);
            }
        }
        EXPECT_GT(drawn, 2000u);
    }
}

TEST(Render, NumbersTrianglesAsTheModelDoesInAnyOrderOfDrawing) {
    const Model model = mixed_model();
    RenderOptions options;
    options.blend = false;
    const Target by_depth = picture(model, options, shaded_plane::triangle + 1);
    std::size_t seen = 0;
    for (int y = 0; y < 64; ++y) {
        for (int x = 0; x < 64; ++x) {
            const int number = int(by_depth.extra(shaded_plane::triangle)[by_depth.index(x, y)]) - 1;
            if (number < 0) continue;
            // The same triangle alone covers this pixel.
            if ((x + y) % 7) continue;
            Model one = model;
            one.parts.clear();
            one.indices.assign(model.indices.begin() + 3 * number, model.indices.begin() + 3 * number + 3);
            ASSERT_NE(picture(one, options).depth()[by_depth.index(x, y)], 0xffffffu);
            ++seen;
        }
    }
    EXPECT_GT(seen, 200u);
    options.visibility = Visibility::painter;
    options.frequency = ShadingFrequency::flat;
    Model layers;
    layers.materials.resize(2);
    for (int i = 0; i < 4; ++i)
        add_quad(layers, square(-1, -1, 1.0f - 0.5f * float(i), 1, float(i % 3)), {0, 0, 1}, i % 2);
    const Target painted = picture(layers, options, shaded_plane::triangle + 1);
    options.visibility = Visibility::zbuffer;
    EXPECT_EQ(painted.extra(shaded_plane::triangle),
              picture(layers, options, shaded_plane::triangle + 1).extra(shaded_plane::triangle));
    EXPECT_EQ(painted.color8(), picture(layers, options).color8());
}

TEST(Render, IsTheSameWhenItsDrawsAreObserved) {
    struct Counter {
        std::size_t fragments = 0;
        void on(const FragmentEvent&) { ++fragments; }
    };
    const Model model = mixed_model();
    for (const ShadingFrequency frequency : frequencies) {
        for (const Visibility visibility : {Visibility::zbuffer, Visibility::painter}) {
            for (const int planes : {0, int(shaded_plane::count)}) {
                RenderOptions options;
                options.frequency = frequency;
                options.visibility = visibility;
                const Target expected = picture(model, options, planes);
                Target target(64, 64, ColorFormat::rgba8, DepthFormat::unorm24, planes);
                target.clear(options.background);
                Counter counter;
                DrawPlan(model, options, planes > 0).for_each(camera(), [&](const PlannedDraw& planned) {
                    with_shader(planned, [&](const auto& shader, const auto& mesh, const State& state) {
                        draw(target, shader, mesh, state, counter);
                    });
                });
                EXPECT_GT(counter.fragments, 2000u);
                EXPECT_EQ(target.color8(), expected.color8());
                EXPECT_EQ(target.depth(), expected.depth());
                for (int e = 0; e < planes; ++e) EXPECT_EQ(target.extra(e), expected.extra(e)) << e;
            }
        }
    }
}

TEST(RenderOverdraw, CountsTheWritesOfEachPixel) {
    Model model;
    for (const float z : {0.0f, 1.0f, 0.5f}) add_quad(model, square(-1, -1, 0.5f, 1, z), {0, 0, 1});
    Target counts(64, 64, ColorFormat::rgba_float);
    RenderOptions options;
    render_overdraw(counts, model, camera(), options);
    EXPECT_EQ(counts.color(20, 32).x, 2.0f);  // the third is behind the second
    EXPECT_EQ(counts.color(60, 32).x, 0.0f);
    options.visibility = Visibility::painter;
    render_overdraw(counts, model, camera(), options);
    EXPECT_EQ(counts.color(20, 32).x, 3.0f);
}

}  // namespace
