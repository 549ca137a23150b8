// metrics_rows.cpp: one loop, compiled for several instruction sets; the processor says which is used.
#include <raster/image/metrics_rows.h>

#include <algorithm>
#include <cstddef>
#include <cstring>

#include <raster/image/dispatch.h>

namespace raster {
namespace {

// One pack at a time: sums that are copied as an array are kept in memory.
template <class P>
RASTER_INLINE void load_pack(P& pack, const float* from) { std::memcpy(&pack, from, sizeof pack); }
template <class P>
RASTER_INLINE void store_pack(float* to, const P& pack) {
    const P copy = pack;
    std::memcpy(to, &copy, sizeof copy);
}

/// One of the filters that run over the same rows.
struct Filter {
    const float* weights;
    float* out;
    bool add;
};

template <int lanes, FilterSymmetry... symmetries>
RASTER_INLINE void sum(const Filter* filters, int radius, const float* const* rows, int count) {
    constexpr int n = sizeof...(symmetries);
    constexpr FilterSymmetry symmetry[] = {symmetries...};
    // As many sums as stay in registers.
    constexpr int packs = (n == 1 ? 32 : 16) / lanes, block = packs * lanes;
    static_assert(row_block % block == 0);
    for (int i = 0; i < (count + row_block - 1) / row_block * row_block; i += block) {
        Pack<lanes> sums[n][packs] = {};
        for (int f = 0; f < n; ++f) {
            for (int p = 0; p < packs; ++p) {
                if (filters[f].add) load_pack(sums[f][p], filters[f].out + i + p * lanes);
                Pack<lanes> middle;
                load_pack(middle, rows[radius] + i + p * lanes);
                if (symmetry[f] == FilterSymmetry::even) sums[f][p] += middle * filters[f].weights[0];
            }
        }
        for (int k = 1; k <= radius; ++k) {
            const float *before = rows[radius - k] + i, *after = rows[radius + k] + i;
            for (int p = 0; p < packs; ++p) {
                Pack<lanes> a, b;
                load_pack(a, after + p * lanes);
                load_pack(b, before + p * lanes);
                const Pack<lanes> even = a + b, odd = a - b;
                for (int f = 0; f < n; ++f)
                    sums[f][p] += (symmetry[f] == FilterSymmetry::even ? even : odd) * filters[f].weights[k];
            }
        }
        for (int f = 0; f < n; ++f)
            for (int p = 0; p < packs; ++p) store_pack(filters[f].out + i + p * lanes, sums[f][p]);
    }
}

/// The weights of both sides, and a zero beyond each, so that pairs of sums can run over the same rows.
struct BothSides {
    float weights[2 * most_weights + 2];
    int taps;  ///< without the zeros
};

/// Adds the rows of data from `begin` to `end` to the sums for the rows of the picture from `first` to `last`.
template <int first, int last, int packs, class P>
RASTER_INLINE void add_rows(const BothSides& filter, const float* const* rows, int i, int begin, int end,
                            P (&sums)[rows_at_once][packs]) {
    for (int row = begin; row < end; ++row) {
        for (int p = 0; p < packs; ++p) {
            P in;
            load_pack(in, rows[row] + i + p * int(sizeof(P) / 4));
            for (int o = first; o < last; ++o) sums[o][p] += in * filter.weights[row - o + 1];
        }
        __builtin_prefetch(rows[row] + i + 4 * packs * int(sizeof(P) / 4));
    }
}

template <int lanes>
RASTER_INLINE void sum_columns(const BothSides& filter, const float* const* rows, int count, float* const* out,
                               bool add) {
    constexpr int packs = 2, block = packs * lanes;
    static_assert(rows_at_once == 4);
    for (int i = 0; i < (count + row_block - 1) / row_block * row_block; i += block) {
        Pack<lanes> sums[rows_at_once][packs];
        for (int o = 0; o < rows_at_once; ++o)
            for (int p = 0; p < packs; ++p) {
                sums[o][p] = Pack<lanes>{};
                if (add) load_pack(sums[o][p], out[o] + i + p * lanes);
            }
        add_rows<0, 2>(filter, rows, i, 0, 2, sums);
        add_rows<0, 4>(filter, rows, i, 2, filter.taps + 1, sums);
        add_rows<2, 4>(filter, rows, i, filter.taps + 1, filter.taps + 3, sums);
        for (int o = 0; o < rows_at_once; ++o)
            for (int p = 0; p < packs; ++p) store_pack(out[o] + i + p * lanes, sums[o][p]);
    }
}

template <int>
RASTER_INLINE void luma_of(const std::uint8_t* __restrict rgb, int count, float* __restrict luma) {
    constexpr float scale = 1.0f / 255.0f;
    for (int i = 0; i < count; ++i)
        luma[i] = 0.299f * (float(rgb[3 * i]) * scale) + 0.587f * (float(rgb[3 * i + 1]) * scale) +
                  0.114f * (float(rgb[3 * i + 2]) * scale);
}

#if defined(__GNUC__)
using Doubles = double __attribute__((vector_size(64)));
#endif

template <int>
RASTER_INLINE void sum_parts_of(const float* values, int count, float least, double* sums, bool& all_are_large) {
#if defined(__GNUC__)
    Doubles sum;
    std::memcpy(&sum, sums, sizeof sum);
    IntegersOf<Pack<8>> small{};
    for (int i = 0; i < count; i += sum_parts) {
        Pack<8> v;
        std::memcpy(&v, values + i, sizeof v);
        sum += __builtin_convertvector(v, Doubles);
        small |= (v > 0.0f) & (v < least);
    }
    std::memcpy(sums, &sum, sizeof sum);
    std::int32_t any = 0;
    for (int lane = 0; lane < 8; ++lane) any |= small[lane];
    all_are_large = any == 0;
#else
    all_are_large = true;
    for (int i = 0; i < count; ++i) {
        sums[i % sum_parts] += double(values[i]);
        all_are_large = all_are_large && !(values[i] > 0.0f && values[i] < least);
    }
#endif
}

constexpr FilterSymmetry e = FilterSymmetry::even, o = FilterSymmetry::odd;
#define RASTER_ROW_SUM(name, ...)                                                                                \
    template <int lanes>                                                                                         \
    RASTER_INLINE void name##_body(const Filter* filters, int radius, const float* const* rows, int count) {     \
        sum<lanes, __VA_ARGS__>(filters, radius, rows, count);                                                   \
    }                                                                                                            \
    RASTER_DISPATCHED(name, name##_body, (const Filter* filters, int radius, const float* const* rows, int count), \
                      (filters, radius, rows, count))
RASTER_ROW_SUM(sum_e, e)
RASTER_ROW_SUM(sum_o, o)
RASTER_ROW_SUM(sum_ee, e, e)
RASTER_ROW_SUM(sum_oe, o, e)
RASTER_ROW_SUM(sum_eoe, e, o, e)
#undef RASTER_ROW_SUM
RASTER_DISPATCHED(columns_here, sum_columns,
                  (const BothSides& filter, const float* const* rows, int count, float* const* out, bool add),
                  (filter, rows, count, out, add))
RASTER_DISPATCHED(sum_parts_here, sum_parts_of,
                  (const float* values, int count, float least, double* sums, bool& all_are_large),
                  (values, count, least, sums, all_are_large))
RASTER_DISPATCHED(luma_here, luma_of, (const std::uint8_t* rgb, int count, float* luma), (rgb, count, luma))

}  // namespace

