// pixel.h: the last four stages of the pipeline at one covered pixel: depth, interpolate, fragment, blend.
#pragma once

#include <raster/shader.h>
#include <raster/stages/blend.h>
#include <raster/stages/depth.h>
#include <raster/stages/fragment.h>
#include <raster/stages/interpolate.h>
#include <raster/target.h>
#include <raster/trace/events.h>

namespace raster {

/// Which pixel of which primitive.
struct PixelPlace {
    std::int64_t triangle;  ///< or line, or point: its number in the draw
    int piece;
    int x, y;
    bool front_facing;
};

/// Draws one pixel and tells the observer, stage by stage.
template <Shader S, class Observer>
inline void draw_pixel(Target& target, const S& shader, const State& state, const PixelPlace& at,
                       const DepthPlane<float>& depth, const VaryingPlanes<S, float>& planes, Observer& observer) {
    const int x = at.x, y = at.y;
    const float px = float(x), py = float(y);
    const float z = value_at(depth, px, py);
    const std::size_t place = target.index(x, y);
    std::uint32_t& stored = target.depth()[place];
    const std::int32_t incoming = encode_depth(target.depth_format(), z);
    const bool passed = depth_passes(state.depth_compare, incoming, std::int32_t(stored));
    notify<DepthEvent>(observer, [&] {
        return DepthEvent{at.triangle, at.piece, at.x, at.y, z, std::uint32_t(incoming), stored, passed};
    });
    if (!passed) return;
    if (state.depth_write) stored = std::uint32_t(incoming);

    if constexpr (HasFragment<S>) {
        if (!state.color_write) return;
        const auto varyings = interpolate<S, float>(planes, px, py);
        const float oow = value_at(planes.oow, px, py);
        notify<InterpolateEvent>(observer, [&] {
            return InterpolateEvent{at.triangle, at.piece, at.x, at.y, oow, varyings};
        });

        const FragmentInput<float> input{{px + 0.5f, py + 0.5f}, z, oow, at.front_facing, std::int32_t(at.triangle)};
        const auto outputs = shade_fragment<S, float>(shader, varyings, input);
        notify<FragmentEvent>(observer, [&] { return FragmentEvent{at.triangle, at.piece, at.x, at.y, outputs}; });

        const glm::vec4 source(outputs[0], outputs[1], outputs[2], outputs[3]);
        const glm::vec4 before = target.color(x, y);
        if (target.color_format() == ColorFormat::rgba8) {
            std::uint32_t& color = target.color8()[place];
            color = blend_rgba8(state.blend, std::uint32_t(pack_rgba8(source)), color);
        } else {
            glm::vec4& color = target.color_float()[place];
            color = blend_float(state.blend, source, color);
        }
        for (int e = 0; e < std::min(output_count<S> - 4, target.extra_channels()); ++e)
            target.extra(e)[place] = outputs[std::size_t(4 + e)];
        notify<BlendEvent>(observer, [&] {
            return BlendEvent{at.triangle, at.piece, at.x, at.y, source, before, target.color(at.x, at.y)};
        });
    }
}

}  // namespace raster
