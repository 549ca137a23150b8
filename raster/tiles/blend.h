// blend.h: draws that blend: shade and mix each triangle's pixels when it passes, in submission order.
#pragma once

#include <raster/tiles/raster.h>
#include <raster/tiles/resolve.h>
#include <raster/tiles/shade.h>

namespace raster::tiles {

/// The Sink that collects a triangle's pixels by block and shades them when the triangle is done, straight into the target.
/// The target's pending clear was written before.
template <HasFragment S>
class BlendSink : public SlotMaker {
public:
    static constexpr bool remembers = false;

    BlendSink(const ShadingContext<S>& context, TileBuffer& tile, Target& target)
        : SlotMaker(tile), context_(context), target_(target) {}

    void cell(int i, MaskN passed) {
        const std::uint32_t bits = bitmask(passed);
        for (int row = 0; row < cell_height; ++row) add(i + row * tile_size, bits >> (row * cell_width) & 0xf);
    }
    void row(int i, MaskN passed) { add(i, bitmask(passed)); }
    void pixel(int i) { add(i, 1); }
    /// All pixels of the block at (x, y) of the tile.
    void block(int x, int y) {
        const int b = y / block_size * blocks_per_row + x / block_size;
        touched_ |= std::uint64_t(1) << b;
        pixels_[b] = ~std::uint64_t(0);
    }
    void end() {
        if (touched_ == 0) return;
        const ShadingPlanes<S> planes = make_shading_planes(context_, current());
        for (; touched_; touched_ &= touched_ - 1) {
            const int b = std::countr_zero(touched_), x = tile_.x + block_x(b), y = tile_.y + block_y(b);
            const std::uint64_t mask = pixels_[b] & pixels_in_target(target_, x, y);
            shade_block(context_.shader, planes, target_, context_.draw.state.blend, x, y, mask);
            pixels_[b] = 0;
        }
    }

private:
    /// Neighbours in a row, the first at tile pixel i. They lie in one block.
    void add(int i, std::uint32_t bits) {
        const int x = i % tile_size, y = i / tile_size, b = y / block_size * blocks_per_row + x / block_size;
        touched_ |= std::uint64_t(bits != 0) << b;
        pixels_[b] |= std::uint64_t(bits) << (y % block_size * block_size + x % block_size);
    }

    const ShadingContext<S>& context_;
    Target& target_;
    std::uint64_t touched_ = 0;  ///< one bit a block
    std::uint64_t pixels_[block_count] = {};
};

}  // namespace raster::tiles
