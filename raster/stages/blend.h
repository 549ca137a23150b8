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

/// x * y / 255 rounded, for x and y in 0..255, without a division: (q + q / 256 + 128) / 256 with q = x * y. x holds two
/// channels, in bits 0..7 and 16..23; no step carries from one into the other, since q + q / 256 + 128 < 2^16.
template <class I>
inline I multiply_unorm8(I x, I y) {
    const I two_channels(0x00ff00ff);
    const I q = x * y;
    return ((q + ((q >> 8) & two_channels) + I(0x00800080)) >> 8) & two_channels;
}

/// Packed source over, beside or added to packed destination, in 8 bits as OpenGL drivers do. I is std::uint32_t or
/// IntPack: two channels at once need a type that wraps.
template <class I>
inline I blend_rgba8(Blend blend, I source, I destination) {
    if (blend == Blend::off) return source;
    const I two_channels(0x00ff00ff);
    const I alpha = (source >> 24) & I(255);
    const auto mix = [&](I s, I d) {
        if (blend == Blend::source_over) return multiply_unorm8(s, alpha) + multiply_unorm8(d, I(255) - alpha);
        const I sum = s + d;
        const I overflow = (sum >> 8) & I(0x00010001);
        return (sum | (overflow * I(255))) & two_channels;
    };
    const I red_blue = mix(source & two_channels, destination & two_channels);
    const I green_alpha = mix((source >> 8) & two_channels, (destination >> 8) & two_channels);
    return red_blue | (green_alpha << 8);
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
