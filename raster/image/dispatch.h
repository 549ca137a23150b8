// dispatch.h: functions compiled for several instruction sets, of which the processor says which is used.
//
// Only for what metrics spend their time in: loops over plain arrays and plain vectors. Nothing from a header may be
// compiled twice, or the linker could keep the version that other processors do not know; so what such a function calls
// is always inlined. FMA stays out, since it would change the last bits.
#pragma once

#include <cstdint>

#if defined(__GNUC__) && defined(__x86_64__) && !defined(__AVX2__)
#define RASTER_DISPATCH 1
#endif
#if defined(__GNUC__)
#define RASTER_INLINE inline __attribute__((always_inline))
#else
#define RASTER_INLINE inline
#endif

/// Defines the function `name` as `body<lanes>`, a RASTER_INLINE template, in the version for this processor.
#if RASTER_DISPATCH
#define RASTER_DISPATCHED(name, body, parameters, arguments)                                      \
    void name##_anywhere parameters { body<8> arguments; }                                        \
    __attribute__((target("avx2"))) void name##_avx2 parameters { body<8> arguments; }            \
    __attribute__((target("avx512f,avx512bw,avx512dq,avx512vl"))) void name##_avx512 parameters { \
        body<16> arguments;                                                                       \
    }                                                                                             \
    void(*const name) parameters = widest_registers() == 512   ? name##_avx512                    \
                                   : widest_registers() == 256 ? name##_avx2                      \
                                                               : name##_anywhere;
#else
#define RASTER_DISPATCHED(name, body, parameters, arguments) \
    void name parameters { body<pack_size> arguments; }
#endif

namespace raster {

#if RASTER_DISPATCH
/// In bits, of those that RASTER_DISPATCHED knows.
inline int widest_registers() {
    if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512bw") && __builtin_cpu_supports("avx512dq") &&
        __builtin_cpu_supports("avx512vl"))
        return 512;
    return __builtin_cpu_supports("avx2") ? 256 : 128;
}
#endif

/// Vectors of so many lanes.
#if defined(__GNUC__)
constexpr int pack_size = 8;
template <int lanes>
struct PackOf {
    typedef float Floats __attribute__((vector_size(4 * lanes)));
    typedef std::int32_t Integers __attribute__((vector_size(4 * lanes)));
};
#else
constexpr int pack_size = 1;
template <int>
struct PackOf {
    using Floats = float;
    using Integers = std::int32_t;
};
#endif
template <int lanes>
using Pack = typename PackOf<lanes>::Floats;
/// The integers that go with a Pack.
template <class P>
using IntegersOf = typename PackOf<int(sizeof(P) / 4)>::Integers;

}  // namespace raster
