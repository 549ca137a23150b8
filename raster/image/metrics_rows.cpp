// metrics_rows.cpp: one loop, compiled for several instruction sets; the processor says which is used.
#include <raster/image/metrics_rows.h>

#include <cstddef>
#include <cstring>

// Plain functions over plain arrays only: nothing from a header may be compiled twice, or the linker could keep the
// version that other processors do not know. FMA stays out, since it would change the last bits.
#if defined(__GNUC__) && defined(__x86_64__) && !defined(__AVX2__)
#define RASTER_DISPATCH 1
#endif
#if defined(__GNUC__)
#define RASTER_INLINE inline __attribute__((always_inline))
#else
#define RASTER_INLINE inline
#endif

namespace raster {
namespace {

#if defined(__GNUC__)
constexpr int pack_size = 8;
using Pack = float __attribute__((vector_size(4 * pack_size)));
#else
constexpr int pack_size = 1;
using Pack = float;
#endif

/// One of the filters that run over the same rows.
struct Filter {
    const float* weights;
    float* out;
    bool add;
};
using Sum = void (*)(const Filter* filters, int radius, const float* const* rows, int count);

template <FilterSymmetry... symmetries>
RASTER_INLINE void sum(const Filter* filters, int radius, const float* const* rows, int count) {
    constexpr int n = sizeof...(symmetries);
    constexpr FilterSymmetry symmetry[] = {symmetries...};
    // As many sums as stay in registers.
    constexpr int packs = n == 1 ? 4 : 2, block = packs * pack_size;
    static_assert(row_block % block == 0);
    for (int i = 0; i < (count + row_block - 1) / row_block * row_block; i += block) {
        Pack sums[n][packs] = {};
        for (int f = 0; f < n; ++f) {
            if (filters[f].add) std::memcpy(sums[f], filters[f].out + i, sizeof sums[f]);
            for (int p = 0; p < packs && symmetry[f] == FilterSymmetry::even; ++p) {
                Pack middle;
                std::memcpy(&middle, rows[radius] + i + p * pack_size, sizeof middle);
                sums[f][p] += middle * filters[f].weights[0];
            }
        }
        for (int k = 1; k <= radius; ++k) {
            const float *before = rows[radius - k] + i, *after = rows[radius + k] + i;
            for (int p = 0; p < packs; ++p) {
                Pack a, b;
                std::memcpy(&a, after + p * pack_size, sizeof a);
                std::memcpy(&b, before + p * pack_size, sizeof b);
                const Pack even = a + b, odd = a - b;
                for (int f = 0; f < n; ++f)
                    sums[f][p] += (symmetry[f] == FilterSymmetry::even ? even : odd) * filters[f].weights[k];
            }
        }
        for (int f = 0; f < n; ++f) std::memcpy(filters[f].out + i, sums[f], sizeof sums[f]);
    }
}

/// A version of the loop for every processor, and the one for this processor.
#if RASTER_DISPATCH
#define RASTER_ROW_SUM(name, ...)                                                                                 \
    void name##_anywhere(const Filter* filters, int radius, const float* const* rows, int count) {                \
        sum<__VA_ARGS__>(filters, radius, rows, count);                                                           \
    }                                                                                                             \
    __attribute__((target("avx2"))) void name##_avx2(const Filter* filters, int radius, const float* const* rows, \
                                                     int count) {                                                 \
        sum<__VA_ARGS__>(filters, radius, rows, count);                                                           \
    }                                                                                                             \
    const Sum name = __builtin_cpu_supports("avx2") ? name##_avx2 : name##_anywhere;
#else
#define RASTER_ROW_SUM(name, ...)                                                                \
    void name(const Filter* filters, int radius, const float* const* rows, int count) {          \
        sum<__VA_ARGS__>(filters, radius, rows, count);                                          \
    }
#endif

constexpr FilterSymmetry e = FilterSymmetry::even, o = FilterSymmetry::odd;
RASTER_ROW_SUM(sum_e, e)
RASTER_ROW_SUM(sum_o, o)
RASTER_ROW_SUM(sum_ee, e, e)
RASTER_ROW_SUM(sum_oe, o, e)
RASTER_ROW_SUM(sum_eoe, e, o, e)
#undef RASTER_ROW_SUM

}  // namespace

void filter_rows(FilterSymmetry symmetry, const std::vector<float>& weights, const float* const* rows, int count,
                 float* out, bool add) {
    const Filter filter = {weights.data(), out, add};
    (symmetry == FilterSymmetry::even ? sum_e : sum_o)(&filter, int(weights.size()) - 1, rows, count);
}

void filter_rows_even_even(const std::vector<float>& weights_1, const std::vector<float>& weights_2,
                           const float* const* rows, int count, float* out_1, float* out_2) {
    const Filter filters[] = {{weights_1.data(), out_1, false}, {weights_2.data(), out_2, false}};
    sum_ee(filters, int(weights_1.size()) - 1, rows, count);
}

void filter_rows_odd_even(const std::vector<float>& odd, const std::vector<float>& even, const float* const* rows,
                          int count, float* out_odd, float* out_even) {
    const Filter filters[] = {{odd.data(), out_odd, false}, {even.data(), out_even, false}};
    sum_oe(filters, int(odd.size()) - 1, rows, count);
}

void filter_rows_even_odd_even(const std::vector<float>& even_1, const std::vector<float>& odd,
                               const std::vector<float>& even_2, const float* const* rows, int count, float* out_1,
                               float* out_odd, float* out_2) {
    const Filter filters[] = {{even_1.data(), out_1, false}, {odd.data(), out_odd, false}, {even_2.data(), out_2, false}};
    sum_eoe(filters, int(even_1.size()) - 1, rows, count);
}

}  // namespace raster
