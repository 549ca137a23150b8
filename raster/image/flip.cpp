// flip.cpp: FLIP in one pass over tiles: rows filtered along x go into rings, and are filtered along y from there.
//
// All filters of the paper are sums of products of a function of x and one of y, so that two passes of one
// dimension give what one of two would: 2 * 21 weights instead of 441.
#include <raster/image/flip.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cstdint>
#include <numeric>
#include <vector>

#include <raster/image/flip_color.h>
#include <raster/image/flip_filters.h>
#include <raster/image/flip_rows.h>
#include <raster/image/metrics_display.h>
#include <raster/image/metrics_rows.h>
#include <raster/image/pages.h>
#include <raster/tiles/parallel.h>

namespace raster {
namespace {

using flip::Filters;
using Weights = std::vector<float>;
using enum FilterSymmetry;

constexpr int flip_tile_width = 384, flip_tile_height = 64, highest_flip_tile = 512;

/// A plane of floats with as many rows as a filter needs, and row y where row y - ring_size was.
class Ring {
public:
    Ring(int ring_size, int stride)
        : mask_(ring_size - 1), stride_(stride), values_(std::size_t(ring_size) * std::size_t(stride)) {}
    float* row(int y) { return values_.data() + (y & mask_) * stride_; }

private:
    int mask_;
    std::ptrdiff_t stride_;
    AlignedFloats values_;
};

int round_up(int n, int multiple) { return (n + multiple - 1) / multiple * multiple; }

int power_of_two_from(int n) {
    int power = 1;
    while (power < n) power *= 2;
    return power;
}

/// The filters of a picture for one tile: rows in, colours and features of whole neighbourhoods out.
class Filtered {
public:
    // A block may reach beyond the tile; what it reads there is 0 and what it gives is dropped.
    Filtered(const Display& display, const Filters& filters, int x0, int width)
        : display_(display),
          filters_(filters),
          x0_(x0),
          width_(width),
          radius_(filters.radius()),
          source_stride_(round_up(round_up(width, row_block) + 2 * radius_, row_block)),
          source_(6 * std::size_t(source_stride_)),
          bytes_(3 * std::size_t(source_stride_)),
          result_stride_(round_up(width, row_block)),
          results_(std::size_t(results * rows_at_once * result_stride_)),
          rows_(2 * std::size_t(radius_) + rows_at_once) {
        for (int plane = 0; plane < planes; ++plane)
            across_.emplace_back(power_of_two_from(2 * radius_ + rows_at_once), round_up(width, row_block));
    }

    /// Takes in row y. Row y can be asked for once the rows y - radius to y + radius were added, in order.
    void add_row(int y) {
        float *red = source(0), *green = source(1), *blue = source(2);
        float *lightness = source(3), *red_green = source(4), *blue_yellow = source(5);
        const int count = width_ + 2 * radius_;
        if (const std::uint8_t* row = display_.bytes_row(x0_ - radius_, y, count)) {  // most pictures
            flip::opponent_colors_of_bytes(with_edges(row), count, {lightness, red_green, blue_yellow});
        } else {
            display_.linear_row(x0_ - radius_, y, count, red, green, blue);
            flip::opponent_colors({red, green, blue}, count, {lightness, red_green, blue_yellow});
        }
        filter_rows(even, filters_.lightness, beside(lightness, filters_.lightness), width_, plane(eye_lightness, y));
        filter_rows(even, filters_.red_green, beside(red_green, filters_.red_green), width_, plane(eye_red_green, y));
        filter_rows_even_even(filters_.blue_yellow_1, filters_.blue_yellow_2,
                              beside(blue_yellow, filters_.blue_yellow_1), width_, plane(eye_blue_yellow_1, y),
                              plane(eye_blue_yellow_2, y));
        filter_rows_even_odd_even(filters_.smooth, filters_.slope, filters_.bend, beside(lightness, filters_.smooth),
                                  width_, plane(smooth, y), plane(slope, y), plane(bend, y));
    }

    /// Prepares what color(), edge() and point() tell of the rows y to y + rows_at_once - 1.
    void go_to_rows(int y) {
        columns(eye_lightness, filters_.lightness, y, color_1);
        columns(eye_red_green, filters_.red_green, y, color_2);
        columns(eye_blue_yellow_1, filters_.blue_yellow_1, y, color_3);
        columns(eye_blue_yellow_2, filters_.blue_yellow_2, y, color_3, true);
        columns(slope, filters_.smooth, y, edge_x);
        columns(bend, filters_.smooth, y, point_x);
        for (int o = 0; o < rows_at_once; ++o)
            filter_rows_odd_even(filters_.slope, filters_.bend, around(smooth, y + o, filters_.slope, 1), width_,
                                 result(edge_y, o), result(point_y, o));
        flip::seen_colors({result(color_1), result(color_2), result(color_3)}, rows_at_once * int(result_stride_));
    }

