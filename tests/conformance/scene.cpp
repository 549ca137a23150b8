// scene.cpp: comparing pictures, and drawing a scene with the library.
#include "scene.h"

#include <algorithm>
#include <cstdlib>

#include <raster/pipeline.h>

namespace raster::conformance {

Difference compare(const Picture& a, const Picture& b) {
    Difference difference;
    for (std::size_t i = 0; i < a.color.size(); ++i) {
        const bool color = a.color[i] != b.color[i], depth = a.depth[i] != b.depth[i];
        if ((color || depth) && difference.none()) difference.first = i;
        difference.color_pixels += color;
        difference.depth_pixels += depth;
        for (int shift = 0; shift < 32; shift += 8) {
            const int delta = int(a.color[i] >> shift & 255) - int(b.color[i] >> shift & 255);
            difference.largest = std::max(difference.largest, std::abs(delta));
        }
    }
    return difference;
}

std::string describe(const Difference& difference, int width) {
    return std::to_string(difference.color_pixels) + " colours (at most " + std::to_string(difference.largest) +
           "/255) and " + std::to_string(difference.depth_pixels) + " depths differ, first at (" +
           std::to_string(difference.first % std::size_t(width)) + ", " +
           std::to_string(difference.first / std::size_t(width)) + ")";
}

std::uint64_t hash_of(const Picture& picture) {
    std::uint64_t hash = 0xcbf29ce484222325u;
    for (const auto* plane : {&picture.color, &picture.depth})
        for (const std::uint32_t value : *plane) hash = (hash ^ value) * 0x100000001b3u;
    return hash;
}

namespace {

template <Interpolation how>
struct Colored {
    template <class F>
    struct Vertex {
        vec<4, F> position, color;
        vec<2, F> uv;
    };
    template <class F>
    struct Varyings {
        vec<4, F> color;
    };
    static constexpr Interpolation interpolation(int) { return how; }
    template <class F>
    VertexOut<F, Varyings> vertex(const Vertex<F>& v) const {
        return {v.position, {v.color}};
    }
    template <class F>
    vec<4, F> fragment(const Varyings<F>& in) const {
        return in.color;
    }
};

/// A texture times the colour, as GL_MODULATE.
struct Textured {
    template <class F>
    struct Vertex {
        vec<4, F> position, color;
        vec<2, F> uv;
    };
    template <class F>
    struct Varyings {
        vec<4, F> color;
        vec<2, F> uv;
    };
    TextureView texture;
    template <class F>
    VertexOut<F, Varyings> vertex(const Vertex<F>& v) const {
        return {v.position, {v.color, v.uv}};
    }
    template <class F>
    vec<4, F> fragment(const Varyings<F>& in) const {
        return sample<F>(texture, in.uv) * in.color;
    }
};

template <class S>
void draw_with(const S& shader, Target& target, const Draw& d, Path path) {
    using V = typename S::template Vertex<float>;
    std::vector<V> vertices;
    for (const Vertex& v : d.vertices) vertices.push_back({v.position, v.color, v.uv});
    const Mesh<V> mesh{vertices, d.indices};
    if (path == Path::fast) {
        draw(target, shader, mesh, d.full_state());
    } else {
        draw(target, shader, mesh, d.full_state(), NoObserver{});
    }
}

}  // namespace

Picture render(const Scene& scene, Path path) {
    Target target(scene.width, scene.height);
    target.clear(scene.clear_color, scene.clear_depth);
    for (const Draw& d : scene.draws) {
        switch (d.coloring) {
            case Coloring::flat: draw_with(Colored<Interpolation::flat>{}, target, d, path); break;
            case Coloring::noperspective: draw_with(Colored<Interpolation::noperspective>{}, target, d, path); break;
            case Coloring::textured: {
                const TextureView view(d.texture.image, d.texture.wrap, d.texture.filter);
                draw_with(Textured{view}, target, d, path);
                break;
            }
            case Coloring::smooth:
            case Coloring::fixed_function: draw_with(Colored<Interpolation::smooth>{}, target, d, path); break;
        }
    }
    return {target.color8(), target.depth()};
}

}  // namespace raster::conformance
