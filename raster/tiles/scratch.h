// scratch.h: memory that draws into one target reuse, so that a frame allocates nothing once it is warm.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <span>
#include <vector>

#include <raster/stages/setup.h>

namespace raster::tiles {

/// Uninitialised memory that grows and is never cleared. Behind its end stand 16 bytes that may be read: packs load four
/// numbers at once.
class ScratchBuffer {
public:
    template <class T>
    std::span<T> get(std::size_t count) {
        if (count * sizeof(T) + 16 > size_) {
            size_ = count * sizeof(T) + 16;
            bytes_.reset();
            bytes_ = std::unique_ptr<std::byte[]>(new std::byte[size_]);
        }
        return {reinterpret_cast<T*>(bytes_.get()), count};
    }

    std::size_t bytes() const { return size_; }

private:
    std::unique_ptr<std::byte[]> bytes_;
    std::size_t size_ = 0;
};

/// A triangle's number, and a tile that its bounding box meets.
struct BinPair {
    std::uint32_t tile, triangle;
};

/// A triangle that is set up when it is binned: one larger than a tile, or a piece of a clipped one.
struct LargeTriangle {
    std::array<WindowVertex<float>, 3> window;
    TriangleSetup setup;
    std::uint32_t triangle;   ///< its number in the draw
    std::int32_t piece;       ///< its place among the chunk's clipped pieces, -1 for a whole triangle
    bool front_facing;
};

/// The triangles of one chunk, sorted by tile: tile t's are entries[offsets[t]] to entries[offsets[t + 1]], in
/// submission order.
struct ChunkBins {
    std::vector<BinPair> pairs;
    std::vector<std::uint32_t> offsets;
    std::vector<std::uint32_t> entries;
    std::vector<LargeTriangle> large;

    std::size_t bytes() const {
        return pairs.capacity() * sizeof(BinPair) + (offsets.capacity() + entries.capacity()) * sizeof(std::uint32_t) +
               large.capacity() * sizeof(LargeTriangle);
    }
};

struct Workspace;

/// The workspaces (workspace.h) of the threads that draw tiles: as many as were ever in use at once.
class WorkspacePool {
public:
    WorkspacePool();
    ~WorkspacePool();

    std::unique_ptr<Workspace> take();
    void give_back(std::unique_ptr<Workspace> workspace);
    std::size_t bytes() const;

private:
    mutable std::mutex mutex_;
    std::vector<std::unique_ptr<Workspace>> free_;
    std::size_t made_ = 0;
};

/// What a draw needs between its phases.
struct Scratch {
    ScratchBuffer window, outcodes, varyings;
    std::vector<ChunkBins> chunks;
    std::vector<char> touched, cleared_rows;
    WorkspacePool workspaces;

    /// How much memory it holds.
    std::size_t bytes() const {
        std::size_t sum =
            window.bytes() + outcodes.bytes() + varyings.bytes() + touched.capacity() + workspaces.bytes();
        for (const ChunkBins& c : chunks) sum += c.bytes();
        return sum;
    }
};

}  // namespace raster::tiles