void filter_rows(FilterSymmetry symmetry, const std::vector<float>& weights, const float* const* rows, int count,
                 float* out, bool add) {
    const Filter filter = {weights.data(), out, add};
    (symmetry == FilterSymmetry::even ? sum_e : sum_o)(&filter, int(weights.size()) - 1, rows, count);
}

void luma_of_bytes(const std::uint8_t* rgb, int count, float* luma) { luma_here(rgb, count, luma); }

bool add_in_parts(float* values, int count, float least, double* sums) {
    const int end = (count + sum_parts - 1) / sum_parts * sum_parts;
    std::fill(values + count, values + end, 0.0f);
    bool all_are_large = true;
    sum_parts_here(values, end, least, sums, all_are_large);
    return all_are_large;
}

void filter_columns(const std::vector<float>& weights, const float* const* rows, int count, float* const* out,
                    bool add) {
    const int radius = int(weights.size()) - 1;
    BothSides filter;
    filter.taps = 2 * radius + 1;
    filter.weights[0] = filter.weights[filter.taps + 1] = 0;
    float* const middle = filter.weights + 1 + radius;
    for (int k = 0; k <= radius; ++k) middle[k] = middle[-k] = weights[std::size_t(k)];
    columns_here(filter, rows, count, out, add);
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
    const Filter filters[] = {
        {even_1.data(), out_1, false}, {odd.data(), out_odd, false}, {even_2.data(), out_2, false}};
    sum_eoe(filters, int(even_1.size()) - 1, rows, count);
}

}  // namespace raster
