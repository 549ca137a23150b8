// metrics_plain.cpp: the figures that are sums and largest values of sample differences.
#include <raster/image/metrics.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <type_traits>
#include <utility>

#include <raster/image/dispatch.h>
#include <raster/image/pages.h>
#include <raster/math.h>
#include <raster/tiles/parallel.h>

namespace raster {
namespace {

/// Sums of a row: exact integers for whole numbers, so that their order does not matter.
template <class T>
struct RowSums {
    using Sum = std::conditional_t<std::is_same_v<T, float>, double, std::uint64_t>;
    Sum absolute = 0, squared = 0;
    std::int64_t differing = 0;
    float max = 0;
    int max_x = 0;
};

template <class T>
auto difference(T a, T b) {
    if constexpr (std::is_same_v<T, float>) {
        return a == b ? 0.0 : std::abs(double(a) - double(b));
    } else {
        return std::uint32_t(a < b ? b - a : a - b);
    }
}

template <int channels, class T>
RowSums<T> compare_row(const T* a, const T* b, int width, float* deltas) {
    RowSums<T> sums;
    for (int x = 0; x < width; ++x) {
        decltype(difference(*a, *b)) largest = 0;
        for (int c = 0; c < channels; ++c, ++a, ++b) {
            const auto d = difference(*a, *b);
            largest = largest < d ? d : largest;
            sums.absolute += d;
            sums.squared += decltype(sums.squared)(d) * d;
        }
        // A float that differs in doubles only must not be called equal.
        float delta = float(largest);
        if (std::is_same_v<T, float> && largest > 0 && delta == 0) delta = std::numeric_limits<float>::denorm_min();
        deltas[x] = delta;
    }
    for (int x = 0; x < width; ++x) sums.differing += deltas[x] > 0;
    for (int x = 0; x < width; ++x)
        if (deltas[x] > sums.max) sums.max = deltas[x], sums.max_x = x;
    return sums;
}

constexpr int byte_block = 256;

/// What a block of a row has: sums that fit, and the largest difference of each pixel.
struct BlockSums {
    std::uint32_t absolute = 0, squared = 0;
    int differing = 0;
    std::uint8_t most = 0;
    std::uint8_t largest[byte_block];
};

/// Bytes, which most pictures have, in loops that compilers turn into vectors.
template <int channels>
RASTER_INLINE void compare_block(const std::uint8_t* a, const std::uint8_t* b, int count, BlockSums& sums,
                                 float* deltas) {
    const int samples = count * channels;
    std::uint8_t differences[byte_block * channels];
    for (int i = 0; i < samples; ++i) {
        const std::uint8_t larger = a[i] > b[i] ? a[i] : b[i], smaller = a[i] > b[i] ? b[i] : a[i];
        differences[i] = std::uint8_t(larger - smaller);
    }
    std::uint32_t absolute = 0, squared = 0;
    for (int i = 0; i < samples; ++i) absolute += differences[i];
    for (int i = 0; i < samples; ++i) squared += std::uint32_t(std::uint16_t(differences[i] * differences[i]));
    sums.absolute = absolute, sums.squared = squared;
    for (int x = 0; x < count; ++x) {
        std::uint8_t d = differences[x * channels];
        for (int c = 1; c < channels; ++c) {
            const std::uint8_t other = differences[x * channels + c];
            d = d > other ? d : other;
        }
        sums.largest[x] = d;
    }
    std::uint8_t most = 0;
    int differing = 0;
    for (int x = 0; x < count; ++x) most = most > sums.largest[x] ? most : sums.largest[x];
    for (int x = 0; x < count; ++x) differing += sums.largest[x] != 0;
    for (int x = 0; x < count; ++x) deltas[x] = float(sums.largest[x]);
    sums.most = most, sums.differing = differing;
}

#define RASTER_COMPARE_BLOCK(name, channels)                                                                        \
    template <int>                                                                                                  \
    RASTER_INLINE void name##_body(const std::uint8_t* a, const std::uint8_t* b, int count, BlockSums& sums,        \
                                   float* deltas) {                                                                 \
        compare_block<channels>(a, b, count, sums, deltas);                                                         \
    }                                                                                                               \
    RASTER_DISPATCHED(name, name##_body,                                                                            \
                      (const std::uint8_t* a, const std::uint8_t* b, int count, BlockSums& sums, float* deltas), \
                      (a, b, count, sums, deltas))
RASTER_COMPARE_BLOCK(compare_block_1, 1)
RASTER_COMPARE_BLOCK(compare_block_2, 2)
RASTER_COMPARE_BLOCK(compare_block_3, 3)
RASTER_COMPARE_BLOCK(compare_block_4, 4)
#undef RASTER_COMPARE_BLOCK

template <int channels>
RowSums<std::uint8_t> compare_row(const std::uint8_t* a, const std::uint8_t* b, int width, float* deltas) {
    RowSums<std::uint8_t> sums;
    const auto compare = channels == 1   ? compare_block_1
                         : channels == 2 ? compare_block_2
                         : channels == 3 ? compare_block_3
                                         : compare_block_4;
    BlockSums block;
    for (int start = 0; start < width; start += byte_block) {
        const int count = std::min(byte_block, width - start);
        compare(a + start * channels, b + start * channels, count, block, deltas + start);
        sums.absolute += block.absolute, sums.squared += block.squared;
        sums.differing += block.differing;
        if (float(block.most) > sums.max)
            sums.max = block.most,
            sums.max_x = start + int(std::find(block.largest, block.largest + count, block.most) - block.largest);
    }
    return sums;
}

template <class T>
RowSums<T> compare_row(int channels, const T* a, const T* b, int width, float* deltas) {
    switch (channels) {
        case 1: return compare_row<1>(a, b, width, deltas);
        case 2: return compare_row<2>(a, b, width, deltas);
        case 3: return compare_row<3>(a, b, width, deltas);
        default: return compare_row<4>(a, b, width, deltas);
    }
}

template <class T>
constexpr double peak = std::is_same_v<T, float> ? 1.0 : double(std::numeric_limits<T>::max());

/// 10 log10(x) without the C library, whose last bits vary; 1e-5 dB are never shown. For x > 0.
double decibels(double x) {
    int exponent = 0;
    const double mantissa = std::frexp(x, &exponent);  // exact; keeps x in a float's range
    return 3.0102999566398120 * (exponent + double(log2(float(mantissa))));
}

}  // namespace

