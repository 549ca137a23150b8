// draw.h: the fast draw: the same stages as pipeline.h over lanes, tiles and threads, in three parallel phases.
//
//      vertices   shade and project every vertex                    tiles/vertices.h
//      bin        triangles to the tiles that they may touch        tiles/bin.h
//      tiles      each tile alone, its triangles in order           tiles/raster.h, then resolve.h or blend.h
#pragma once

#include <algorithm>

#include <raster/tiles/bin.h>
#include <raster/tiles/blend.h>
#include <raster/tiles/parallel.h>
#include <raster/tiles/raster.h>
#include <raster/tiles/resolve.h>

namespace raster::tiles {

/// Triangles a chunk, and chunks a batch. A batch is binned and drawn before the next begins, which bounds memory.
inline constexpr std::size_t chunk_triangles = 8192;
inline constexpr std::size_t batch_chunks = 512;

/// The smallest and the largest vertex number that an index list names among those that exist.
inline std::pair<std::uint32_t, std::uint32_t> used_vertices(std::span<const std::uint32_t> indices, std::size_t vertices) {
    if (indices.empty()) return {0, std::uint32_t(vertices - 1)};
    std::uint32_t low = ~0u, high = 0;
    for (const std::uint32_t i : indices) {
        const bool exists = i < vertices;
        low = std::min(low, exists ? i : ~0u);
        high = std::max(high, exists ? i : 0u);
    }
    return {low, high};
}

/// Feeds the triangles of all bins of one tile to a sink, in order.
template <Shader S, class Depth, class Sink>
RASTER_FLATTEN inline void raster_tile(const DrawContext<S>& draw, std::span<const ChunkBins> chunks,
                                       const std::vector<std::vector<ClippedPiece<S>>>& pieces, std::size_t tile_index,
                                       TileBuffer& tile, const Depth& depth, Sink& sink) {
    TileRaster<Depth, Sink> raster(tile, depth, sink);
    for (std::uint32_t c = 0; c < chunks.size(); ++c) {
        const std::uint32_t* entry = chunks[c].entries.data() + chunks[c].offsets[tile_index];
        const std::uint32_t* end = chunks[c].entries.data() + chunks[c].offsets[tile_index + 1];
        for (; entry < end; entry += native_lanes) {
            const int count = int(std::min<std::ptrdiff_t>(end - entry, native_lanes));
            std::array<IntN, 3> places{IntN(0), IntN(0), IntN(0)};
            std::uint32_t clipped = 0;
            for (int lane = 0; lane < count; ++lane) {
                if (entry[lane] & clipped_bit) {
                    clipped |= 1u << lane;
                } else {
                    const auto v = draw.corners(entry[lane]);
                    for (std::size_t k = 0; k < 3; ++k) places[k].v[lane] = std::int32_t(v[k] - draw.buffer.first);
                }
            }
            const PackSetup pack = set_up_pack(&draw.buffer.window[0].x, places, draw.state, depth.format, tile.x, tile.y,
                                               draw.width, draw.height);
            for (int lane = 0; lane < count; ++lane) {
                if ((pack.dots & ~(pack.wide | clipped)) >> lane & 1) {
                    raster.draw_dots(pack, lane, entry[lane], c);
                    continue;
                }
                TileTriangle t = (pack.wide | clipped) >> lane & 1
                                     ? set_up_one(corner_windows(draw, pieces[c], entry[lane]), draw.state, depth.format,
                                                  tile.x, tile.y, draw.width, draw.height)
                                     : pack.at(lane);
                t.entry = entry[lane];
                raster.draw(t, c);
            }
        }
    }
}

/// All of one tile: load, raster, resolve.
template <Shader S, class Depth>
inline void draw_tile(const DrawContext<S>& draw, std::span<const ChunkBins> chunks,
                      const std::vector<std::vector<ClippedPiece<S>>>& pieces, std::size_t tile_index, Target& target,
                      const Depth& depth) {
    const int tile_x = int(tile_index) % draw.tiles_x, tile_y = int(tile_index) / draw.tiles_x;
    const bool touched = std::ranges::any_of(
        chunks, [&](const ChunkBins& c) { return c.offsets[tile_index] != c.offsets[tile_index + 1]; });
    if (!touched) {
        if (target.clear_is_pending()) target.write_clear_tile(tile_x * tile_size, tile_y * tile_size, tile_size);
        return;
    }
    thread_local TileBuffer tile;
    if constexpr (HasFragment<S>) {
        if (draw.state.blend != Blend::off && draw.state.color_write) {
            if (target.clear_is_pending()) target.write_clear_tile(tile_x * tile_size, tile_y * tile_size, tile_size);
            load_tile(tile, target, tile_x, tile_y);
            BlendSink<S> sink(draw, pieces, tile, target);
            raster_tile(draw, chunks, pieces, tile_index, tile, depth, sink);
            store_depth(tile, target);
            return;
        }
    }
    load_tile(tile, target, tile_x, tile_y);
    if (HasFragment<S> && draw.state.color_write) {
        RememberSink<true> sink(tile);
        raster_tile(draw, chunks, pieces, tile_index, tile, depth, sink);
    } else {
        RememberSink<false> sink(tile);
        raster_tile(draw, chunks, pieces, tile_index, tile, depth, sink);
    }
    TileResolve<S>(draw, pieces, tile, target).run();
}

/// raster::draw without an observer.
template <Shader S>
DrawCounts draw(Target& target, const S& shader, const Mesh<typename S::template Vertex<float>>& mesh, const State& state) {
    const Viewport viewport = effective_viewport(state.viewport, target.width(), target.height());
    if (!is_valid(viewport)) return {};
    const std::size_t index_count = mesh.indices.empty() ? mesh.vertices.size() : mesh.indices.size();
    const std::size_t triangles = triangle_count(state.topology, index_count);
    DrawCounts counts;
    const auto [low, high] = used_vertices(mesh.indices, mesh.vertices.size());
    if (triangles == 0) return counts;
    if (low > high) {
        counts.submitted = counts.bad_index = std::int64_t(triangles);
        return counts;
    }

    DrawContext<S> context{shader,
                           mesh.vertices.subspan(low, high - low + 1),
                           mesh.indices,
                           state,
                           ViewportTransform(viewport),
                           target.width(),
                           target.height(),
                           (target.width() + tile_size - 1) / tile_size,
                           (target.height() + tile_size - 1) / tile_size,
                           {}};
    Scratch& scratch = target.scratch();
    context.buffer = shade_vertices(shader, context.vertices, low, context.viewport, scratch);

    const std::size_t tiles = std::size_t(context.tiles_x) * std::size_t(context.tiles_y);
    const bool usual = state.depth_compare == UsualDepth::compare && state.depth_write == UsualDepth::write &&
                       target.depth_format() == UsualDepth::format;
    constexpr std::size_t batch = chunk_triangles * batch_chunks;
    for (std::size_t first = 0; first < triangles; first += batch) {
        const std::size_t end = std::min(first + batch, triangles);
        const std::size_t chunk_count = (end - first + chunk_triangles - 1) / chunk_triangles;
        if (scratch.chunks.size() < chunk_count) scratch.chunks.resize(chunk_count);
        std::vector<std::vector<ClippedPiece<S>>> pieces(chunk_count);
        std::vector<DrawCounts> chunk_counts(chunk_count);
        parallel_for(chunk_count, [&](std::size_t c) {
            const std::size_t begin = first + c * chunk_triangles;
            chunk_counts[c] = ChunkBinner<S>(context, scratch.chunks[c], pieces[c]).run(begin, std::min(begin + chunk_triangles, end));
        });
        for (const DrawCounts& c : chunk_counts) counts += c;

        const std::span<const ChunkBins> chunks(scratch.chunks.data(), chunk_count);
        parallel_for(tiles, [&](std::size_t tile) {
            if (usual) {
                draw_tile(context, chunks, pieces, tile, target, UsualDepth{});
            } else {
                draw_tile(context, chunks, pieces, tile, target,
                          AnyDepth{state.depth_compare, state.depth_write, target.depth_format()});
            }
        });
        target.clear_was_written();
    }
    return counts;
}

}  // namespace raster::tiles
