// fill.cpp: rows of a block, a pack at a time, by a blend that is known when the loop is compiled.
#include <raster/tiles/fill.h>

#include <algorithm>
#include <bit>

namespace raster::tiles {

namespace {

template <Blend blend>
void fill(Target& target, std::uint32_t color, int x, int y, std::uint64_t mask) {
    std::uint32_t* const to = target.raw_color8() + target.index(x, y);
    const std::size_t stride = std::size_t(target.width());
    if (x + block_size > target.width()) {
        for (std::uint64_t rest = mask; rest; rest &= rest - 1) {
            const std::size_t i = std::size_t(std::countr_zero(rest));
            std::uint32_t& pixel = to[i / block_size * stride + i % block_size];
            pixel = blend_rgba8(blend, color, pixel);
        }
        return;
    }
    const IntN source{std::int32_t(color)};
    const bool whole = mask == ~std::uint64_t(0);
    for (std::size_t row = 0; row < block_size; ++row)
        for (std::size_t c = 0; c < block_size; c += native_lanes) {
            const std::uint32_t bits = std::uint32_t(mask >> (row * block_size + c)) & ((1u << native_lanes) - 1);
            if (bits == 0) continue;
            std::uint32_t* const p = to + row * stride + c;
            const IntN before = load_int<FloatN>(p), after = blend_rgba8(blend, source, before);
            store_int(p, whole ? after : select(mask_of_bits<FloatN>(bits), after, before));
        }
}

}  // namespace

void fill_block(Target& target, Blend blend, std::uint32_t color, int x, int y, std::uint64_t mask) {
    switch (blend) {
        case Blend::off: return fill<Blend::off>(target, color, x, y, mask);
        case Blend::source_over: return fill<Blend::source_over>(target, color, x, y, mask);
        case Blend::additive: return fill<Blend::additive>(target, color, x, y, mask);
    }
}

void fill_run(Target& target, std::uint32_t color, int x, int y, int width) {
    for (int row = y; row < y + block_size; ++row)
        std::fill_n(target.raw_color8() + target.index(x, row), std::size_t(width), color);
}

}  // namespace raster::tiles
