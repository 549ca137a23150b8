// config.h: the build settings that the exactness of this library rests on, checked.
#pragma once

#if defined(__FAST_MATH__)
#error "raster: -ffast-math changes results between builds; this library promises the same bytes everywhere"
#endif

#if defined(__FLT_EVAL_METHOD__) && __FLT_EVAL_METHOD__ != 0
#error "raster: floats must be evaluated as floats (on 32-bit x86 use -msse2 -mfpmath=sse)"
#endif

/// On a loop over pixels or vertices: inline all that it calls, the user's shader included. Packs then stay in registers;
/// across calls they would travel through memory.
#if defined(__GNUC__)
#define RASTER_FLATTEN [[gnu::flatten]]
#else
#define RASTER_FLATTEN
#endif

/// On a function that is called as one, in which all that it calls is inlined.
#if defined(__GNUC__)
#define RASTER_ONE_CALL [[gnu::noinline, gnu::flatten]]
#else
#define RASTER_ONE_CALL
#endif

namespace raster {

/// Lanes of a pack: how many floats the target's registers hold. It changes speed, never a bit of a picture.
#if defined(RASTER_LANES)
inline constexpr int native_lanes = RASTER_LANES;
#elif defined(__AVX__)
inline constexpr int native_lanes = 8;
#else
inline constexpr int native_lanes = 4;
#endif

}  // namespace raster
