// raster.cpp: what becomes of a tile's pixels that pass: opaque draws remember the triangle, others shade and blend at once.
#include <raster/tiles/raster.h>

#include <algorithm>

#include <raster/tiles/blend.h>
#include <raster/tiles/entries.h>
#include <raster/tiles/scissor.h>

namespace raster::tiles {

namespace {

/// The Sink that remembers. Without need of colours only uniform blocks keep their slots.
template <bool colors>
class RememberSink : public SlotMaker {
public:
    static constexpr bool remembers = true;

    using SlotMaker::SlotMaker;

    /// What is written where a pixel passes.
    IntN owner() { return IntN(colors ? slot() : 0); }
    void pack(int i, MaskN passed, IntN owner) {
        if constexpr (colors) store_int(tile_.slot + i, select(passed, owner, load_int<FloatN>(tile_.slot + i)));
    }
    void pixel(int i) {
        if constexpr (colors) tile_.slot[i] = slot();
    }
    void end() {}
};

/// The Sink that collects a triangle's pixels by block and has them shaded when the triangle is done.
class BlendSink : public SlotMaker {
public:
    static constexpr bool remembers = false;

    BlendSink(TileBuffer& tile, const PixelBox& limits, TriangleShader& shader)
        : SlotMaker(tile),
          limits_(limits),
          tile_in_limits_(limits.contains(tile.x, tile.y) &&
                          limits.contains(tile.x + tile_size - 1, tile.y + tile_size - 1)),
          shader_(shader) {}

    IntN owner() const { return IntN(0); }
    void pack(int i, MaskN passed, IntN) { add(i, bitmask(passed)); }
    void pixel(int i) { add(i, 1); }
    /// All pixels of the block at (x, y) of the tile.
    void block(int x, int y) {
        const int b = block_of(x, y);
        touched_ |= std::uint64_t(1) << b;
        pixels_[b] = ~std::uint64_t(0);
    }
    void end() {
        if (touched_ == 0) return;
        shader_.begin(triangle_);
        while (touched_) {
            const int b = std::countr_zero(touched_), x = tile_.x + block_x(b), y = tile_.y + block_y(b);
            const int blocks = whole_from(b);
            if (blocks > 0) {
                shader_.shade_run(x, y, blocks);
            } else {
                shader_.shade(x, y, pixels_[b] & pixels_in(limits_, x, y));
            }
            for (int i = b; i < b + std::max(blocks, 1); ++i) pixels_[i] = 0, touched_ &= ~(std::uint64_t(1) << i);
        }
    }

private:
    /// How many blocks from this one to the end of its row are to be shaded wholly.
    int whole_from(int block) const {
        if (!tile_in_limits_) return 0;
        const int most = blocks_per_row - block % blocks_per_row;
        int count = 0;
        while (count < most && pixels_[block + count] == ~std::uint64_t(0)) ++count;
        return count;
    }

    /// At most 8 neighbours in a row, the first at tile pixel i.
    void add(int i, std::uint32_t bits) {
        const int x = i % tile_size, y = i / tile_size, b = block_of(x, y);
        const std::uint32_t here = bits << x % block_size & 0xff, beyond = bits >> (block_size - x % block_size);
        touched_ |= std::uint64_t(here != 0) << b;
        pixels_[b] |= std::uint64_t(here) << y % block_size * block_size;
        if (beyond) {
            touched_ |= std::uint64_t(1) << (b + 1);
            pixels_[b + 1] |= std::uint64_t(beyond) << y % block_size * block_size;
        }
    }

    const PixelBox& limits_;
    const bool tile_in_limits_;
    TriangleShader& shader_;
    std::uint64_t touched_ = 0;  ///< one bit a block
    std::uint64_t pixels_[block_count] = {};
};

template <class Depth, bool colors>
RASTER_FLATTEN void raster_remembering(const DrawContext& draw, std::span<const ChunkBins> chunks,
                                       std::size_t tile_index, TileBuffer& tile, const Depth& depth) {
    RememberSink<colors> sink(tile);
    raster_tile(draw, chunks, tile_index, tile, depth, sink);
}

}  // namespace

void raster_opaque(const DrawContext& draw, std::span<const ChunkBins> chunks, std::size_t tile_index, TileBuffer& tile,
                   DepthFormat format, bool colors) {
    const State& state = draw.state;
    if (state.depth_compare == UsualDepth::compare && state.depth_write && format == UsualDepth::format) {
        if (colors) {
            raster_remembering<UsualDepth, true>(draw, chunks, tile_index, tile, {});
        } else {
            raster_remembering<UsualDepth, false>(draw, chunks, tile_index, tile, {});
        }
    } else {
        const AnyDepth depth{state.depth_compare, state.depth_write, format};
        if (colors) {
            raster_remembering<AnyDepth, true>(draw, chunks, tile_index, tile, depth);
        } else {
            raster_remembering<AnyDepth, false>(draw, chunks, tile_index, tile, depth);
        }
    }
}

RASTER_FLATTEN void raster_blended(const DrawContext& draw, std::span<const ChunkBins> chunks, std::size_t tile_index,
                                   TileBuffer& tile, Target& target, TriangleShader& shader) {
    const AnyDepth depth{draw.state.depth_compare, draw.state.depth_write, target.depth_format()};
    BlendSink sink(tile, draw.limits, shader);
    raster_tile(draw, chunks, tile_index, tile, depth, sink);
}

}  // namespace raster::tiles