template <class T>
PlainMetrics plain_metrics(const Image<T>& expected, const Image<T>& actual, std::int64_t compared,
                           std::vector<float> zeros) {
    PlainMetrics metrics;
    const std::size_t row_samples = std::size_t(expected.width) * std::size_t(expected.channels);
    if (!std::is_same_v<T, float> && expected.samples == actual.samples) return metrics;

    metrics.deltas.width = expected.width, metrics.deltas.height = expected.height, metrics.deltas.channels = 1;
    const std::size_t pixels = std::size_t(expected.width) * std::size_t(expected.height);
    if (zeros.size() == pixels)
        metrics.deltas.samples = std::move(zeros);
    else
        resize_whole(metrics.deltas.samples, pixels);
    std::vector<RowSums<T>> rows(std::size_t(expected.height));
    constexpr int rows_at_once = 16;
    tiles::parallel_for(std::size_t(expected.height + rows_at_once - 1) / rows_at_once, [&](std::size_t band) {
        const int first = int(band) * rows_at_once;
        for (int y = first; y < std::min(first + rows_at_once, expected.height); ++y) {
            const T *a = expected.pixel(0, y), *b = actual.pixel(0, y);
            if (std::memcmp(a, b, row_samples * sizeof(T)) == 0) continue;
            rows[std::size_t(y)] = compare_row(expected.channels, a, b, expected.width, metrics.deltas.pixel(0, y));
        }
    });

    typename RowSums<T>::Sum absolute = 0, squared = 0;
    for (int y = 0; y < expected.height; ++y) {
        const RowSums<T>& row = rows[std::size_t(y)];
        absolute += row.absolute;
        squared += row.squared;
        metrics.differing += row.differing;
        if (double(row.max) > metrics.max) metrics.max = row.max, metrics.max_x = row.max_x, metrics.max_y = y;
    }
    if (metrics.differing == 0) {
        metrics.deltas = {};
        return metrics;
    }
    const double samples = double(compared) * expected.channels;
    metrics.mean = double(absolute) / samples;
    metrics.rms = std::sqrt(double(squared) / samples);
    metrics.psnr = decibels(peak<T> * peak<T> * samples / double(squared));
    return metrics;
}

template PlainMetrics plain_metrics(const Image8&, const Image8&, std::int64_t, std::vector<float>);
template PlainMetrics plain_metrics(const Image16&, const Image16&, std::int64_t, std::vector<float>);
template PlainMetrics plain_metrics(const ImageF&, const ImageF&, std::int64_t, std::vector<float>);

DifferingCells::DifferingCells(const ImageF& deltas)
    : columns_((deltas.width + cell - 1) / cell),
      rows_((deltas.height + cell - 1) / cell),
      differs_(std::size_t(columns_) * std::size_t(rows_)) {
    tiles::parallel_for(std::size_t(rows_), [&](std::size_t row) {
        for (int y = int(row) * cell; y < std::min(int(row + 1) * cell, deltas.height); ++y) {
            const float* delta = deltas.pixel(0, y);
            for (int column = 0; column < columns_; ++column) {
                std::uint8_t& differs = differs_[row * std::size_t(columns_) + std::size_t(column)];
                if (differs != 0) continue;
                bool any = false;
                for (int x = column * cell; x < std::min((column + 1) * cell, deltas.width); ++x) any |= delta[x] > 0;
                differs = std::uint8_t(any);
            }
        }
    });
}

bool DifferingCells::any_in(int x0, int y0, int x1, int y1) const {
    for (int row = std::max(y0 / cell, 0); row * cell < y1 && row < rows_; ++row)
        for (int column = std::max(x0 / cell, 0); column * cell < x1 && column < columns_; ++column)
            if (differs_[std::size_t(row) * std::size_t(columns_) + std::size_t(column)] != 0) return true;
    return false;
}

double mean_of(const ImageF& map, const Image8& compared) {
    if (map.empty()) return 0;
    std::vector<double> sums(std::size_t(map.height));
    std::vector<std::int64_t> counts(std::size_t(map.height));
    tiles::parallel_for(sums.size(), [&](std::size_t y) {
        const float* row = map.pixel(0, int(y));
        const std::uint8_t* counts_here = compared.empty() ? nullptr : compared.pixel(0, int(y));
        std::int64_t count = 0;
        std::array<double, 8> parts{};  // side by side, so that they need not wait for each other
        for (int x = 0; x < map.width; ++x) {
            const bool in = counts_here == nullptr || counts_here[x] != 0;
            parts[std::size_t(x) % parts.size()] += in ? double(row[x]) : 0.0;
            count += in;
        }
        counts[y] = count;
        double sum = 0;
        for (const double part : parts) sum += part;
        sums[y] = sum;
    });
    double sum = 0;
    std::int64_t count = 0;
    for (std::size_t y = 0; y < sums.size(); ++y) sum += sums[y], count += counts[y];
    return count == 0 ? 0 : sum / double(count);
}

}  // namespace raster
