// scene_hash.cpp: FNV-1a over what draws are told (http://www.isthe.com/chongo/tech/comp/fnv/).
#include <raster/trace/scene_hash.h>

#include <bit>
#include <cstdio>
#include <map>
#include <type_traits>

#include <raster/scene/draw_plan.h>

namespace raster {
namespace {

class Hash {
public:
    template <class T>
    requires(std::is_arithmetic_v<T> || std::is_enum_v<T>) void add(T value) {
        if constexpr (std::is_floating_point_v<T>) {
            add(std::bit_cast<std::uint32_t>(float(value)));
        } else {
            const auto bits = std::uint64_t(value);
            for (int shift = 0; shift < 64; shift += 8) state_ = (state_ ^ (bits >> shift & 255)) * 0x100000001b3u;
        }
    }
    template <int N>
    void add(const glm::vec<N, float>& v) {
        for (int i = 0; i < N; ++i) add(v[i]);
    }
    template <int C, int R>
    void add(const glm::mat<C, R, float>& m) {
        for (int c = 0; c < C; ++c) add(m[c]);
    }
    void add(const SurfaceVertex<float>& v) {
        add(v.position);
        add(v.normal);
        add(v.uv);
        add(v.color);
    }
    template <class T>
    void add(std::span<const T> values) {
        add(values.size());
        for (const T& value : values) add(value);
    }
    std::uint64_t value() const { return state_; }

private:
    std::uint64_t state_ = 0xcbf29ce484222325u;
};

/// Adds draws. A texture is read once, however many draws use it.
class DrawHash {
public:
    explicit DrawHash(Hash& hash) : hash_(hash) {}

    void add(const PlannedDraw& d) {
        hash_.add(d.frequency);
        hash_.add(d.level);
        add(d.state);
        const ShadingUniforms& u = d.uniforms;
        hash_.add(u.clip_from_object);
        hash_.add(u.eye_from_object);
        hash_.add(u.world_from_eye);
        hash_.add(u.ambient);
        for (const EyeLight& light : u.lights) add(light);
        add(u.material);
        hash_.add(u.grain_eye);
        hash_.add(u.grain_turn);
        hash_.add(u.two_sided);
        hash_.add(u.viewer_eye);
        hash_.add(u.first_triangle);
        hash_.add(u.triangle_numbers);
        hash_.add(d.mesh.indices.size());
        add(d.reflectance);
    }

private:
    void add(const State& s) {
        hash_.add(s.cull);
        hash_.add(s.fill_rule);
        hash_.add(s.depth_compare);
        hash_.add(s.depth_write);
        hash_.add(s.blend);
        hash_.add(s.scissor.has_value());
        const Scissor scissor = s.scissor.value_or(Scissor{});
        for (const int number : {scissor.x, scissor.y, scissor.width, scissor.height}) hash_.add(number);
        hash_.add(s.depth_offset.factor);
        hash_.add(s.depth_offset.units);
        hash_.add(s.clip_planes);
    }
    void add(const EyeLight& light) {
        hash_.add(light.kind);
        for (const glm::vec3& v : {light.diffuse, light.specular, light.position_eye, light.direction_eye})
            hash_.add(v);
        for (const float number : {light.attenuation.c1, light.attenuation.c2, light.attenuation.c3, light.cos_cutoff,
                                   light.falloff_exponent})
            hash_.add(number);
    }
    void add(const SurfaceMaterial& m) {
        for (const glm::vec3& color : {m.ambient, m.diffuse, m.specular, m.emission}) hash_.add(color);
        hash_.add(m.alpha);
        for (const TextureView* view :
             {&m.ambient_texture, &m.diffuse_texture, &m.specular_texture, &m.emission_texture, &m.alpha_texture}) {
            hash_.add(texels_of(*view));
            hash_.add(view->wrap);
            hash_.add(view->filter);
            hash_.add(view->decode != nullptr);
        }
        hash_.add(m.alpha_texture_has_alpha);
        hash_.add(m.ambient_is_diffuse);
        hash_.add(m.vertex_colors);
    }
    /// A model is what it answers: its parameters show in some of these.
    void add(const AnyReflectance& reflectance) {
        hash_.add(reflectance.index());
        const RuntimeModel model{reflectance};
        const Frame<float> frame{{0, 0, 1}, {0.6f, 0, 0.8f}, {1, 0, 0}, {0, 1, 0}};
        for (const glm::vec3& l :
             {glm::vec3(0, 0, 1), {-0.48f, 0.36f, 0.8f}, {0.8f, 0, 0.6f}, {-0.8f, -0.36f, 0.48f}}) {
            const Reflectance<float> value = model.evaluate(frame, l);
            hash_.add(value.diffuse);
            hash_.add(value.specular);
        }
    }
    std::uint64_t texels_of(const TextureView& view) {
        if (!view) return 0;
        const auto [place, is_new] = textures_.try_emplace(view.texels, 0);
        if (is_new) {
            Hash hash;
            hash.add(view.width);
            hash.add(std::span<const std::int32_t>(view.texels, std::size_t(view.width) * std::size_t(view.height)));
            place->second = hash.value();
        }
        return place->second;
    }

    Hash& hash_;
    std::map<const std::int32_t*, std::uint64_t> textures_;
};

}  // namespace

std::string scene_hash(const Model& model, const CameraMatrices& camera, const RenderOptions& options, int width,
                       int height) {
    Hash hash;
    hash.add(width);
    hash.add(height);
    hash.add(options.background);
    hash.add(std::span<const SurfaceVertex<float>>(model.vertices));
    hash.add(std::span<const std::uint32_t>(model.indices));
    DrawHash draws(hash);
    DrawPlan(model, options, false).for_each(camera, [&](const PlannedDraw& planned) { draws.add(planned); });
    char text[20];
    std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(hash.value()));
    return text;
}

}  // namespace raster
