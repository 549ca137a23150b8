// draw.h: the fast draw: the same stages as pipeline.h over lanes, tiles and threads, in three parallel phases.
//
//      vertices   shade and project every vertex                    tiles/vertices.h
//      bin        triangles to the tiles that they may touch        tiles/bin.h
//      tiles      each tile alone, its triangles in order           tiles/entries.h, raster.h, then resolve.h or blend.h
#pragma once

#include <algorithm>

#include <raster/tiles/bin.h>
#include <raster/tiles/blend.h>
#include <raster/tiles/parallel.h>
#include <raster/tiles/raster.h>
#include <raster/tiles/resolve.h>
#include <raster/tiles/scissor.h>

namespace raster::tiles {

/// The most triangles of a chunk, and the most chunks of a batch. A batch is binned and drawn before the next begins, which
/// bounds memory.
inline constexpr std::size_t chunk_triangles = 8192;
inline constexpr std::size_t batch_chunks = 512;

/// How many triangles of a draw make a chunk: some sixteenth, so that threads share small draws as well.
inline std::size_t triangles_a_chunk(std::size_t triangles) {
    constexpr std::size_t least = 32;
    return std::clamp((triangles / 16 + least - 1) / least * least, least, chunk_triangles);
}

/// The range of vertices to shade: from the smallest to the largest number that an index list names among those that exist.
/// All of them where the list is so long that looking would cost as much.
inline std::pair<std::uint32_t, std::uint32_t> used_vertices(std::span<const std::uint32_t> indices,
                                                             std::size_t vertices) {
    if (vertices > 0 && (indices.empty() || indices.size() >= 4 * vertices)) return {0, std::uint32_t(vertices - 1)};
    std::uint32_t low = ~0u, high = 0;
    for (const std::uint32_t i : indices) {
        const bool exists = i < vertices;
        low = std::min(low, exists ? i : ~0u);
        high = std::max(high, exists ? i : 0u);
    }
    return {low, high};
}

/// The clip stage of one draw: shades a triangle's corners again, clips it, projects the fan.
template <Shader S>
class ShaderClipper final : public Clipper {
public:
    ShaderClipper(const DrawContext& draw, const S& shader,
                  std::span<const typename S::template Vertex<float>> vertices,
                  std::vector<std::array<VaryingArray<S>, 3>>& kept)
        : draw_(draw), shader_(shader), vertices_(vertices), kept_(kept) {
        kept.clear();
    }

    Fan clip(std::size_t triangle, std::int32_t outside) override {
        ClipPolygon<std::size_t(varying_count<S>)> corners;
        for (const std::uint32_t v : draw_.corners(triangle))
            corners.add(shade_vertex<S, float>(shader_, vertices_[v]));
        const UserPlanes user = draw_.state.clip_planes;
        outside &= not_finite_bit - 1;
        for (int c = 0; c < 3; ++c) outside |= user_outcode(user, corners.corners[std::size_t(c)].clip);
        polygon_ = clip_triangle<S>(corners, outside, [](auto&&...) {}, user);
        keep_flat_varyings<S>(polygon_, corners.corners[2]);
        Fan fan;
        for (; fan.count + 2 < polygon_.count; ++fan.count)
            for (std::size_t c = 0; c < 3; ++c)
                fan.pieces[std::size_t(fan.count)][c] = project(corner(fan.count, c).clip, draw_.viewport);
        return fan;
    }
    void keep(int piece) override {
        kept_.push_back({corner(piece, 0).varyings, corner(piece, 1).varyings, corner(piece, 2).varyings});
    }

private:
    const auto& corner(int piece, std::size_t c) const {
        return polygon_.corners[std::size_t(clip_fan(piece)[c])];
    }

