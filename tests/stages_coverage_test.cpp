// Stage 7: which pixel centres are covered; a shared edge is covered once.
#include <raster/stages/coverage.h>

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "random.h"

namespace {

using namespace raster;
using raster::testing::Random;
using Point = SubpixelVertex<float>;
using Triangle = std::array<Point, 3>;

constexpr int size = 24;
constexpr std::array rules = {FillRule::bottom_left, FillRule::top_left};

/// Adds one to each pixel that the triangle covers.
void cover(std::vector<int>& counts, Triangle t, FillRule rule) {
    const std::int64_t area = signed_area(t);
    if (area == 0) return;
    if (area < 0) std::swap(t[0], t[1]);
    const PixelBox box = bounding_pixels(t, size, size);
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x) {
            bool inside = true;
            for (std::size_t i = 0; i < 3; ++i) {
                const auto e = make_edge(t[i], t[(i + 1) % 3], rule);
                const bool in = is_inside(e, edge_at(e, x, y));
                ASSERT_EQ(in, pixel_origin(e) + std::int64_t(e.step_x) * x + std::int64_t(e.step_y) * y >= 0);
                inside = inside && in;
            }
            if (inside) {
                ASSERT_TRUE(x >= box.min_x && x <= box.max_x && y >= box.min_y && y <= box.max_y);
                ++counts[std::size_t(y * size + x)];
            }
        }
}
std::vector<int> covered(const Triangle& t, FillRule rule) {
    std::vector<int> counts(size * size);
    cover(counts, t, rule);
    return counts;
}
/// The upper left corner of a picture, a line a row.
std::string drawing(const std::vector<int>& counts, int columns, int rows) {
    std::string text;
    for (int y = 0; y < rows; ++y, text += '\n')
        for (int x = 0; x < columns; ++x) text += counts[std::size_t(y * size + x)] ? '#' : '.';
    return text;
}
Point centre(int x, int y) { return {x * subpixels, y * subpixels}; }
/// Points of which many lie on pixel centres, edges through centres included.
Point coarse_point(Random& random) {
    const int grid = random.integer(0, 2) ? 256 : 64;
    const int x = random.integer(0, size * 256 / grid);
    return {x * grid, random.integer(0, size * 256 / grid) * grid};
}

TEST(Coverage, ASmallTriangleWithCornersOnCentres) {
    // Left edge x = 1, bottom edge y = 4, and the diagonal between them, which is a right edge.
    const Triangle t = {{centre(1, 1), centre(1, 4), centre(4, 4)}};
    EXPECT_EQ(drawing(covered(t, FillRule::bottom_left), 6, 6), "......\n......\n.#....\n.##...\n.###..\n......\n");
    EXPECT_EQ(drawing(covered(t, FillRule::top_left), 6, 6), "......\n......\n.#....\n.##...\n......\n......\n");
}

TEST(Coverage, ARectangleOnCentresKeepsTheBordersOfItsRule) {
    const Triangle a = {{centre(1, 1), centre(1, 4), centre(5, 4)}}, b = {{centre(1, 1), centre(5, 4), centre(5, 1)}};
    for (const auto rule : rules) {
        std::vector<int> counts(size * size);
        cover(counts, a, rule);
        cover(counts, b, rule);
        const bool bottom = rule == FillRule::bottom_left;
        EXPECT_EQ(drawing(counts, 7, 6), bottom ? ".......\n.......\n.####..\n.####..\n.####..\n.......\n"
                                                : ".......\n.####..\n.####..\n.####..\n.......\n.......\n");
        for (const int count : counts) EXPECT_LE(count, 1);
    }
}

TEST(Coverage, ATriangleBetweenCentresCoversNothing) {
    EXPECT_EQ(drawing(covered({{{10, 10}, {10, 240}, {240, 240}}}, FillRule::bottom_left), 2, 2), "..\n..\n");
}

TEST(Coverage, RotatingOrReversingTheCornersChangesNothing) {
    Random random(1);
    for (int round = 0; round < 1000; ++round) {
        const Triangle t = {{coarse_point(random), coarse_point(random), coarse_point(random)}};
        for (const auto rule : rules) {
            const auto first = covered(t, rule);
            ASSERT_EQ(covered({{t[1], t[2], t[0]}}, rule), first);
            ASSERT_EQ(covered({{t[2], t[0], t[1]}}, rule), first);
            ASSERT_EQ(covered({{t[2], t[1], t[0]}}, rule), first);
        }
    }
}

TEST(Coverage, ASharedEdgeIsCoveredOnce) {
    // A convex quadrilateral, cut along either diagonal, covers the same pixels, each once.
    Random random(2);
    int checked = 0;
    for (int round = 0; round < 20000 && checked < 1500; ++round) {
        const Point q[4] = {coarse_point(random), coarse_point(random), coarse_point(random), coarse_point(random)};
        bool convex = true;
        for (std::size_t i = 0; i < 4; ++i)
            convex = convex && signed_area({{q[i], q[(i + 1) % 4], q[(i + 2) % 4]}}) > 0;
        if (!convex) continue;
        ++checked;
        for (const auto rule : rules) {
            std::vector<int> one(size * size), other(size * size);
            cover(one, {{q[0], q[1], q[2]}}, rule), cover(one, {{q[0], q[2], q[3]}}, rule);
            cover(other, {{q[1], q[2], q[3]}}, rule), cover(other, {{q[1], q[3], q[0]}}, rule);
            ASSERT_EQ(one, other);
            for (const int count : one) ASSERT_LE(count, 1);
        }
    }
    EXPECT_EQ(checked, 1500);
}

