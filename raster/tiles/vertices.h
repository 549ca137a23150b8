// vertices.h: driver of stages 1 and 4: shade and project all vertices of a draw, a pack of lanes at a time.
#pragma once

#include <limits>

#include <raster/stages/clip.h>
#include <raster/stages/project.h>
#include <raster/tiles/parallel.h>
#include <raster/tiles/scratch.h>

namespace raster::tiles {

/// The bit beside the six of an outcode that marks a position with a NaN or an infinity.
inline constexpr std::uint8_t not_finite_bit = 1 << clip_plane_count;
/// And the one that marks a position outside of any plane of the user's.
inline constexpr std::uint8_t user_plane_bit = not_finite_bit << 1;

/// The shaded vertices of a draw. A vertex that is outside any plane has a NaN
/// as window x: its triangles take the slow way through the clip stage, and all others need not look at outcodes.
template <Shader S>
struct VertexBuffer {
    std::span<WindowVertex<float>> window;
    std::span<std::uint8_t> outcodes;
    std::span<VaryingArray<S>> varyings;
};

/// lanes<F> consecutive vertices as one vertex of lanes; those past the end repeat the last.
template <Shader S, class F>
inline typename S::template Vertex<F> load_vertices(std::span<const typename S::template Vertex<float>> vertices,
                                                    std::size_t start) {
    constexpr int count = attribute_count<S>;
    std::array<F, std::size_t(count)> attributes;
    const float* base = reinterpret_cast<const float*>(vertices.data());
    for (int lane = 0; lane < lanes<F>; ++lane) {
        const float* p = base + std::min(start + std::size_t(lane), vertices.size() - 1) * std::size_t(count);
        for (int a = 0; a < count; ++a) attributes[std::size_t(a)].v[lane] = p[a];
    }
    typename S::template Vertex<F> result;
    static_assert(sizeof result == sizeof attributes);
    std::memcpy(static_cast<void*>(&result), attributes.data(), sizeof result);
    return result;
}

/// Shades and projects one pack of vertices into the buffer.
template <Shader S, class F>
RASTER_FLATTEN inline void shade_pack(const S& shader, std::span<const typename S::template Vertex<float>> vertices,
                       const ViewportTransform& viewport, UserPlanes user, VertexBuffer<S>& out, std::size_t start) {
    const auto shaded = shade_vertex<S, F>(shader, load_vertices<S, F>(vertices, start));
    Int<F> inside_code = outcode(shaded.clip);
    if (!user.empty())
        inside_code =
            inside_code | select(user_outcode(user, shaded.clip) == Int<F>(0), Int<F>(0), Int<F>(user_plane_bit));
    const Int<F> code = select(is_finite(shaded.clip), inside_code, Int<F>(not_finite_bit));
    WindowVertex<F> window = project(shaded.clip, viewport);
    window.x = select(code == Int<F>(0), window.x, F(std::numeric_limits<float>::quiet_NaN()));
    const int count = int(std::min(std::size_t(lanes<F>), vertices.size() - start));
    for (int lane = 0; lane < count; ++lane) {
        const std::size_t i = start + std::size_t(lane);
        out.window[i] = {window.x.v[lane], window.y.v[lane], window.z.v[lane], window.oow.v[lane]};
        out.outcodes[i] = std::uint8_t(code.v[lane]);
        for (std::size_t k = 0; k < std::size_t(varying_count<S>); ++k)
            out.varyings[i][k] = shaded.varyings[k].v[lane];
    }
}

/// Shades all of `vertices`.
template <Shader S>
inline VertexBuffer<S> shade_vertices(const S& shader, std::span<const typename S::template Vertex<float>> vertices,
                                      const ViewportTransform& viewport, UserPlanes user, Scratch& scratch) {
    VertexBuffer<S> out{scratch.window.get<WindowVertex<float>>(vertices.size()),
                        scratch.outcodes.get<std::uint8_t>(vertices.size()),
                        scratch.varyings.get<VaryingArray<S>>(vertices.size())};
    constexpr std::size_t chunk = 4096;
    parallel_for((vertices.size() + chunk - 1) / chunk, [&](std::size_t c) {
        const std::size_t end = std::min((c + 1) * chunk, vertices.size());
        for (std::size_t i = c * chunk; i < end; i += std::size_t(lanes<FloatN>))
            shade_pack<S, FloatN>(shader, vertices, viewport, user, out, i);
    });
    return out;
}

}  // namespace raster::tiles