    const DrawContext& draw_;
    const S& shader_;
    std::span<const typename S::template Vertex<float>> vertices_;
    std::vector<std::array<VaryingArray<S>, 3>>& kept_;
    ClipPolygon<std::size_t(varying_count<S>)> polygon_;
};

/// Which tiles have entries in any chunk.
inline void find_touched_tiles(std::span<const ChunkBins> chunks, std::vector<char>& touched, std::size_t tiles) {
    touched.assign(tiles, 0);
    for (const ChunkBins& c : chunks)
        for (std::size_t t = 0; t < tiles; ++t) touched[t] = char(touched[t] | char(c.offsets[t] != c.offsets[t + 1]));
}

/// Writes the colour of a pending clear over rows of tiles that are in good part untouched, whole rows of pixels at a time:
/// memory takes those several times as fast as rows of a tile. The other tiles write theirs with what they draw.
inline void clear_sparse_rows(Target& target, const DrawContext& draw, std::span<const char> touched,
                              std::vector<char>& cleared) {
    cleared.assign(std::size_t(draw.tiles_y), 0);
    if (!target.clear_is_pending()) return;
    parallel_for(cleared.size(), [&](std::size_t row) {
        const auto tiles = touched.subspan(row * std::size_t(draw.tiles_x), std::size_t(draw.tiles_x));
        if (4 * std::count(tiles.begin(), tiles.end(), 0) < draw.tiles_x) return;
        target.write_clear_color(0, int(row) * tile_size, target.width(), tile_size);
        cleared[row] = 1;
    });
}

/// All of one tile: load, raster, then resolve or blend.
template <Shader S>
inline void draw_tile(const ShadingContext<S>& context, std::size_t tile_index, Target& target) {
    const DrawContext& draw = context.draw;
    const int tile_x = int(tile_index) % draw.tiles_x, tile_y = int(tile_index) / draw.tiles_x;
    const bool blends = HasFragment<S> && draw.state.blend != Blend::off && draw.state.color_write;
    const bool touched = context.touched[tile_index] != 0;
    const bool pending = target.clear_is_pending();
    bool clear_color = pending && !context.cleared_rows[std::size_t(tile_y)];
    if (clear_color && (!touched || blends)) {
        target.write_clear_color(tile_x * tile_size, tile_y * tile_size, tile_size, tile_size);
        clear_color = false;
    }
    char& depth_waits = target.depth_waits(tile_index);
    if (!touched) {
        if (pending) depth_waits = 1;
        return;
    }
    if (!pending && depth_waits) target.write_clear_depth(tile_x * tile_size, tile_y * tile_size, tile_size, tile_size);
    depth_waits = 0;

    WorkspaceLoan loan(target.scratch().workspaces);
    TileBuffer& tile = (*loan).tile;
    load_tile(tile, target, tile_x, tile_y);
    if constexpr (HasFragment<S>) {
        if (blends) {
            BlendingShader<S> shader(context, target);
            raster_blended(draw, context.chunks, tile_index, tile, target, shader);
            restore_outside(tile, target, draw.limits);
            store_depth(tile, target);
            return;
        }
    }
    const bool colors = HasFragment<S> && draw.state.color_write;
    raster_opaque(draw, context.chunks, tile_index, tile, target.depth_format(), colors);
    restore_outside(tile, target, draw.limits);
    if constexpr (HasFragment<S>) {
        resolve_depth(tile, target, clear_color, draw.state.depth_write,
                      colors && output_count<S> - 4 >= target.extra_channels());
        if (colors) resolve_color(context, *loan, target);
    } else {
        resolve_depth(tile, target, clear_color, draw.state.depth_write, false);
    }
}

/// raster::draw without an observer.
template <Shader S>
DrawCounts draw(Target& target, const S& shader, const Mesh<typename S::template Vertex<float>>& mesh,
                const State& state) {
    const Viewport viewport = effective_viewport(state.viewport, target.width(), target.height());
    if (!is_valid(viewport)) return {};
    const std::size_t index_count = mesh.indices.empty() ? mesh.vertices.size() : mesh.indices.size();
    const std::size_t triangles = triangle_count(state.topology, index_count);
    DrawCounts counts;
    if (triangles == 0) return counts;
    const auto [low, high] = used_vertices(mesh.indices, mesh.vertices.size());
    if (low > high) {
        counts.submitted = counts.bad_index = std::int64_t(triangles);
        return counts;
    }

    Scratch& scratch = target.scratch();
    const ViewportTransform transform(viewport);
    const VertexBuffer<S> shaded =
        shade_vertices(shader, mesh.vertices.subspan(low, high - low + 1), transform, state.clip_planes, scratch);
    const int tiles_x = tiles_along(target.width()), tiles_y = tiles_along(target.height());
    const DrawContext context{mesh.indices, state,   transform, target.width(), target.height(),
                              tiles_x,      tiles_y, low,       shaded.window,  shaded.outcodes,
                              drawable_pixels(state, target.width(), target.height()), target.depth_format()};

    constexpr std::size_t batch = chunk_triangles * batch_chunks;
    const std::size_t a_chunk = triangles_a_chunk(triangles);
    for (std::size_t first = 0; first < triangles; first += batch) {
        const std::size_t end = std::min(first + batch, triangles);
        const std::size_t chunk_count = (end - first + a_chunk - 1) / a_chunk;
        if (scratch.chunks.size() < chunk_count) scratch.chunks.resize(chunk_count);
        std::vector<std::vector<std::array<VaryingArray<S>, 3>>> piece_varyings(chunk_count);
        std::vector<DrawCounts> chunk_counts(chunk_count);
        parallel_for(chunk_count, [&](std::size_t c) {
            const std::size_t begin = first + c * a_chunk;
            ShaderClipper<S> clipper(context, shader, mesh.vertices, piece_varyings[c]);
            chunk_counts[c] =
                bin_chunk(context, clipper, begin, std::min(begin + a_chunk, end), scratch.chunks[c]);
        });
        for (const DrawCounts& c : chunk_counts) counts += c;

        const std::span<const ChunkBins> chunks(scratch.chunks.data(), chunk_count);
        find_touched_tiles(chunks, scratch.touched, std::size_t(tiles_x) * std::size_t(tiles_y));
        clear_sparse_rows(target, context, scratch.touched, scratch.cleared_rows);
        const ShadingContext<S> shading{context, chunks,          scratch.touched, scratch.cleared_rows,
                                        shader,  shaded.varyings, piece_varyings};
        parallel_for(std::size_t(tiles_x) * std::size_t(tiles_y),
                     [&](std::size_t tile) { draw_tile(shading, tile, target); });
        target.clear_was_written();
    }
    return counts;
}

}  // namespace raster::tiles
