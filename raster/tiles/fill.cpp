// fill.cpp: rows of blocks, a pack at a time, by a blend that is known when the loop is compiled.
#include <raster/tiles/fill.h>

#include <bit>
#include <type_traits>

namespace raster::tiles {

namespace {

/// Calls function with the blend as a constant.
template <class Function>
void with_constant(Blend blend, const Function& function) {
    switch (blend) {
        case Blend::off: return function(std::integral_constant<Blend, Blend::off>());
        case Blend::source_over: return function(std::integral_constant<Blend, Blend::source_over>());
        case Blend::additive: return function(std::integral_constant<Blend, Blend::additive>());
    }
}

/// Blocks at the right edge of the target, where packs may reach beyond it.
void fill_pixels(Target& target, Blend blend, std::uint32_t color, int x, int y, std::uint64_t mask) {
    for (; mask; mask &= mask - 1) {
        const int i = std::countr_zero(mask);
        std::uint32_t& pixel = target.raw_color8()[target.index(x + i % block_size, y + i / block_size)];
        pixel = blend_rgba8(blend, color, pixel);
    }
}

}  // namespace

void fill_block(Target& target, Blend blend, std::uint32_t color, int x, int y, std::uint64_t mask) {
    if (x + block_size > target.width()) return fill_pixels(target, blend, color, x, y, mask);
    with_constant(blend, [&](auto constant) {
        const IntN source{std::int32_t(color)};
        for (int row = 0; row < block_size; ++row)
            for (int c = 0; c < block_size; c += native_lanes) {
                const std::uint32_t bits = std::uint32_t(mask >> (row * block_size + c)) & ((1u << native_lanes) - 1);
                if (bits == 0) continue;
                std::uint32_t* const p = target.raw_color8() + target.index(x + c, y + row);
                const IntN before = load_int<FloatN>(p);
                store_int(p, select(mask_of_bits<FloatN>(bits), blend_rgba8(constant(), source, before), before));
            }
    });
}

void fill_run(Target& target, Blend blend, std::uint32_t color, int x, int y, int blocks) {
    with_constant(blend, [&](auto constant) {
        const IntN source{std::int32_t(color)};
        for (int row = y; row < y + block_size; ++row) {
            std::uint32_t* p = target.raw_color8() + target.index(x, row);
            for (const std::uint32_t* const end = p + blocks * block_size; p < end; p += native_lanes)
                store_int(p, blend_rgba8(constant(), source, load_int<FloatN>(p)));
        }
    });
}

}  // namespace raster::tiles
