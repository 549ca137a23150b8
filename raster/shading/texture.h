// texture.h: the colour of an image at (u, v): nearest and bilinear filters, three ways to wrap, sRGB decoding.
#pragma once

#include <cstdint>
#include <vector>

#include <raster/image/image.h>
#include <raster/lanes.h>

namespace raster {

/// What lies beyond 0..1 (OpenGL 4.6, 8.14.2).
enum class Wrap {
    repeat,  ///< the image again and again
    clamp,   ///< its outermost texels (GL_CLAMP_TO_EDGE)
    mirror,  ///< the image, every other time reversed
};

/// How a sample is made of texels (OpenGL 4.6, 8.14.3). There are no mipmaps.
enum class Filter {
    nearest,   ///< the texel that the point lies in
    bilinear,  ///< the four around it, by distance
};

/// An image made ready for sampling: one integer a texel, r | g << 8 | b << 16 | a << 24, row 0 on top.
struct PackedTexture {
    int width = 0;
    int height = 0;
    std::vector<std::int32_t> texels;
};

/// The largest width or height of a texture: texel numbers and coordinates stay exact in 32 bits.
inline constexpr int max_texture_size = 32768;

/// Grey and grey with alpha spread over the colour channels; alpha is 255 where the image has none. An empty image, or
/// one larger than max_texture_size, gives an empty texture.
PackedTexture pack_texture(const Image8& image);

/// The 256 values of an sRGB channel in linear light, 0 to 1 (IEC 61966-2-1).
const float* srgb_decode_table();

/// A texture and how to read it. Texels are not owned. v points up: v = 0 is the bottom edge of the bottom row.
struct TextureView {
    const std::int32_t* texels = nullptr;  ///< null: no texture
    std::int32_t width = 0;
    std::int32_t height = 0;
    Wrap wrap = Wrap::repeat;
    Filter filter = Filter::nearest;
    const float* decode = nullptr;  ///< what colour bytes stand for, 256 values; null: byte / 255. Not for alpha

    TextureView() = default;
    explicit TextureView(const PackedTexture& texture, Wrap wrap = Wrap::repeat, Filter filter = Filter::nearest,
                         const float* decode = nullptr)
        : texels(texture.texels.empty() ? nullptr : texture.texels.data()),
          width(texture.width),
          height(texture.height),
          wrap(wrap),
          filter(filter),
          decode(decode) {}

