// stage_pictures.cpp: one picture a stage, most of them planes of one render.
#include <raster/step/stage_pictures.h>

#include <algorithm>

#include <raster/pipeline.h>
#include <raster/scene/position_shader.h>
#include <raster/scene/transform.h>
#include <raster/shading/uniforms.h>

namespace raster {
namespace {

const glm::vec4 paper{0.09f, 0.10f, 0.13f, 1.0f};
const glm::vec4 ink{0.50f, 0.71f, 1.0f, 1.0f};

struct OneColor {
    template <class F>
    vec<4, F> operator()(const FragmentInput<F>&) const {
        return {F(ink.r), F(ink.g), F(ink.b), F(1)};
    }
};

struct ColorOfTriangle {
    template <class F>
    vec<4, F> operator()(const FragmentInput<F>& at) const {
        const Int<F> number = at.triangle * Int<F>(7919) + Int<F>(12345);  // neighbours far apart
        const auto channel = [&](int shift) {
            return F(0.25f) + to_float((number >> shift) & Int<F>(63)) * F(0.7f / 63.0f);
        };
        return {channel(0), channel(3), channel(7), F(1)};
    }
};

/// An RGB picture whose samples are value(index of the pixel, channel), 0 to 1.
template <class Value>
Image8 picture_of(const Target& target, const Value& value) {
    Image8 image(target.width(), target.height(), 3);
    for (std::size_t i = 0; i < image.samples.size() / 3; ++i)
        for (int c = 0; c < 3; ++c) image.samples[3 * i + std::size_t(c)] = std::uint8_t(to_unorm8(value(i, c)));
    return image;
}

Image8 colors_of(const Target& target) {
    return picture_of(target,
                      [&](std::size_t i, int c) { return float(target.color8()[i] >> (8 * c) & 255) / 255.0f; });
}

/// The edges of all triangles, two indices each.
std::vector<std::uint32_t> edges_of(const Model& model) {
    std::vector<std::uint32_t> edges;
    for (std::size_t t = 0; t < model.triangle_count(); ++t)
        for (std::size_t c = 0; c < 3; ++c)
            edges.insert(edges.end(), {model.indices[3 * t + c], model.indices[3 * t + (c + 1) % 3]});
    return edges;
}

/// As many parts as there are pictures, those so far filled.
void add_bar(Image8& image, std::size_t done, std::size_t count) {
    const int height = std::max(image.height / 60, 2);
    for (int y = image.height - height; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) {
            const std::size_t part = std::size_t(x) * count / std::size_t(image.width);
            const glm::vec4& color = part <= done ? ink : paper;
            for (int c = 0; c < 3; ++c) image.pixel(x, y)[c] = std::uint8_t(to_unorm8(color[c]));
        }
}

}  // namespace

std::vector<StagePicture> stage_pictures(const Model& model, const CameraMatrices& camera, int width, int height,
                                         const RenderOptions& options, const Display& display) {
    const glm::mat4 clip_from_object = product(camera.clip_from_world, options.world_from_object);
    std::vector<StagePicture> pictures;
    Target plain(width, height);
    const auto add_plain = [&](const char* name, const auto& shader, std::span<const std::uint32_t> indices,
                               const State& state) {
        plain.clear(paper);
        draw(plain, shader, {model.vertices, indices}, state);
        pictures.push_back({name, colors_of(plain)});
    };
    const PositionShader<OneColor> one_color{clip_from_object, {}};
    const PositionShader<ColorOfTriangle> triangle_colors{clip_from_object, {}};
    State state;
    state.cull = options.cull;
    state.fill_rule = options.fill_rule;
    state.topology = Topology::points;
    state.point_size = 2;
    add_plain("vertex", one_color, model.indices, state);
    state.topology = Topology::lines;
    add_plain("assemble", one_color, edges_of(model), state);
    state.topology = Topology::triangles;
    state.depth_compare = Compare::always;
    add_plain("coverage", triangle_colors, model.indices, state);
    state.depth_compare = Compare::less;
    add_plain("depth", triangle_colors, model.indices, state);

    float near_depth = 1, far_depth = 0;
    for (const std::uint32_t stored : plain.depth()) {
        const float z = decode_depth(plain.depth_format(), stored);
        if (z < 1) near_depth = std::min(near_depth, z), far_depth = std::max(far_depth, z);
    }
    const float span = std::max(far_depth - near_depth, 1e-6f);
    pictures.push_back({"depth values", picture_of(plain, [&](std::size_t i, int) {
                            const float z = decode_depth(plain.depth_format(), plain.depth()[i]);
                            return z < 1 ? 1.0f - 0.85f * (z - near_depth) / span : 0.0f;
                        })});

    Target target(width, height, display.is_plain() ? ColorFormat::rgba8 : ColorFormat::rgba_float,
                  DepthFormat::unorm24, shaded_plane::count);
    RenderOptions lit = options;
    lit.background = light_for(options.background, display);
    render(target, model, camera, lit);
    pictures.push_back({"interpolate", picture_of(target, [&](std::size_t i, int c) {
                            const bool hit = target.extra(shaded_plane::triangle)[i] > 0;
                            return hit ? target.extra(shaded_plane::normal + c)[i] * 0.5f + 0.5f : paper[c];
                        })});
    struct Term {
        const char* name;
        int plane;
    };
    for (const Term& term : {Term{"ambient", shaded_plane::ambient}, Term{"diffuse", shaded_plane::diffuse},
                             Term{"specular", shaded_plane::specular}})
        pictures.push_back({term.name, picture_of(target, [&](std::size_t i, int c) {
                                return shown_value(target.extra(term.plane + c)[i], display);
                            })});
    pictures.push_back({"blend", colors_of(display.is_plain() ? target : displayed(target, display))});
    for (std::size_t i = 0; i < pictures.size(); ++i) add_bar(pictures[i].image, i, pictures.size());
    return pictures;
}

}  // namespace raster