    /// The row y + o.
    flip::SeenRow row(int o) {
        return {{result(color_1, o), result(color_2, o), result(color_3, o)},
                result(edge_x, o), result(edge_y, o), result(point_x, o), result(point_y, o)};
    }

private:
    enum Plane { eye_lightness, eye_red_green, eye_blue_yellow_1, eye_blue_yellow_2, smooth, slope, bend, planes };
    enum Result { color_1, color_2, color_3, edge_x, edge_y, point_x, point_y, results };

    /// The pixels of the tile and `radius` more on both sides, of a row of the picture, whose edges are repeated.
    const std::uint8_t* with_edges(const std::uint8_t* row) {
        const int first = x0_ - radius_, count = width_ + 2 * radius_, picture = display_.width();
        const int left = std::clamp(-first, 0, count), right = std::clamp(picture - first, left, count);
        if (left == 0 && right == count && first + round_up(count, 4) <= picture) return row + 3 * first;
        std::uint8_t* out = bytes_.data();
        for (int i = 0; i < left; ++i) out = std::copy_n(row, 3, out);
        out = std::copy_n(row + 3 * (first + left), 3 * (right - left), out);
        for (int i = right; i < count; ++i) out = std::copy_n(row + 3 * (picture - 1), 3, out);
        return bytes_.data();
    }
    float* source(int plane) { return source_.data() + plane * source_stride_; }
    float* plane(Plane which, int y) { return across_[which].row(y); }
    float* result(Result which, int o = 0) { return results_.data() + (which * rows_at_once + o) * result_stride_; }

    /// A row at the places that a filter along x looks at.
    const float* const* beside(const float* from, const Weights& weights) {
        const int radius = int(weights.size()) - 1;
        for (int k = -radius; k <= radius; ++k) rows_[std::size_t(radius + k)] = from + radius_ + k;
        return rows_.data();
    }
    /// The rows that a filter along y looks at, for so many rows of the picture.
    const float* const* around(Plane which, int y, const Weights& weights, int count) {
        const int radius = int(weights.size()) - 1;
        for (int k = -radius; k < radius + count; ++k) rows_[std::size_t(radius + k)] = across_[which].row(y + k);
        return rows_.data();
    }
    void columns(Plane from, const Weights& weights, int y, Result to, bool add = false) {
        float* out[rows_at_once];
        for (int o = 0; o < rows_at_once; ++o) out[o] = result(to, o);
        filter_columns(weights, around(from, y, weights, rows_at_once), width_, out, add);
    }