TEST(Coverage, AMeshWithoutHolesCoversEveryPixelOnce) {
    // A grid of quadrilaterals with shaken corners, all over the picture and beyond.
    Random random(3);
    for (int round = 0; round < 60; ++round) {
        constexpr int n = 7;
        Point grid[n + 1][n + 1];
        for (int y = 0; y <= n; ++y)
            for (int x = 0; x <= n; ++x) {
                const auto place = [&](int i) {
                    const int base = (size + 4) * 256 * i / n - 2 * 256;
                    return round % 2 ? base / 256 * 256 : base + random.integer(-300, 300);
                };
                grid[y][x].x = place(x), grid[y][x].y = place(y);
            }
        for (const auto rule : rules) {
            std::vector<int> counts(size * size);
            for (int y = 0; y < n; ++y)
                for (int x = 0; x < n; ++x) {
                    const Point &a = grid[y][x], &b = grid[y][x + 1], &c = grid[y + 1][x + 1], &d = grid[y + 1][x];
                    if (random.integer(0, 1))
                        cover(counts, {{a, d, c}}, rule), cover(counts, {{a, c, b}}, rule);
                    else
                        cover(counts, {{d, c, b}}, rule), cover(counts, {{a, d, b}}, rule);
                }
            for (const int count : counts) ASSERT_EQ(count, 1) << round;
        }
    }
}

TEST(Coverage, AFanCoversEveryPixelOfItsPolygonOnce) {
    // The corners of a regular polygon around a moving centre: the centre must not matter.
    Random random(4);
    for (int round = 0; round < 200; ++round) {
        constexpr int octagon[8][2] = {{3, 0}, {2, 2}, {0, 3}, {-2, 2}, {-3, 0}, {-2, -2}, {0, -3}, {2, -2}};
        const Point around = coarse_point(random);
        const int scale = round % 2 ? 256 : random.integer(100, 700);
        for (const auto rule : rules) {
            std::vector<int> first;
            for (int hub = 0; hub < 4; ++hub) {
                std::vector<int> counts(size * size);
                const Point middle = {around.x + random.integer(-scale, scale),
                                      around.y + random.integer(-scale, scale)};
                for (int i = 0; i < 8; ++i) {
                    const auto rim = [&](int k) {
                        return Point{around.x + octagon[k % 8][0] * scale, around.y + octagon[k % 8][1] * scale};
                    };
                    cover(counts, {{middle, rim(i), rim(i + 1)}}, rule);
                }
                for (const int count : counts) ASSERT_LE(count, 1);
                if (hub == 0) first = counts;
                ASSERT_EQ(counts, first);
            }
        }
    }
}

/// The rule told another way: bottom-left is the strict inside of a point moved a little to the right and much less up.
TEST(Coverage, TiesFallAsIfTheCentreWereMoved) {
    Random random(5);
    for (int round = 0; round < 3000; ++round) {
        Triangle t = {{coarse_point(random), coarse_point(random), coarse_point(random)}};
        if (signed_area(t) == 0) continue;
        if (signed_area(t) < 0) std::swap(t[0], t[1]);
        for (const auto rule : rules) {
            const auto counts = covered(t, rule);
            for (int y = 0; y < size; ++y)
                for (int x = 0; x < size; ++x) {
                    constexpr std::int64_t fine = std::int64_t(1) << 30, right = 1 << 14;
                    const std::int64_t up = rule == FillRule::bottom_left ? 1 : -1;
                    bool inside = true;
                    for (std::size_t i = 0; i < 3; ++i) {
                        const Point &a = t[i], &b = t[(i + 1) % 3];
                        const std::int64_t px = (x * 256 - a.x) * fine + right, py = (y * 256 - a.y) * fine - up;
                        inside = inside && (b.y - a.y) * px - (b.x - a.x) * py > 0;
                    }
                    ASSERT_EQ(counts[std::size_t(y * size + x)], int(inside));
                }
        }
    }
}

TEST(Coverage, TheLargestEdgesAreExact) {
    constexpr std::int32_t far = 24576 * 256;
    const auto e = make_edge<float>({-far, -far}, {far, far - 1}, FillRule::bottom_left);
    // b - a is (2 far, 2 far - 1); at pixel (16383, 16383) the cross product is exact in 64 bits.
    const std::int64_t p = 16383 * 256 + std::int64_t(far);
    EXPECT_EQ(edge_at(e, 16383, 16383), (2 * std::int64_t(far) - 1) * p - 2 * std::int64_t(far) * p);
}

}  // namespace
