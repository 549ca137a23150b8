// bin.h: driver of stages 2 to 5: assemble, clip, cull, and note for each tile which triangles may touch it.
//
// Triangles are taken in chunks, each by one thread, and stay in submission order inside a chunk; tiles walk the chunks
// in order. A bin holds numbers only: setting a small triangle up again in each tile costs less than storing its setup.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include <raster/stages/assemble.h>
#include <raster/stages/clip.h>
#include <raster/stages/project.h>
#include <raster/stages/setup.h>
#include <raster/state.h>
#include <raster/tiles/scratch.h>
#include <raster/tiles/tiling.h>

namespace raster::tiles {


/// Set in a bin's entry when the rest is the number of a LargeTriangle of its chunk, else the entry is a triangle's number.
inline constexpr std::uint32_t large_bit = 1u << 31;

/// An entry of a tile's bins, and the chunk that it is of.
struct TileEntry {
    std::uint32_t chunk, entry;
};

/// One draw call as binning and rastering see it: positions, indices and state, and no shader. Vertices are those
/// numbered first_vertex to first_vertex + window.size() - 1.
struct DrawContext {
    std::span<const std::uint32_t> indices;
    const State& state;
    ViewportTransform viewport;
    int width, height;  ///< of the target
    int tiles_x, tiles_y;
    std::uint32_t first_vertex;
    std::span<const WindowVertex<float>> window;
    std::span<const std::uint8_t> outcodes;
    PixelBox limits;  ///< the pixels that may change
    DepthFormat depth_format;

    /// The three vertices of a triangle, by number; beyond the vertex array for a bad index.
    std::array<std::uint32_t, 3> corners(std::size_t triangle) const {
        if (state.topology == Topology::triangles && !indices.empty()) {
            const std::uint32_t* p = indices.data() + 3 * triangle;
            return {p[0], p[1], p[2]};
        }
        const auto places = assemble(state.topology, triangle);
        if (indices.empty()) return {std::uint32_t(places[0]), std::uint32_t(places[1]), std::uint32_t(places[2])};
        return {indices[places[0]], indices[places[1]], indices[places[2]]};
    }
    /// The corners of triangles start, start + 1, ... in lanes; lanes from `count` on repeat the last.
    void load_corners(std::size_t start, int count, std::array<IntN, 3>& out) const {
        if (state.topology == Topology::triangles && !indices.empty()) {
            const std::uint32_t* p = indices.data() + 3 * start;
            if (count == native_lanes) return load3(reinterpret_cast<const std::int32_t*>(p), out[0], out[1], out[2]);
            for (int lane = 0; lane < native_lanes; ++lane) {
                const int i = 3 * std::min(lane, count - 1);
                for (int c = 0; c < 3; ++c) out[std::size_t(c)].v[lane] = std::int32_t(p[i + c]);
            }
            return;
        }
        for (int lane = 0; lane < native_lanes; ++lane) {
            const auto v = corners(start + std::size_t(std::min(lane, count - 1)));
            for (std::size_t c = 0; c < 3; ++c) out[c].v[lane] = std::int32_t(v[c]);
        }
    }
    /// Whether the vertex was shaded; numbers below the first wrap to large ones.
    bool exists(std::uint32_t vertex) const { return vertex - first_vertex < window.size(); }

    /// Where a vertex's position is, or would be.
    const void* window_of(std::uint32_t vertex) const {
        const std::uintptr_t zero = std::uintptr_t(window.data()) - std::uintptr_t(first_vertex) * sizeof window[0];
        return reinterpret_cast<const void*>(zero + std::uintptr_t(vertex) * sizeof window[0]);
    }
    /// Asks for the corners of the pack of triangles a few packs after the one at `start`.
    void prefetch_corners(std::size_t start) const {
        const std::size_t first = 3 * (start + 4 * std::size_t(native_lanes)), count = 3 * std::size_t(native_lanes);
        if (state.topology != Topology::triangles || first + count > indices.size()) return;
        const std::uint32_t* const next = indices.data() + first;
#pragma GCC unroll 24
        for (std::size_t i = 0; i < count; ++i) prefetch(window_of(next[i]));
    }

    /// Asks for what the entries of later packs need: corners of the next but one, indices of some after it.
    void prefetch_entries(std::span<const TileEntry> entries) const {
        constexpr std::size_t pack = std::size_t(native_lanes), near = 2 * pack, far = 6 * pack;
        if (indices.empty() || state.topology != Topology::triangles || entries.size() < far + pack) return;
        for (std::size_t i = 0; i < pack; ++i) {
            if (const std::uint32_t e = entries[far + i].entry; !(e & large_bit))
                prefetch(indices.data() + 3 * std::size_t(e));
            if (const std::uint32_t e = entries[near + i].entry; !(e & large_bit))
                for (const std::uint32_t v : indices.subspan(3 * std::size_t(e), 3)) prefetch(window_of(v));
        }
    }

    /// Positions of the three corners of a bin's entry.
    std::array<WindowVertex<float>, 3> corner_windows(const ChunkBins& bins, std::uint32_t entry) const {
        if (entry & large_bit) return bins.large[entry & ~large_bit].window;
        const auto v = corners(entry);
        return {window[v[0] - first_vertex], window[v[1] - first_vertex], window[v[2] - first_vertex]};
    }
};

/// A triangle that some pixel of the tile shows or has shown.
struct Slot {
    DepthPlane<float> depth;
    std::uint32_t chunk, entry;  ///< which bin entry it is
    bool front_facing;
};

/// The clip stage as binning sees it. It needs the shader again, since clip positions were not kept.
class Clipper {
public:
    struct Fan {
        int count = 0;
        std::array<std::array<WindowVertex<float>, 3>, 1 + max_clip_planes> pieces;
    };
    /// The triangles that remain of one, of whose corners `outside` is the union of outcodes.
    virtual Fan clip(std::size_t triangle, std::int32_t outside) = 0;
    /// Notes the varyings of a piece of the last fan: it becomes the next of its chunk's pieces.
    virtual void keep(int piece) = 0;

protected:
    ~Clipper() = default;
};

/// Bins triangles begin to end - 1 of a draw.
DrawCounts bin_chunk(const DrawContext& draw, Clipper& clipper, std::size_t begin, std::size_t end, ChunkBins& bins);

}  // namespace raster::tiles