    const Display& display_;
    const Filters& filters_;
    int x0_, width_, radius_;
    std::ptrdiff_t source_stride_;
    AlignedFloats source_;  ///< planes of one row, with `radius` more pixels on both sides
    std::vector<std::uint8_t> bytes_;
    std::vector<Ring> across_;   ///< for each Plane, rows filtered along x
    std::ptrdiff_t result_stride_;
    AlignedFloats results_;  ///< for each Result, rows_at_once rows of the picture
    std::vector<const float*> rows_;
};

struct FlipTile {
    int x0, y0, y1;
};

/// Hands each row of errors to take(x0, y, count, errors).
template <class Take>
void find_errors(const Display& expected_display, const Display& actual_display, const Filters& filters,
                 const FlipTile& tile, const Take& take) {
    const int width = std::min(flip_tile_width, expected_display.width() - tile.x0);
    const int y1 = std::min(tile.y1, expected_display.height());
    const int radius = filters.radius();
    Filtered expected(expected_display, filters, tile.x0, width), actual(actual_display, filters, tile.x0, width);
    const std::size_t room = std::size_t(round_up(width, row_block));
    AlignedFloats errors(room), scratch(2 * room);
    int added = tile.y0 - radius;
    for (int y = tile.y0; y < y1; y += rows_at_once) {
        for (; added < y + rows_at_once + radius; ++added) expected.add_row(added), actual.add_row(added);
        expected.go_to_rows(y);
        actual.go_to_rows(y);
        for (int o = 0; o < std::min(rows_at_once, y1 - y); ++o) {
            flip::errors_between(expected.row(o), actual.row(o), width, errors.data(), scratch.data());
            take(tile.x0, y + o, width, errors.data());
        }
    }
}

/// Where errors are to be found. Tiles one below the other become one, up to a limit: each has to filter `radius` rows
/// more at both its ends.
std::vector<FlipTile> tiles_of(int width, int height, const DifferingCells& cells, int radius) {
    std::vector<FlipTile> all_tiles;
    for (int x = 0; x < width; x += flip_tile_width)
        for (int y = 0; y < height; y += flip_tile_height) {
            if (!cells.any_in(x - radius, y - radius, x + flip_tile_width + radius, y + flip_tile_height + radius))
                continue;
            const bool grows = !all_tiles.empty() && all_tiles.back().x0 == x && all_tiles.back().y1 == y &&
                               y - all_tiles.back().y0 < highest_flip_tile;
            if (grows)
                all_tiles.back().y1 += flip_tile_height;
            else
                all_tiles.push_back({x, y, y + flip_tile_height});
        }
    return all_tiles;
}

void fill_map(const AnyImage& expected_image, const AnyImage& actual_image, const DifferingCells& cells,
              const Filters& filters, float background, ImageF& map) {
    const Display expected(expected_image, background), actual(actual_image, background);
    const std::vector<FlipTile> all_tiles = tiles_of(map.width, map.height, cells, filters.radius());
    tiles::parallel_for(all_tiles.size(), [&](std::size_t i) {
        find_errors(expected, actual, filters, all_tiles[i], [&](int x0, int y, int count, const float* errors) {
            float* out = map.pixel(x0, y);
            // Over two backgrounds, the larger error stays.
            for (int k = 0; k < count; ++k) out[k] = max(errors[k], out[k]);
        });
    });
}

}  // namespace

ImageF flip_map(const AnyImage& expected, const AnyImage& actual, const DifferingCells& cells,
                float pixels_per_degree) {
    const Filters filters(pixels_per_degree);
    ImageF map;
    std::visit([&](const auto& held) { map.width = held.width, map.height = held.height, map.channels = 1; }, expected);
    resize_whole(map.samples, std::size_t(map.width) * std::size_t(map.height));
    fill_map(expected, actual, cells, filters, 0.0f, map);
    if (has_transparency(expected) || has_transparency(actual))
        fill_map(expected, actual, cells, filters, 1.0f, map);
    return map;
}

std::optional<double> flip_mean(const AnyImage& expected_image, const AnyImage& actual_image,
                                const DifferingCells& cells, float pixels_per_degree, Image8* steps) {
    if (has_transparency(expected_image) || has_transparency(actual_image)) return std::nullopt;
    const Filters filters(pixels_per_degree);
    const Display expected(expected_image, 0.0f), actual(actual_image, 0.0f);
    const int width = expected.width(), height = expected.height();
    if (steps != nullptr) {
        steps->width = width, steps->height = height, steps->channels = 1;
        resize_whole(steps->samples, std::size_t(width) * std::size_t(height));
    }

    // mean_of adds up each row in eight parts from left to right. If all of a row's errors are whole multiples of one
    // power of two, and no part can have more than the 53 bits of a double, its parts are exact, in any order. An error
    // has 24 bits; so it may have 30 - b leading zeros where a part has up to 2^b of them.
    constexpr std::size_t parts = sum_parts;
    static_assert(flip_tile_width % parts == 0);
    const int most_in_part = (width + int(parts) - 1) / int(parts);
    float least = 0x1p-30f;
    for (int n = 1; n < most_in_part; n *= 2) least *= 2;

    using Sums = std::array<double, parts>;
    const std::vector<FlipTile> all_tiles = tiles_of(width, height, cells, filters.radius());
    std::vector<std::vector<Sums>> sums_of(all_tiles.size());
    std::atomic<bool> exact = true;
    tiles::parallel_for(all_tiles.size(), [&](std::size_t i) {
        const FlipTile& tile = all_tiles[i];
        std::vector<Sums>& sums = sums_of[i];
        sums.resize(std::size_t(std::min(tile.y1, height) - tile.y0));
        std::array<std::uint8_t, flip_tile_width> step;
        find_errors(expected, actual, filters, tile, [&](int x0, int y, int count, float* errors) {
            if (!add_in_parts(errors, count, least, sums[std::size_t(y - tile.y0)].data())) exact = false;
            if (steps == nullptr) return;
            flip::steps_of_errors(errors, count, step.data());
            std::copy_n(step.begin(), count, steps->pixel(x0, y));
        });
    });
    if (!exact) return std::nullopt;
    std::vector<Sums> rows(std::size_t(height), Sums{});
    for (std::size_t i = 0; i < all_tiles.size(); ++i)
        for (std::size_t row = 0; row < sums_of[i].size(); ++row)
            for (std::size_t part = 0; part < parts; ++part)
                rows[std::size_t(all_tiles[i].y0) + row][part] += sums_of[i][row][part];
    double sum = 0;
    for (const Sums& row : rows) sum += std::accumulate(row.begin(), row.end(), 0.0);
    return sum / double(std::int64_t(width) * height);
}

}  // namespace raster
