// diff_regions.cpp: groups pixels that fail into regions, so that a reader is led to each place once.
#include <raster/image/diff_steps.h>

#include <algorithm>
#include <numeric>

#include <raster/tiles/parallel.h>

namespace raster::diff_steps {
namespace {

constexpr int cell = 16;  // pixels in cells that touch belong together
constexpr std::size_t most_regions = 64;

struct Cells {
    int columns, rows;
    std::vector<DiffRegion> region;  ///< of each cell; pixels == 0 where none fails

    Cells(const ImageF& deltas, float limit)
        : columns((deltas.width + cell - 1) / cell),
          rows((deltas.height + cell - 1) / cell),
          region(std::size_t(columns) * std::size_t(rows)) {
        tiles::parallel_for(std::size_t(rows), [&](std::size_t row) {
            // By columns of pixels first, which needs no decisions.
            const std::size_t width = std::size_t(deltas.width);
            std::vector<float> most(width);
            std::vector<int> counts(width);
            for (int y = int(row) * cell; y < std::min(int(row + 1) * cell, deltas.height); ++y) {
                const float* const delta = deltas.pixel(0, y);
                for (std::size_t x = 0; x < width; ++x) most[x] = delta[x] > most[x] ? delta[x] : most[x];
                for (std::size_t x = 0; x < width; ++x) counts[x] += delta[x] > limit;
            }
            for (int column = 0; column < columns; ++column)
                describe(deltas, limit, most.data(), counts.data(), column, int(row));
        });
    }
    /// What a cell has, by the largest delta and the count of pixels that fail in each column of pixels.
    void describe(const ImageF& deltas, float limit, const float* most, const int* counts, int column, int row) {
        const int x0 = column * cell, x1 = std::min(x0 + cell, deltas.width);
        const int y0 = row * cell, y1 = std::min(y0 + cell, deltas.height);
        const int pixels = std::accumulate(counts + x0, counts + x1, 0);
        if (pixels == 0) return;
        int left = x0, right = x1 - 1, top = y0, bottom = y1 - 1;
        while (counts[left] == 0) ++left;
        while (counts[right] == 0) --right;
        const auto fails_in = [&](int y) {
            return std::any_of(deltas.pixel(left, y), deltas.pixel(right, y) + 1, [&](float d) { return d > limit; });
        };
        while (!fails_in(top)) ++top;
        while (!fails_in(bottom)) --bottom;
        const float largest = *std::max_element(most + left, most + right + 1);
        for (int y = top; y <= bottom; ++y) {
            const float* const end = deltas.pixel(right, y) + 1;
            const float* const found = std::find(deltas.pixel(left, y), end, largest);
            if (found == end) continue;
            const int x = int(found - deltas.pixel(0, y));
            at(column, row) = {{left, top, right - left + 1, bottom - top + 1}, pixels, largest, x, y};
            return;
        }
    }
    DiffRegion& at(int column, int row) {
        return region[std::size_t(row) * std::size_t(columns) + std::size_t(column)];
    }

    static void merge(DiffRegion& into, const DiffRegion& other) {
        if (into.pixels == 0) {
            into = other;
            return;
        }
        const int x1 = std::max(into.box.x + into.box.width, other.box.x + other.box.width);
        const int y1 = std::max(into.box.y + into.box.height, other.box.y + other.box.height);
        into.box.x = std::min(into.box.x, other.box.x), into.box.y = std::min(into.box.y, other.box.y);
        into.box.width = x1 - into.box.x, into.box.height = y1 - into.box.y;
        into.pixels += other.pixels;
        if (other.max_delta > into.max_delta)
            into.max_delta = other.max_delta, into.max_x = other.max_x, into.max_y = other.max_y;
    }
};

/// Cells that belong together name the same root; the first of them in reading order.
class Groups {
public:
    explicit Groups(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), std::size_t(0)); }
    std::size_t root(std::size_t i) {
        while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
        return i;
    }
    void join(std::size_t a, std::size_t b) {
        a = root(a), b = root(b);
        parent_[std::max(a, b)] = std::min(a, b);
    }

private:
    std::vector<std::size_t> parent_;
};

}  // namespace

void find_regions(Diff& diff) {
    if (!diff.figures || diff.figures->differing == 0) return;
    const float limit = diff.figures->failing > 0 ? diff.allowed_delta : 0.0f;
    Cells cells(diff.deltas, limit);
    Groups groups(cells.region.size());
    const auto index = [&](int column, int row) {
        return std::size_t(row) * std::size_t(cells.columns) + std::size_t(column);
    };
    for (int row = 0; row < cells.rows; ++row)
        for (int column = 0; column < cells.columns; ++column) {
            if (cells.at(column, row).pixels == 0) continue;
            // The neighbours that came before.
            for (const auto& [dx, dy] : {std::pair(-1, 0), {-1, -1}, {0, -1}, {1, -1}}) {
                const int x = column + dx, y = row + dy;
                if (x >= 0 && x < cells.columns && y >= 0 && cells.at(x, y).pixels > 0)
                    groups.join(index(column, row), index(x, y));
            }
        }
    for (std::size_t i = 0; i < cells.region.size(); ++i)
        if (cells.region[i].pixels > 0 && groups.root(i) != i) {
            Cells::merge(cells.region[groups.root(i)], cells.region[i]);
            cells.region[i].pixels = 0;
        }
    for (const DiffRegion& region : cells.region)
        if (region.pixels > 0) diff.regions.push_back(region);
    diff.region_count = std::int64_t(diff.regions.size());
    std::stable_sort(diff.regions.begin(), diff.regions.end(),
                     [](const DiffRegion& a, const DiffRegion& b) { return a.pixels > b.pixels; });
    if (diff.regions.size() > most_regions) diff.regions.resize(most_regions);
}

}  // namespace raster::diff_steps
