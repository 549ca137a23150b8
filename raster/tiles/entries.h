// entries.h: driver of stage 6 for the entries of a tile's bins: set them up, small ones a pack at a time, and draw them.
#pragma once

#include <bit>

#include <raster/tiles/raster.h>

namespace raster::tiles {

/// Gathers the entries of all bins of one tile, in order.
inline void collect_entries(std::span<const ChunkBins> chunks, std::size_t tile_index, std::vector<TileEntry>& out) {
    out.clear();
    for (std::uint32_t c = 0; c < chunks.size(); ++c)
        for (std::uint32_t i = chunks[c].offsets[tile_index]; i < chunks[c].offsets[tile_index + 1]; ++i)
            out.push_back({c, chunks[c].entries[i]});
}

/// Feeds the triangles of all bins of one tile to a sink, in order.
template <class Depth, class Sink>
inline void raster_tile(const DrawContext& draw, std::span<const ChunkBins> chunks, std::size_t tile_index,
                        TileBuffer& tile, const Depth& depth, Sink& sink) {
    TileRaster<Depth, Sink> raster(tile, depth, sink);
    PackSetup pack;
    collect_entries(chunks, tile_index, tile.entries);
    const std::span<const TileEntry> entries = tile.entries;
    for (std::size_t start = 0; start < entries.size(); start += std::size_t(native_lanes)) {
        const std::span<const TileEntry> some =
            entries.subspan(start, std::min(entries.size() - start, std::size_t(native_lanes)));
        draw.prefetch_entries(entries.subspan(start));
        // Lanes without a small triangle take the first vertex.
        const IntN first_vertex{std::int32_t(draw.first_vertex)};
        std::array<IntN, 3> places{first_vertex, first_vertex, first_vertex};
        std::uint32_t large = 0;
        for (std::size_t lane = 0; lane < some.size(); ++lane) {
            if (some[lane].entry & large_bit) {
                large |= 1u << lane;
            } else {
                const auto v = draw.corners(some[lane].entry);
                for (std::size_t k = 0; k < 3; ++k) places[k].v[int(lane)] = std::int32_t(v[k]);
            }
        }
        const std::uint32_t all = (1u << some.size()) - 1;
        std::uint32_t rest = all;
        if (large != all) {
            for (IntN& p : places) p = p - first_vertex;
            set_up_pack(pack, &draw.window[0].x, places, draw.state, depth.format, tile.x, tile.y, draw.width,
                        draw.height);
            rest &= large | raster.may_pass(pack);
        }
        for (; rest; rest &= rest - 1) {
            const int lane = std::countr_zero(rest);
            const auto [chunk, entry] = some[std::size_t(lane)];
            if (large >> lane & 1) {
                const LargeTriangle& in_target = chunks[chunk].large[entry & ~large_bit];
                TileTriangle t = box_of_large(in_target, depth.format, tile.x, tile.y);
                if (raster.hides(t)) continue;
                place_edges(in_target, tile.x, tile.y, t);
                t.entry = entry;
                raster.draw_large(t, chunk);
            } else if (pack.dots >> lane & 1) {
                raster.draw_dots(pack, lane, entry, chunk);
            } else if (pack.small >> lane & 1) {
                raster.draw_small(pack, lane, entry, chunk);
            } else {
                raster.draw_large(pack.at(lane, entry), chunk);
            }
        }
    }
}

}  // namespace raster::tiles
