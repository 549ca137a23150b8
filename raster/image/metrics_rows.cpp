// metrics_rows.cpp: one loop, compiled for several instruction sets; the processor says which is used.
#include <raster/image/metrics_rows.h>

#include <cstddef>
#include <cstring>

// Plain functions over plain arrays only: nothing from a header may be compiled twice, or the linker could keep the
// version that other processors do not know. FMA stays out, since it would change the last bits.
#if defined(__GNUC__) && defined(__x86_64__) && !defined(__AVX2__)
#define RASTER_DISPATCH 1
#endif

namespace raster {
namespace {

using Sum = void (*)(const float* weights, int radius, const float* const* rows, int count, float* out, bool add);

#if defined(__GNUC__)
constexpr int pack_size = 8;
using Pack = float __attribute__((vector_size(4 * pack_size)));
#define RASTER_INLINE inline __attribute__((always_inline))
#else
constexpr int pack_size = 1;
using Pack = float;
#define RASTER_INLINE inline
#endif
constexpr int packs = row_block / pack_size;

template <FilterSymmetry symmetry>
RASTER_INLINE void sum(const float* weights, int radius, const float* const* rows, int count, float* out, bool add) {
    for (int i = 0; i < count; i += row_block) {
        Pack sums[packs] = {};
        if (add) std::memcpy(sums, out + i, sizeof sums);
        if constexpr (symmetry == FilterSymmetry::even) {
            for (int p = 0; p < packs; ++p) {
                Pack middle;
                std::memcpy(&middle, rows[radius] + i + p * pack_size, sizeof middle);
                sums[p] += middle * weights[0];
            }
        }
        for (int k = 1; k <= radius; ++k) {
            const float *before = rows[radius - k] + i, *after = rows[radius + k] + i;
            for (int p = 0; p < packs; ++p) {
                Pack a, b;
                std::memcpy(&a, after + p * pack_size, sizeof a);
                std::memcpy(&b, before + p * pack_size, sizeof b);
                sums[p] += (symmetry == FilterSymmetry::even ? a + b : a - b) * weights[k];
            }
        }
        std::memcpy(out + i, sums, sizeof sums);
    }
}

void sum_even(const float* weights, int radius, const float* const* rows, int count, float* out, bool add) {
    sum<FilterSymmetry::even>(weights, radius, rows, count, out, add);
}
void sum_odd(const float* weights, int radius, const float* const* rows, int count, float* out, bool add) {
    sum<FilterSymmetry::odd>(weights, radius, rows, count, out, add);
}

#if RASTER_DISPATCH
__attribute__((target("avx2"))) void sum_even_avx2(const float* weights, int radius, const float* const* rows,
                                                   int count, float* out, bool add) {
    sum<FilterSymmetry::even>(weights, radius, rows, count, out, add);
}
__attribute__((target("avx2"))) void sum_odd_avx2(const float* weights, int radius, const float* const* rows,
                                                  int count, float* out, bool add) {
    sum<FilterSymmetry::odd>(weights, radius, rows, count, out, add);
}
const Sum even_sum = __builtin_cpu_supports("avx2") ? sum_even_avx2 : sum_even;
const Sum odd_sum = __builtin_cpu_supports("avx2") ? sum_odd_avx2 : sum_odd;
#else
constexpr Sum even_sum = sum_even, odd_sum = sum_odd;
#endif

}  // namespace

void filter_rows(FilterSymmetry symmetry, const std::vector<float>& weights, const float* const* rows, int count,
                 float* out, bool add) {
    const Sum chosen = symmetry == FilterSymmetry::even ? even_sum : odd_sum;
    chosen(weights.data(), int(weights.size()) - 1, rows, count, out, add);
}

}  // namespace raster
