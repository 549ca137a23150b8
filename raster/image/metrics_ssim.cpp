// metrics_ssim.cpp: structural similarity with separable windows, over lanes and tiles, where pictures differ.
#include <raster/image/metrics.h>

#include <algorithm>
#include <array>
#include <memory>
#include <numeric>

#include <raster/image/dispatch.h>
#include <raster/image/metrics_display.h>
#include <raster/image/metrics_rows.h>
#include <raster/math.h>
#include <raster/tiles/parallel.h>

namespace raster {
namespace {

constexpr int radius = 5, window = 2 * radius + 1;
constexpr int ssim_tile_width = 256, ssim_tile_height = 64, highest_ssim_tile = 512;
constexpr int ring = 16;  // rows kept: a power of two that holds the windows of rows_at_once rows
static_assert(ring >= window + rows_at_once - 1);

std::vector<float> window_weights() {
    std::vector<float> weights;
    double sum = 0;
    for (int i = 0; i <= radius; ++i) {
        weights.push_back(exp(float(-i * i) / (2 * 1.5f * 1.5f)));
        sum += (i == 0 ? 1 : 2) * double(weights.back());
    }
    for (float& w : weights) w = float(double(w) / sum);
    return weights;
}

/// The four sums that SSIM is made of: of the expected picture x, of the change d to the actual one, of both pictures'
/// squares, and of the change's squares. Of equal windows, those of the change are 0 exactly.
enum Plane { x, change, squares, squared_change, planes };

struct alignas(AlignedFloats::alignment) Scratch {
    float source[planes][ssim_tile_width + row_block];  ///< one row
    float across[planes][ring][ssim_tile_width];         ///< rows weighted along x
    float down[planes][rows_at_once][ssim_tile_width];   ///< rows weighted along both
};
static_assert(ssim_tile_width % row_block == 0);

// Around the middle, so that squares stay small and lose fewer digits; SSIM's variances do not mind.
constexpr float middle = 0.5f;

/// Lumas become the planes of a row.
template <int>
RASTER_INLINE void find_planes(float* __restrict x, float* __restrict change, float* __restrict squares,
                               float* __restrict squared_change, int count) {
    for (int i = 0; i < count; ++i) {
        const float a = x[i] - middle, b = change[i] - middle, d = b - a;
        x[i] = a, change[i] = d;
        squares[i] = a * a + b * b;
        squared_change[i] = d * d;
    }
}

/// 1 - SSIM of the windows around `count` pixels of a row, from their weighted planes: 0 exactly where windows are
/// equal.
template <int>
RASTER_INLINE void find_deficits(const float* __restrict x, const float* __restrict change,
                                 const float* __restrict squares, const float* __restrict squared_change, int count,
                                 float* __restrict deficits) {
    constexpr float c1 = 0.01f * 0.01f, c2 = 0.03f * 0.03f;
    for (int i = 0; i < count; ++i) {
        const float mean_x = x[i], mean_change = change[i], mean_y = mean_x + mean_change;
        const float true_x = mean_x + middle, true_y = mean_y + middle;
        // 1 - (2 x y + c1) / (x^2 + y^2 + c1), and the same of the deviations, without a difference of near numbers.
        const float variances = squares[i] - (mean_x * mean_x + mean_y * mean_y);
        const float variance_of_change = squared_change[i] - mean_change * mean_change;
        const float luminance = mean_change * mean_change / (true_x * true_x + true_y * true_y + c1);
        const float structure = (variance_of_change > 0.0f ? variance_of_change : 0.0f) /
                                ((variances > 0.0f ? variances : 0.0f) + c2);
        deficits[i] = luminance + structure - luminance * structure;
    }
}

RASTER_DISPATCHED(planes_here, find_planes,
                  (float* x, float* change, float* squares, float* squared_change, int count),
                  (x, change, squares, squared_change, count))
RASTER_DISPATCHED(deficits_here, find_deficits,
                  (const float* x, const float* change, const float* squares, const float* squared_change, int count,
                   float* deficits),
                  (x, change, squares, squared_change, count, deficits))

void add_row(const Display& expected, const Display& actual, int x0, int row, int width,
             const std::vector<float>& weights, Scratch& scratch) {
    const int count = width + 2 * radius;
    auto& [x_row, change_row, squares_row, squared_change_row] = scratch.source;
    expected.luma_row(x0 - radius, row, count, x_row);
    actual.luma_row(x0 - radius, row, count, change_row);
    planes_here(x_row, change_row, squares_row, squared_change_row, count);
    for (int plane = 0; plane < planes; ++plane) {
        std::array<const float*, window> rows;
        for (int k = 0; k < window; ++k) rows[std::size_t(k)] = scratch.source[plane] + k;
        filter_rows(FilterSymmetry::even, weights, rows.data(), width, scratch.across[plane][row & (ring - 1)]);
    }
}

void go_to_rows(int row, int width, const std::vector<float>& weights, Scratch& scratch) {
    for (int plane = 0; plane < planes; ++plane) {
        std::array<const float*, window + rows_at_once - 1> rows;
        for (std::size_t k = 0; k < rows.size(); ++k)
            rows[k] = scratch.across[plane][(row - radius + int(k)) & (ring - 1)];
        std::array<float*, rows_at_once> down;
        for (std::size_t o = 0; o < down.size(); ++o) down[o] = scratch.down[plane][o];
        filter_columns(weights, rows.data(), width, down.data());
    }
}

struct Tile {
    int x0, y0, x1, y1;
};

double sum_of_deficits(const Display& expected, const Display& actual, const Tile& tile, const Image8& compared,
                       const std::vector<float>& weights) {
    // Zeroed: lanes beyond the tile are computed and dropped.
    const auto scratch = std::make_unique<Scratch>();
    const int width = tile.x1 - tile.x0;
    std::array<double, sum_parts> sums{};
    int added = tile.y0 - radius;
    for (int row = tile.y0; row < tile.y1; row += rows_at_once) {
        for (; added < row + rows_at_once + radius; ++added)
            add_row(expected, actual, tile.x0, added, width, weights, *scratch);
        go_to_rows(row, width, weights, *scratch);
        for (int o = 0; o < std::min(rows_at_once, tile.y1 - row); ++o) {
            alignas(AlignedFloats::alignment) std::array<float, ssim_tile_width> deficits;
            const auto& down = scratch->down;
            deficits_here(down[x][o], down[change][o], down[squares][o], down[squared_change][o], width,
                          deficits.data());
            if (!compared.empty())
                for (int i = 0; i < width; ++i)
                    if (*compared.pixel(tile.x0 + i, row + o) == 0) deficits[std::size_t(i)] = 0;
            add_in_parts(deficits.data(), width, 0.0f, sums.data());
        }
    }
    return std::accumulate(sums.begin(), sums.end(), 0.0);
}

/// The centres of whole windows; of a picture smaller than the window, all pixels.
struct Centers {
    explicit Centers(int size) : first(size < window ? 0 : radius), last(size < window ? size : size - radius) {}
    int first, last;
};

double ssim_over(const AnyImage& expected_image, const AnyImage& actual_image, const DifferingCells& cells,
                 const Image8& compared, float background) {
    static const std::vector<float> weights = window_weights();
    const Display expected(expected_image, background), actual(actual_image, background);
    const Centers columns(expected.width()), rows(expected.height());

    // Tiles one below the other become one, up to a limit: each has to filter `radius` rows more at both its ends.
    std::vector<Tile> all_tiles;
    for (int x = columns.first; x < columns.last; x += ssim_tile_width)
        for (int y = rows.first; y < rows.last; y += ssim_tile_height) {
            const Tile tile{x, y, std::min(x + ssim_tile_width, columns.last),
                            std::min(y + ssim_tile_height, rows.last)};
            if (!cells.any_in(tile.x0 - radius, tile.y0 - radius, tile.x1 + radius, tile.y1 + radius)) continue;
            const bool grows = !all_tiles.empty() && all_tiles.back().x0 == x && all_tiles.back().y1 == y &&
                               y - all_tiles.back().y0 < highest_ssim_tile;
            if (grows)
                all_tiles.back().y1 = tile.y1;
            else
                all_tiles.push_back(tile);
        }
    std::vector<double> deficits(all_tiles.size());
    tiles::parallel_for(all_tiles.size(), [&](std::size_t i) {
        deficits[i] = sum_of_deficits(expected, actual, all_tiles[i], compared, weights);
    });

    std::int64_t count = 0;
    if (compared.empty()) {
        count = std::int64_t(columns.last - columns.first) * (rows.last - rows.first);
    } else {
        const auto counts = [](std::uint8_t c) { return c != 0; };
        for (int y = rows.first; y < rows.last; ++y) {
            const std::uint8_t* first = compared.pixel(columns.first, y);
            count += std::count_if(first, first + (columns.last - columns.first), counts);
        }
    }
    double sum = 0;
    for (const double tile : deficits) sum += tile;
    return count == 0 ? 1.0 : std::min(1.0 - sum / double(count), 1.0);
}

}  // namespace

double mean_ssim(const AnyImage& expected, const AnyImage& actual, const DifferingCells& cells,
                 const Image8& compared) {
    const double over_black = ssim_over(expected, actual, cells, compared, 0.0f);
    if (!has_transparency(expected) && !has_transparency(actual)) return over_black;
    return std::min(over_black, ssim_over(expected, actual, cells, compared, 1.0f));
}

}  // namespace raster
