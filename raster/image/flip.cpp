// flip.cpp: FLIP in one pass over tiles: rows filtered along x go into rings, and are filtered along y from there.
//
// All filters of the paper are sums of products of a function of x and one of y, so that two passes of one
// dimension give what one of two would: 2 * 21 weights instead of 441.
#include <raster/image/flip.h>

#include <algorithm>
#include <utility>
#include <vector>

#include <raster/image/flip_color.h>
#include <raster/image/flip_filters.h>
#include <raster/image/metrics_display.h>
#include <raster/image/metrics_rows.h>
#include <raster/tiles/parallel.h>

namespace raster {
namespace {

using flip::Filters;
using F = FloatN;
using Weights = std::vector<float>;
using enum FilterSymmetry;

constexpr int flip_tile_width = 256, flip_tile_height = 128;

/// A plane of floats with as many rows as a filter needs, and row y where row y - ring_size was.
class Ring {
public:
    Ring(int ring_size, int stride) : mask_(ring_size - 1), stride_(stride) {
        values_.resize(std::size_t(ring_size) * std::size_t(stride));
    }
    float* row(int y) { return values_.data() + (y & mask_) * stride_; }

private:
    int mask_;
    std::ptrdiff_t stride_;
    std::vector<float> values_;
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
          source_stride_(round_up(width, row_block) + 2 * radius_ + native_lanes),
          source_(6 * std::size_t(source_stride_)),
          across_(planes, Ring(power_of_two_from(2 * radius_ + 1), round_up(width, row_block))),
          results_(results, std::vector<float>(std::size_t(round_up(width, row_block)))),
          rows_(2 * std::size_t(radius_) + 1) {}

    /// Takes in row y. Row y can be asked for once the rows y - radius to y + radius were added, in order.
    void add_row(int y) {
        float *red = source(0), *green = source(1), *blue = source(2);
        float *lightness = source(3), *red_green = source(4), *blue_yellow = source(5);
        const int count = width_ + 2 * radius_;
        display_.linear_row(x0_ - radius_, y, count, red, green, blue);
        for (int i = 0; i < count; i += native_lanes) {
            const flip::Rgb<F> rgb = {load<F>(red + i), load<F>(green + i), load<F>(blue + i)};
            const flip::Opponent<F> opponent = flip::opponent_from_rgb(rgb);
            store(lightness + i, opponent.y);
            store(red_green + i, opponent.red_green);
            store(blue_yellow + i, opponent.blue_yellow);
        }
        filter_rows(even, filters_.lightness, beside(lightness, filters_.lightness), width_, plane(eye_lightness, y));
        filter_rows(even, filters_.red_green, beside(red_green, filters_.red_green), width_, plane(eye_red_green, y));
        filter_rows_even_even(filters_.blue_yellow_1, filters_.blue_yellow_2,
                              beside(blue_yellow, filters_.blue_yellow_1), width_, plane(eye_blue_yellow_1, y),
                              plane(eye_blue_yellow_2, y));
        filter_rows_even_odd_even(filters_.smooth, filters_.slope, filters_.bend, beside(lightness, filters_.smooth),
                                  width_, plane(smooth, y), plane(slope, y), plane(bend, y));
    }

    /// Prepares what color(), edge() and point() tell of row y.
    void go_to_row(int y) {
        const auto rows = [&](Plane from, const Weights& weights) { return around(from, y, weights); };
        filter_rows(even, filters_.lightness, rows(eye_lightness, filters_.lightness), width_, result(color_1));
        filter_rows(even, filters_.red_green, rows(eye_red_green, filters_.red_green), width_, result(color_2));
        filter_rows(even, filters_.blue_yellow_1, rows(eye_blue_yellow_1, filters_.blue_yellow_1), width_, result(color_3));
        filter_rows(even, filters_.blue_yellow_2, rows(eye_blue_yellow_2, filters_.blue_yellow_2), width_, result(color_3), true);
        filter_rows(even, filters_.smooth, rows(slope, filters_.smooth), width_, result(edge_x));
        filter_rows(even, filters_.smooth, rows(bend, filters_.smooth), width_, result(point_x));
        filter_rows_odd_even(filters_.slope, filters_.bend, rows(smooth, filters_.slope), width_, result(edge_y), result(point_y));
        find_colors();
    }

    /// What the eye makes of the colours around the pixels i, i + 1, ...
    flip::HuntLab<F> color(int i) const { return {at(color_1, i), at(color_2, i), at(color_3, i)}; }
    /// How much of an edge there is: the length of the gradient.
    F edge(int i) const { return length(at(edge_x, i), at(edge_y, i)); }
    /// How much of a point or thin line there is: the length of the second derivatives.
    F point(int i) const { return length(at(point_x, i), at(point_y, i)); }

private:
    enum Plane { eye_lightness, eye_red_green, eye_blue_yellow_1, eye_blue_yellow_2, smooth, slope, bend, planes };
    enum Result { color_1, color_2, color_3, edge_x, edge_y, point_x, point_y, results };

    static F length(F x, F y) { return sqrt(x * x + y * y); }
    F at(Result from, int i) const { return load<F>(results_[from].data() + i); }
    float* source(int plane) { return source_.data() + plane * source_stride_; }
    float* plane(Plane which, int y) { return across_[which].row(y); }
    float* result(Result which) { return results_[which].data(); }

