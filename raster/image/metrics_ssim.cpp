// metrics_ssim.cpp: structural similarity with separable windows, over lanes and tiles, where pictures differ.
#include <raster/image/metrics.h>

#include <algorithm>
#include <array>
#include <memory>

#include <raster/image/metrics_display.h>
#include <raster/image/metrics_rows.h>
#include <raster/math.h>
#include <raster/tiles/parallel.h>

namespace raster {
namespace {

using F = FloatN;

constexpr int radius = 5, window = 2 * radius + 1;
constexpr int ssim_tile_width = 256, ssim_tile_height = 64;
constexpr int ring = 16;  // rows kept: a power of two that holds a window

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

/// The four sums that SSIM is made of.
enum Plane { x, y, squares, product, planes };

struct Scratch {
    float source[planes][ssim_tile_width + 2 * radius];  ///< one row
    float across[planes][ring][ssim_tile_width];         ///< rows weighted along x
    float down[planes][ssim_tile_width];                 ///< the row weighted along both
};
static_assert(ssim_tile_width % row_block == 0);

// Around the middle, so that squares stay small and lose fewer digits; SSIM's variances do not mind.
constexpr float middle = 0.5f;

void add_row(const Display& expected, const Display& actual, int x0, int row, int width,
             const std::vector<float>& weights, Scratch& scratch) {
    const int count = width + 2 * radius;
    auto& [x_row, y_row, squares_row, product_row] = scratch.source;
    expected.luma_row(x0 - radius, row, count, x_row);
    actual.luma_row(x0 - radius, row, count, y_row);
    for (int i = 0; i < count; ++i) {
        const float a = x_row[i] -= middle, b = y_row[i] -= middle;
        squares_row[i] = a * a + b * b;
        product_row[i] = a * b;
    }
    for (int plane = 0; plane < planes; ++plane) {
        std::array<const float*, window> rows;
        for (int k = 0; k < window; ++k) rows[std::size_t(k)] = scratch.source[plane] + k;
        filter_rows(FilterSymmetry::even, weights, rows.data(), width, scratch.across[plane][row & (ring - 1)]);
    }
}

void go_to_row(int row, int width, const std::vector<float>& weights, Scratch& scratch) {
    for (int plane = 0; plane < planes; ++plane) {
        std::array<const float*, window> rows;
        for (int k = 0; k < window; ++k) rows[std::size_t(k)] = scratch.across[plane][(row - radius + k) & (ring - 1)];
        filter_rows(FilterSymmetry::even, weights, rows.data(), width, scratch.down[plane]);
    }
}

/// 1 - SSIM of the windows around the pixels i, i + 1, ...: 0 exactly where the windows are equal.
F deficit(const Scratch& scratch, int i) {
    constexpr float c1 = 0.01f * 0.01f, c2 = 0.03f * 0.03f;
    const auto at = [&](Plane plane) { return load<F>(scratch.down[plane] + i); };
    const F mean_x = at(x), mean_y = at(y);
    const F variances = at(squares) - (mean_x * mean_x + mean_y * mean_y);
    const F covariance = at(product) - mean_x * mean_y;
    const F true_x = mean_x + middle, true_y = mean_y + middle;
    const F luminance = (true_x * true_y * 2.0f + c1) / (true_x * true_x + true_y * true_y + c1);
    const F structure = (covariance * 2.0f + c2) / (variances + c2);
    return F(1.0f) - luminance * structure;
}

struct Tile {
    int x0, y0, x1, y1;
};

double sum_of_deficits(const Display& expected, const Display& actual, const Tile& tile, const Image8& compared,
                       const std::vector<float>& weights) {
    // Zeroed: lanes beyond the tile are computed and dropped.
    const auto scratch = std::make_unique<Scratch>();
    const int width = tile.x1 - tile.x0;
    double sum = 0;
    for (int row = tile.y0 - radius; row < tile.y1 + radius; ++row) {
        add_row(expected, actual, tile.x0, row, width, weights, *scratch);
        const int center = row - radius;
        if (center < tile.y0) continue;
        go_to_row(center, width, weights, *scratch);
        std::array<float, ssim_tile_width> deficits;
        for (int i = 0; i < width; i += native_lanes) store(deficits.data() + i, deficit(*scratch, i));
        for (int i = 0; i < width; ++i) {
            const bool counts = compared.empty() || *compared.pixel(tile.x0 + i, center) != 0;
            sum += counts ? double(deficits[std::size_t(i)]) : 0.0;
        }
    }
    return sum;
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

    std::vector<Tile> all_tiles;
    for (int y = rows.first; y < rows.last; y += ssim_tile_height)
        for (int x = columns.first; x < columns.last; x += ssim_tile_width) {
            const Tile tile{x, y, std::min(x + ssim_tile_width, columns.last), std::min(y + ssim_tile_height, rows.last)};
            if (cells.any_in(tile.x0 - radius, tile.y0 - radius, tile.x1 + radius, tile.y1 + radius))
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