    explicit operator bool() const { return texels != nullptr; }
};

namespace detail {

/// x where |x| < limit, else 0; so also for NaN.
template <class F>
inline F zero_beyond(F x, float limit) {
    return select(abs(x) < F(limit), x, F(0));
}

/// x - floor(x), below 1 also where rounding would give 1. Floats of 2^23 and more have no fraction.
template <class F>
inline F fraction(F x) {
    const F small = zero_beyond(x, 8388608.0f);
    return min(small - floor(small), F(0.99999994f));
}

/// Distance from x to the nearest even number: 0 to 1 and back.
template <class F>
inline F mirrored(F x) {
    const F half = zero_beyond(x, 8388608.0f) * F(0.5f);
    const F rest = half - to_float(round_to_int(half));
    return abs(rest + rest);
}

inline bool is_power_of_two(std::int32_t n) { return (n & (n - 1)) == 0; }

/// The texel that a coordinate lies in, 0 to size - 1 for any coordinate. The arithmetic is what Mesa's llvmpipe does,
/// two ways of repeating included: with them the texel is the same at every coordinate, however large.
template <class F>
inline Int<F> nearest_texel(Wrap wrap, F coordinate, std::int32_t size) {
    const F scale = F(float(size));
    const Int<F> last(size - 1);
    switch (wrap) {
        case Wrap::repeat:
            if (is_power_of_two(size)) return floor_to_int(zero_beyond(coordinate * scale, 2147483648.0f)) & last;
            return truncate_to_int(fraction(coordinate) * scale);
        case Wrap::mirror: {
            const Int<F> texel = truncate_to_int(mirrored(coordinate) * scale);
            return select(texel > last, last, texel);
        }
        case Wrap::clamp: break;
    }
    return truncate_to_int(clamp(coordinate * scale, F(0), F(float(size - 1))));
}

/// Two neighbours along one axis, and how much of the second to take, 0 to 1.
template <class F>
struct TexelPair {
    Int<F> first, second;
    F weight;
};

/// The texels whose centres lie around a coordinate, 0 to size - 1 for any coordinate.
template <class F>
inline TexelPair<F> neighbour_texels(Wrap wrap, F coordinate, std::int32_t size) {
    const F scale = F(float(size));
    const Int<F> zero(0), last(size - 1);
    const bool wraps_by_bits = wrap == Wrap::repeat && is_power_of_two(size);
    F x(0);
    switch (wrap) {
        case Wrap::repeat:
            x = wraps_by_bits ? zero_beyond(coordinate * scale, 1073741824.0f) : fraction(coordinate) * scale;
            break;
        case Wrap::mirror: x = mirrored(coordinate) * scale; break;
        case Wrap::clamp: x = clamp(coordinate * scale, F(0), scale); break;
    }
    x = x - F(0.5f);
    const Int<F> below = floor_to_int(x);
    const Int<F> above = below + Int<F>(1);
    const F weight = x - to_float(below);
    if (wraps_by_bits) return {below & last, above & last, weight};
    const bool around = wrap == Wrap::repeat;
    return {select(below < zero, around ? last : zero, below), select(above > last, around ? zero : last, above),
            weight};
}

/// A texel's channels, 0 to 1 when decoded and 0 to 255 when not; alpha 0 to 255.
template <class F>
inline vec<4, F> unpack_texel(const TextureView& texture, Int<F> texel) {
    Int<F> r = byte_of<0>(texel), g = byte_of<1>(texel), b = byte_of<2>(texel);
    const F alpha = to_float(byte_of<3>(texel));
    if (texture.decode)
        return {gather(texture.decode, r), gather(texture.decode, g), gather(texture.decode, b), alpha};
    return {to_float(r), to_float(g), to_float(b), alpha};
}

}  // namespace detail

/// The texture's value at (u, v), each channel 0 to 1. Any u and v are allowed, NaN and infinities too: every texel
/// number is in range before it becomes an address. `texture` is not empty.
template <class F>
inline vec<4, F> sample(const TextureView& texture, const vec<2, F>& uv) {
    using namespace detail;
    const Int<F> width(texture.width);
    const Int<F> top(texture.height - 1);  // v points up and rows go down
    vec<4, F> value;
    if (texture.filter == Filter::nearest) {
        Int<F> column = nearest_texel(texture.wrap, uv.x, texture.width),
               row = nearest_texel(texture.wrap, uv.y, texture.height);
        value = unpack_texel<F>(texture, gather(texture.texels, (top - row) * width + column));
    } else {
        TexelPair<F> u = neighbour_texels(texture.wrap, uv.x, texture.width);
        TexelPair<F> v = neighbour_texels(texture.wrap, uv.y, texture.height);
        Int<F> above = (top - v.second) * width, a, b, c, d;  // a and b below, c and d above
        const Int<F> one(1);
        if (all((u.second == u.first + one) & (v.second == v.first + one))) {
            gather_square(texture.texels, above + u.first, texture.width, c, d, a, b);
        } else {  // some lane goes around an edge, or repeats it
            Int<F> below = (top - v.first) * width;
            a = gather(texture.texels, below + u.first), b = gather(texture.texels, below + u.second);
            c = gather(texture.texels, above + u.first), d = gather(texture.texels, above + u.second);
        }
        const auto mix = [](const vec<4, F>& x, const vec<4, F>& y, F t) { return x + (y - x) * t; };
        const auto mix_texels = [&](Int<F> x, Int<F> y) {
            return mix(unpack_texel<F>(texture, x), unpack_texel<F>(texture, y), u.weight);
        };
        vec<4, F> lower = mix_texels(a, b);
        value = mix(lower, mix_texels(c, d), v.weight);
    }
    const F unit(1.0f / 255.0f);
    const F color_unit = texture.decode ? F(1) : unit;
    return {value.x * color_unit, value.y * color_unit, value.z * color_unit, value.w * unit};
}

}  // namespace raster
