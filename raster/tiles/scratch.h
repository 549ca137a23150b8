// scratch.h: memory that draws into one target reuse, so that a frame allocates nothing once it is warm.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include <raster/stages/project.h>

namespace raster::tiles {

/// Uninitialised memory that grows and is never cleared.
class ScratchBuffer {
public:
    template <class T>
    std::span<T> get(std::size_t count) {
        if (count * sizeof(T) > size_) {
            size_ = count * sizeof(T);
            bytes_.reset();
            bytes_ = std::unique_ptr<std::byte[]>(new std::byte[size_]);
        }
        return {reinterpret_cast<T*>(bytes_.get()), count};
    }

private:
    std::unique_ptr<std::byte[]> bytes_;
    std::size_t size_ = 0;
};

/// A triangle's number, and a tile that its bounding box meets.
struct BinPair {
    std::uint32_t tile, triangle;
};

/// One triangle of a clipped triangle's fan, ready for setup, and the number of the triangle it came from.
struct ClippedPiece {
    std::array<WindowVertex<float>, 3> window;
    std::uint32_t triangle;
};

/// The triangles of one chunk, sorted by tile: tile t's are entries[offsets[t]] to entries[offsets[t + 1]], in
/// submission order.
struct ChunkBins {
    std::vector<BinPair> pairs;
    std::vector<std::uint32_t> offsets;
    std::vector<std::uint32_t> entries;
    std::vector<ClippedPiece> pieces;
};

/// What a draw needs between its phases.
struct Scratch {
    ScratchBuffer window, outcodes, varyings;
    std::vector<ChunkBins> chunks;
};

}  // namespace raster::tiles
