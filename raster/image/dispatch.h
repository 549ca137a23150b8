// dispatch.h: functions compiled for several instruction sets, of which the processor says which is used.
//
// Only for what metrics spend their time in: loops over plain arrays and plain vectors. Nothing from a header may be
// compiled twice, or the linker could keep the version that other processors do not know; so what such a function calls
// is always inlined. FMA stays out, since it would change the last bits.
#pragma once

#if defined(__GNUC__) && defined(__x86_64__) && !defined(__AVX2__)
#define RASTER_DISPATCH 1
#endif
#if defined(__GNUC__)
#define RASTER_INLINE inline __attribute__((always_inline))
#else
#define RASTER_INLINE inline
#endif

/// Defines the function `name` as the RASTER_INLINE function `body`, in the version for this processor.
#if RASTER_DISPATCH
#define RASTER_DISPATCHED(name, body, parameters, arguments)                        \
    void name##_anywhere parameters { body arguments; }                             \
    __attribute__((target("avx2"))) void name##_avx2 parameters { body arguments; } \
    void(*const name) parameters = __builtin_cpu_supports("avx2") ? name##_avx2 : name##_anywhere;
#else
#define RASTER_DISPATCHED(name, body, parameters, arguments) \
    void name parameters { body arguments; }
#endif

namespace raster {

/// As many floats as the widest of these instruction sets takes at once.
#if defined(__GNUC__)
constexpr int pack_size = 8;
using Pack = float __attribute__((vector_size(4 * pack_size)));
#else
constexpr int pack_size = 1;
using Pack = float;
#endif

}  // namespace raster