    /// A row at the places that a filter along x looks at.
    const float* const* beside(const float* from, const Weights& weights) {
        const int radius = int(weights.size()) - 1;
        for (int k = -radius; k <= radius; ++k) rows_[std::size_t(radius + k)] = from + radius_ + k;
        return rows_.data();
    }
    /// The rows that a filter along y looks at.
    const float* const* around(Plane which, int y, const Weights& weights) {
        const int radius = int(weights.size()) - 1;
        for (int k = -radius; k <= radius; ++k) rows_[std::size_t(radius + k)] = across_[which].row(y + k);
        return rows_.data();
    }

    /// From opponent colours to colours as seen, in short loops: their steps do not wait for each other.
    void find_colors() {
        float *c1 = result(color_1), *c2 = result(color_2), *c3 = result(color_3);
        for (int i = 0; i < width_; i += native_lanes) {
            const flip::Opponent<F> seen = {at(color_1, i), at(color_2, i), at(color_3, i)};
            const flip::RelativeXyz<F> xyz = flip::xyz_from_rgb(flip::clamped_rgb_from_opponent(seen));
            store(c1 + i, xyz.x), store(c2 + i, xyz.y), store(c3 + i, xyz.z);
        }
        for (float* c : {c1, c2, c3})
            for (int i = 0; i < width_; i += native_lanes) store(c + i, flip::lab_response(load<F>(c + i)));
        for (int i = 0; i < width_; i += native_lanes) {
            const auto lab = flip::hunt_lab_from_responses(at(color_1, i), at(color_2, i), at(color_3, i));
            store(c1 + i, lab.l), store(c2 + i, lab.a), store(c3 + i, lab.b);
        }
    }

    const Display& display_;
    const Filters& filters_;
    int x0_, width_, radius_;
    std::ptrdiff_t source_stride_;
    std::vector<float> source_;                ///< planes of one row, with `radius` more pixels on both sides
    std::vector<Ring> across_;                 ///< for each Plane, rows filtered along x
    std::vector<std::vector<float>> results_;  ///< for each Result, a row of the picture
    std::vector<const float*> rows_;
};

const flip::ErrorCurve curve;

/// The errors of the row both are at (sections 4.2 and 4.3). `scratch` is as long as `errors`.
void find_errors(const Filtered& expected, const Filtered& actual, int width, float* errors, float* scratch) {
    for (int i = 0; i < width; i += native_lanes) {
        const F edges = abs(expected.edge(i) - actual.edge(i));
        const F points = abs(expected.point(i) - actual.point(i));
        const F features = sqrt(max(edges, points) * 0.707106781f);
        store(scratch + i, max(F(1.0f) - features, 0.0f));
        store(errors + i, flip::hyab(expected.color(i), actual.color(i)));
    }
    for (int i = 0; i < width; i += native_lanes)
        store(errors + i, curve.to_power<F>(load<F>(errors + i), load<F>(scratch + i)));
}

void fill_tile(const Display& expected_display, const Display& actual_display, const Filters& filters, int x0, int y0,
               ImageF& map) {
    const int width = std::min(flip_tile_width, map.width - x0), y1 = std::min(y0 + flip_tile_height, map.height);
    const int radius = filters.radius();
    Filtered expected(expected_display, filters, x0, width), actual(actual_display, filters, x0, width);
    std::vector<float> errors(std::size_t(round_up(width, native_lanes))), scratch(errors.size());
    for (int y = y0 - radius; y < y1 + radius; ++y) {
        expected.add_row(y);
        actual.add_row(y);
        const int center = y - radius;
        if (center < y0) continue;
        expected.go_to_row(center);
        actual.go_to_row(center);
        find_errors(expected, actual, width, errors.data(), scratch.data());
        float* out = map.pixel(x0, center);
        // Over two backgrounds, the larger error stays.
        for (int i = 0; i < width; ++i) out[i] = max(errors[std::size_t(i)], out[i]);
    }
}

void add_errors(const AnyImage& expected_image, const AnyImage& actual_image, const DifferingCells& cells,
                const Filters& filters, float background, ImageF& map) {
    const Display expected(expected_image, background), actual(actual_image, background);
    const int radius = filters.radius();
    std::vector<std::pair<int, int>> corners;
    for (int y = 0; y < map.height; y += flip_tile_height)
        for (int x = 0; x < map.width; x += flip_tile_width)
            if (cells.any_in(x - radius, y - radius, x + flip_tile_width + radius, y + flip_tile_height + radius))
                corners.emplace_back(x, y);
    tiles::parallel_for(corners.size(), [&](std::size_t i) {
        fill_tile(expected, actual, filters, corners[i].first, corners[i].second, map);
    });
}

}  // namespace

ImageF flip_map(const AnyImage& expected, const AnyImage& actual, const DifferingCells& cells,
                float pixels_per_degree) {
    const Filters filters(pixels_per_degree);
    ImageF map = std::visit([](const auto& held) { return ImageF(held.width, held.height, 1); }, expected);
    add_errors(expected, actual, cells, filters, 0.0f, map);
    if (has_transparency(expected) || has_transparency(actual))
        add_errors(expected, actual, cells, filters, 1.0f, map);
    return map;
}

}  // namespace raster
