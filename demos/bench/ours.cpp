// ours.cpp: four small shaders, and a frame.
#include "ours.h"

#include <raster/scene/draw_plan.h>
#include <raster/scene/transform.h>

namespace bench {

namespace {

using namespace raster;

/// Blinn-Phong with a local viewer, one directional light.
template <class F>
vec<3, F> blinn_phong(const vec<3, F>& normal, const vec<3, F>& eye_position, const glm::vec3& to_light) {
    Frame<F> frame;
    frame.n = normalize_or_zero(normal), frame.v = normalize_or_zero(-eye_position);
    const Reflectance<F> value = BlinnPhong{exponent}.evaluate(frame, vec<3, F>(to_light));
    return vec<3, F>(base_color) * (F(ambient) + F(diffuse) * value.diffuse.x) + F(specular) * value.specular;
}

template <class F>
struct EyeVaryings {
    vec<3, F> normal, position;
};

struct PerPixel {
    template <class F>
    using Vertex = bench::Vertex<F>;
    template <class F>
    using Varyings = EyeVaryings<F>;
    glm::mat4 clip_from_world, eye_from_world;
    glm::mat3 normals;
    glm::vec3 to_light;

    template <class F>
    VertexOut<F, Varyings> vertex(const Vertex<F>& v) const {
        return {transform_point(clip_from_world, v.position),
                {transform_direction(normals, v.normal), vec<3, F>(transform_point(eye_from_world, v.position))}};
    }
    template <class F>
    vec<4, F> fragment(const Varyings<F>& in) const {
        return {blinn_phong(in.normal, in.position, to_light), F(1)};
    }
};

template <class F>
struct ColorVaryings {
    vec<3, F> color;
};

struct Gouraud {
    template <class F>
    using Vertex = bench::Vertex<F>;
    template <class F>
    using Varyings = ColorVaryings<F>;
    glm::mat4 clip_from_world, eye_from_world;
    glm::mat3 normals;
    glm::vec3 to_light;

    template <class F>
    VertexOut<F, Varyings> vertex(const Vertex<F>& v) const {
        const vec<3, F> eye(transform_point(eye_from_world, v.position));
        return {transform_point(clip_from_world, v.position),
                {blinn_phong(transform_direction(normals, v.normal), eye, to_light)}};
    }
    template <class F>
    vec<4, F> fragment(const Varyings<F>& in) const {
        return {in.color, F(1)};
    }
};

template <class F>
struct TexturedVaryings {
    vec<3, F> normal;
    vec<2, F> uv;
};

struct Textured {
    template <class F>
    using Vertex = bench::Vertex<F>;
    template <class F>
    using Varyings = TexturedVaryings<F>;
    glm::mat4 clip_from_world;
    glm::mat3 normals;
    glm::vec3 to_light;
    TextureView texture;

    template <class F>
    VertexOut<F, Varyings> vertex(const Vertex<F>& v) const {
        return {transform_point(clip_from_world, v.position), {transform_direction(normals, v.normal), v.uv}};
    }
    template <class F>
    vec<4, F> fragment(const Varyings<F>& in) const {
        const F n_l = dot0(glm::normalize(in.normal), vec<3, F>(to_light));
        const vec<4, F> texel = sample(texture, in.uv);
        return {vec<3, F>(texel) * (F(ambient) + F(diffuse) * n_l), F(1)};
    }
};

template <class F>
struct NoVaryings {};

struct FlatColor {
    template <class F>
    using Vertex = bench::Vertex<F>;
    template <class F>
    using Varyings = NoVaryings<F>;
    glm::mat4 clip_from_world;
    glm::vec4 color;

    template <class F>
    VertexOut<F, Varyings> vertex(const Vertex<F>& v) const {
        return {transform_point(clip_from_world, v.position), {}};
    }
    template <class F>
    vec<4, F> fragment(const Varyings<F>&) const {
        return vec<4, F>(color);
    }
};

struct DepthOnly {
    template <class F>
    using Vertex = bench::Vertex<F>;
    template <class F>
    using Varyings = NoVaryings<F>;
    glm::mat4 clip_from_world;

    template <class F>
    VertexOut<F, Varyings> vertex(const Vertex<F>& v) const {
        return {transform_point(clip_from_world, v.position), {}};
    }
};

}  // namespace

Ours::Ours(const Scene& scene, int width, int height)
    : scene_(scene),
      target_(width, height),
      clip_from_eye_(projection(width, height)),
      clip_from_world_(raster::product(clip_from_eye_, scene.eye_from_world)),
      normals_(scene.eye_from_world) {}

/// The pixel shader that a picture of a model gets, with the model's default parameters but a metal for cook-torrance.
void Ours::draw_reflectance(const State& state) {
    if (surface_.empty())
        for (const Vertex<float>& v : scene_.vertices)
            surface_.push_back({v.position, v.normal, v.uv, glm::vec3(1.0f)});
    Light light;
    light.direction = -to_light_eye();
    light.space = LightSpace::eye;
    light.ambient = glm::vec3(ambient);
    light.diffuse = glm::vec3(diffuse);
    light.specular = glm::vec3(specular);
    const Lighting lighting = make_lighting({&light, 1}, scene_.eye_from_world);
    PlannedDraw draw{};
    draw.frequency = ShadingFrequency::phong;
    draw.level = Detail::plain;
    draw.uniforms.clip_from_object = clip_from_world_;
    draw.uniforms.eye_from_object = scene_.eye_from_world;
    draw.uniforms.eye_from_object_normal = normals_;
    draw.uniforms.ambient = lighting.ambient;
    draw.uniforms.lights = lighting.lights;
    draw.uniforms.material.ambient = draw.uniforms.material.diffuse = base_color;
    draw.uniforms.material.specular = glm::vec3(1.0f);
    draw.reflectance = *find_reflectance(scene_.reflectance);
    if (auto* metal = std::get_if<CookTorrance>(&draw.reflectance)) metal->fresnel = {metal_n, metal_k};
    draw.mesh = {surface_, scene_.indices};
    draw.state = state;
    draw_pixel_shaded(target_, draw);
}

void Ours::frame() {
    target_.clear(clear_color);
    State state;
    state.cull = scene_.cull_back ? Cull::back : Cull::none;
    state.blend = scene_.blend ? Blend::source_over : Blend::off;
    const Mesh mesh(scene_.vertices, scene_.indices);
    const glm::vec3 light = to_light_eye();
    const glm::mat4& eye = scene_.eye_from_world;
    switch (scene_.shading) {
        case Shading::none: raster::draw(target_, DepthOnly{clip_from_world_}, mesh, state); break;
        case Shading::flat_color:
            raster::draw(target_, FlatColor{clip_from_world_, glm::vec4(base_color, scene_.blend ? 0.5f : 1.0f)}, mesh,
                         state);
            break;
        case Shading::gouraud:
            raster::draw(target_, Gouraud{clip_from_world_, eye, normals_, light}, mesh, state);
            break;
        case Shading::per_pixel:
            raster::draw(target_, PerPixel{clip_from_world_, eye, normals_, light}, mesh, state);
            break;
        case Shading::reflectance: draw_reflectance(state); break;
        case Shading::textured:
            raster::draw(target_,
                         Textured{clip_from_world_, normals_, light,
                                  TextureView(scene_.texture, Wrap::repeat, Filter::bilinear)},
                         mesh, state);
            break;
    }
    // A clear alone is finished by whoever looks.
    target_.color8();
}

}  // namespace bench
