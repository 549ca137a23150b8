// blend.h: stage 11, from a fragment's colour to the stored one: round to 8 bits, mix with what is there.
#pragma once

#include <cstdint>

#include <raster/lanes.h>
#include <raster/state.h>

namespace raster {

/// A channel as 0..255: clamped, scaled, rounded half to even. NaN becomes 0.
template <class F>
inline Int<F> to_unorm8(F c) {
    return round_to_int(min(max(c, F(0)), F(1)) * F(255.0f));
}

/// Four channels as r | g << 8 | b << 16 | a << 24.
template <class F>
inline Int<F> pack_rgba8(const vec<4, F>& c) {
    return to_unorm8(c.x) | (to_unorm8(c.y) << 8) | (to_unorm8(c.z) << 16) | (to_unorm8(c.w) << 24);
}

inline glm::vec4 unpack_rgba8(std::uint32_t c) {
    return glm::vec4(float(c & 255), float(c >> 8 & 255), float(c >> 16 & 255), float(c >> 24)) / 255.0f;
}

/// x * y / 255 rounded, for x and y in 0..255, without a division: (q + q / 256 + 128) / 256 with q = x * y.
template <class I>
inline I multiply_unorm8(I x, I y) {
    const I q = x * y;
    return (q + (q >> 8) + I(128)) >> 8;
}

/// Packed source over, beside or added to packed destination, in 8 bits as OpenGL drivers do.
template <class I>
inline I blend_rgba8(Blend blend, I source, I destination) {
    if (blend == Blend::off) return source;
    const I source_alpha = (source >> 24) & I(255);
    I result(0);
    for (int shift = 0; shift < 32; shift += 8) {
        const I s = (source >> shift) & I(255);
        const I d = (destination >> shift) & I(255);
        I mixed = s + d;
        if (blend == Blend::source_over)
            mixed = multiply_unorm8(s, source_alpha) + multiply_unorm8(d, I(255) - source_alpha);
        result = result | (select(mixed > I(255), I(255), mixed) << shift);
    }
    return result;
}

/// The same for float targets, unrounded and unclamped.
template <class F>
inline vec<4, F> blend_float(Blend blend, const vec<4, F>& source, const vec<4, F>& destination) {
    switch (blend) {
        case Blend::source_over: return source * source.w + destination * (F(1) - source.w);
        case Blend::additive: return source + destination;
        case Blend::off: break;
    }
    return source;
}

}  // namespace raster
