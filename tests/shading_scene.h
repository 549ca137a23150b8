// shading_scene.h: uniforms, lights and a triangle for the tests of the shaders.
#pragma once

#include <gtest/gtest.h>
#include <raster/pipeline.h>
#include <raster/scene/transform.h>
#include <raster/shading/flat_shader.h>
#include <raster/shading/gouraud_shader.h>
#include <raster/shading/pixel_shader.h>

#include "shading_testing.h"

namespace raster::testing {

/// Uniforms whose object space is eye space, with a camera of 90 degrees, that own what they point to.
struct Scene {
    std::vector<EyeLight> lights;
    PackedTexture texture;
    ShadingUniforms u;

    explicit Scene(std::vector<Light> from = {Light{}}) {
        for (const Light& light : from) lights.push_back(to_eye(light, glm::mat4(1.0f)));
        u.clip_from_object = perspective(90, 1, 0.1, 100);
        u.lights = lights;
        u.ambient = {0.1f, 0.2f, 0.3f};
        u.material.ambient = {0.5f, 0.25f, 1};
        u.material.diffuse = {0.8f, 0.6f, 0.4f};
        u.material.specular = {0.3f, 0.3f, 0.5f};
        u.material.emission = {0.01f, 0.02f, 0.03f};
    }
    void set_texture(const Image8& image) {
        texture = pack_texture(image);
        u.material.diffuse_texture = TextureView(texture, Wrap::repeat, Filter::bilinear);
    }
};

inline std::vector<Light> three_kinds_of_light() {
    Light sun, bulb, lamp;
    sun.direction = {1, -1, -2};
    bulb.kind = LightKind::point;
    bulb.position = {0.5f, 1, 1};
    bulb.attenuation = {0.5f, 0.1f, 0.1f};
    lamp.kind = LightKind::spot;
    lamp.position = {-1, 0, 2};
    lamp.direction = {0.2f, 0, -1};
    lamp.falloff_exponent = 4;
    return {sun, bulb, lamp};
}

inline Image8 checker() {
    Image8 image(4, 4, 3);
    for (std::size_t i = 0; i < image.samples.size(); ++i) image.samples[i] = std::uint8_t(37 * i);
    return image;
}

template <class S>
Target draw_scene(const S& shader, const Mesh<SurfaceVertex<float>>& mesh, const State& state = {}) {
    Target target(64, 64, ColorFormat::rgba_float, DepthFormat::float32, shaded_plane::count);
    target.clear({0, 0, 0, 0});
    draw(target, shader, mesh, state, NoObserver{});
    return target;
}

/// Pixels that were drawn.
template <class See>
void for_each_drawn(const Target& target, const See& see) {
    int drawn = 0;
    for (int y = 0; y < target.height(); ++y) {
        for (int x = 0; x < target.width(); ++x) {
            if (target.color(x, y).w == 0) continue;
            ++drawn;
            see(x, y, target.color(x, y));
        }
    }
    EXPECT_GT(drawn, 100);
}

inline const std::vector<SurfaceVertex<float>> slanted = {vertex_at({-1, -1, -1.5f}), vertex_at({2, -1, -3}),
                                                          vertex_at({0, 1, -2})};

}  // namespace raster::testing
