// depth.h: stage 8, the z-buffer (Catmull 1974): encode a depth, compare it with the stored one.
#pragma once

#include <cmath>
#include <cstdint>

#include <raster/lanes.h>
#include <raster/state.h>

namespace raster {

enum class DepthFormat {
    unorm24,  ///< round(z * (2^24 - 1)), as OpenGL's 24-bit depth buffers
    float32,  ///< the bits of z, which for z >= 0 order as integers
};

/// Window z, clamped to 0..1, as the integer that is stored and compared. NaN becomes 1, the far end.
template <class F>
inline Int<F> encode_depth(DepthFormat format, F z) {
    const F clamped = max(min(z, F(1)), F(0));
    return format == DepthFormat::unorm24 ? round_to_int(clamped * F(16777215.0f)) : as_int(clamped);
}

/// The same for clearing, where drivers round once: 24 bits and a half do not fit a float.
inline std::uint32_t encode_clear_depth(DepthFormat format, float z) {
    const float clamped = max(min(z, 1.0f), 0.0f);
    return format == DepthFormat::unorm24 ? std::uint32_t(std::nearbyint(double(clamped) * 16777215.0))
                                          : std::uint32_t(as_int(clamped));
}

inline float decode_depth(DepthFormat format, std::uint32_t stored) {
    return format == DepthFormat::unorm24 ? float(double(stored) / 16777215.0) : as_float(std::int32_t(stored));
}

/// Whether an incoming depth passes. I is std::int32_t or IntPack.
template <class I>
inline auto depth_passes(Compare compare, I incoming, I stored) -> decltype(incoming < stored) {
    using M = decltype(incoming < stored);
    switch (compare) {
        case Compare::never: return M(false);
        case Compare::less: return incoming < stored;
        case Compare::equal: return incoming == stored;
        case Compare::less_equal: return incoming <= stored;
        case Compare::greater: return incoming > stored;
        case Compare::not_equal: return incoming != stored;
        case Compare::greater_equal: return incoming >= stored;
        case Compare::always: break;
    }
    return M(true);
}

}  // namespace raster
