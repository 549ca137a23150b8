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
            for (int y = int(row) * cell; y < std::min(int(row + 1) * cell, deltas.height); ++y)
                for (int column = 0; column < columns; ++column) add_piece(deltas, limit, column, y);
        });
    }
    /// What row y has in a column of cells.
    void add_piece(const ImageF& deltas, float limit, int column, int y) {
        const int x0 = column * cell, x1 = std::min(x0 + cell, deltas.width);
        const float* delta = deltas.pixel(0, y);
        int count = 0;
        for (int x = x0; x < x1; ++x) count += delta[x] > limit;
        if (count == 0) return;
        int first = x0, last = x1 - 1;
        while (!(delta[first] > limit)) ++first;
        while (!(delta[last] > limit)) --last;
        float most = 0;
        for (int x = x0; x < x1; ++x) most = delta[x] > most ? delta[x] : most;
        const int largest = int(std::find(delta + x0, delta + x1, most) - delta);
        merge(at(column, y / cell), {{first, y, last - first + 1, 1}, count, delta[largest], largest, y});
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
