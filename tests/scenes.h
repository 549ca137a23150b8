// scenes.h: seeded triangles of the kinds that rasterizers get wrong, and small helpers to draw them.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include <glm/glm.hpp>

#include "random.h"

namespace raster::testing {

/// What a triangle is made to test. The last four are beyond what programs draw: slivers across the volume's border;
/// corners on one line before snapping; numbers up to 1e4, NaN and w = 0; all that floats can be.
enum class Group {
    big,
    perspective,
    small,
    slivers,
    half_pixel_grid,
    ties,
    axis_aligned,
    clip_near,
    clip_far,
    clip_sides,
    clip_all,
    clip_slivers,
    collinear,
    huge,
    wild,
};
inline constexpr int group_count = int(Group::wild) + 1;
inline constexpr std::array<const char*, group_count> group_names = {
    "big",      "perspective", "small",    "slivers",      "half_pixel_grid", "ties", "axis_aligned", "clip_near",
    "clip_far", "clip_sides",  "clip_all", "clip_slivers", "collinear",       "huge", "wild"};
inline std::string name(Group group) { return group_names[std::size_t(group)]; }

/// The clip position whose window position is (x, y) in pixels from the top left. Exact for sizes that are powers of
/// two and positions on a grid.
inline glm::vec4 clip_at(float x, float y, float ndc_z, float w, int width, int height) {
    return glm::vec4(x * 2.0f / float(width) - 1.0f, 1.0f - y * 2.0f / float(height), ndc_z, 1.0f) * w;
}

/// The seed of a test: always the same, unless the environment variable RASTER_SEED asks for fresh ones.
inline std::uint64_t seed(std::uint64_t test) {
    const char* fresh = std::getenv("RASTER_SEED");
    return test + (fresh ? 1000003 * std::strtoull(fresh, nullptr, 10) : 0);
}

using Corners = std::array<glm::vec4, 3>;

/// One triangle for a viewport of this size.
inline Corners make_triangle(Group group, Random& random, int width, int height) {
    const auto u = [&](float low, float high) { return random.uniform(low, high); };
    const auto on_grid = [&](int steps, float z, float w) {
        const float x = float(random.integer(0, width * steps)) / float(steps);
        const float y = float(random.integer(0, height * steps)) / float(steps);
        return clip_at(x, y, z, w, width, height);
    };
    Corners corners;
    const auto each = [&](const auto& make) {
        for (auto& corner : corners) corner = make();
    };
    const auto box = [&](float xy, float near, float far, float w_low, float w_high) {
        each([&] {
            const float x = u(-xy, xy), y = u(-xy, xy), z = u(near, far), w = u(w_low, w_high);
            return glm::vec4(x, y, z, 1.0f) * w;
        });
    };
    const auto sliver = [&](float border) {
        const float w = float(width), h = float(height), x_low = -border * w, x_high = w - x_low;
        const float y_low = -border * h, y_high = h - y_low;
        const float x0 = u(x_low, x_high), y0 = u(y_low, y_high), x1 = u(x_low, x_high), y1 = u(y_low, y_high);
        const float t = u(0, 1), thick = u(0, 1);
        const float x2 = x0 + (x1 - x0) * t + u(-thick, thick), y2 = y0 + (y1 - y0) * t + u(-thick, thick);
        corners = {clip_at(x0, y0, u(-1, 1), 1, width, height), clip_at(x1, y1, u(-1, 1), 1, width, height),
                   clip_at(x2, y2, u(-1, 1), 1, width, height)};
    };
    switch (group) {
        case Group::big: box(1, -1, 1, 1, 1); break;
        case Group::perspective: box(1, -1, 1, 0.25f, 8); break;
        case Group::small: {
            const float x = u(0, float(width)), y = u(0, float(height)), size = u(0.2f, 4);
            each([&] {
                const float dx = u(-size, size), dy = u(-size, size), z = u(-1, 1);
                return clip_at(x + dx, y + dy, z, 1, width, height);
            });
            break;
        }
        case Group::slivers: sliver(0); break;
        case Group::clip_slivers: sliver(0.5f); break;
        case Group::collinear: {
            const auto step = [&](int range) { return float(random.integer(-range, range)) / 1024.0f; };
            const float x = u(0, float(width)), y = u(0, float(height)), dx = step(20000), dy = step(20000);
            const float t = float(random.integer(0, 8)) / 8.0f;
            corners = {clip_at(x, y, u(-1, 1), 1, width, height), clip_at(x + dx, y + dy, u(-1, 1), 1, width, height),
                       clip_at(x + t * dx, y + t * dy, u(-1, 1), 1, width, height)};
            break;
        }
        case Group::half_pixel_grid: each([&] { return on_grid(2, u(-1, 1), 1); }); break;
        case Group::ties: {
            const int x = random.integer(0, width * 512), y = random.integer(0, height * 512);
            const int size = 512 << random.integer(0, 7);
            each([&] {
                const int dx = random.integer(-size, size), dy = random.integer(-size, size);
                return clip_at(float(x + dx) / 512.0f, float(y + dy) / 512.0f, u(-1, 1), 1, width, height);
            });
            break;
        }
        case Group::axis_aligned: {
            const int steps = random.integer(0, 1) ? 1 : 2;
            const glm::vec4 a = on_grid(steps, u(-1, 1), 1), b = on_grid(steps, u(-1, 1), 1);
            corners = {a, glm::vec4(b.x, a.y, u(-1, 1), 1), random.integer(0, 1) ? b : glm::vec4(a.x, b.y, b.z, 1)};
            if (random.integer(0, 1)) std::swap(corners[0], corners[1]);
            break;
        }
        case Group::clip_near: box(1, -3, 1, 0.25f, 4); break;
        case Group::clip_far: box(1, -1, 3, 0.25f, 4); break;
        case Group::clip_sides: box(4, -1, 1, 0.25f, 4); break;
        case Group::clip_all:
            each([&] {
                const float x = u(-2, 2), y = u(-2, 2), z = u(-2, 2);
                return glm::vec4(x, y, z, u(-1, 2));
            });
            break;
        case Group::huge:
        case Group::wild: {
            constexpr float infinity = std::numeric_limits<float>::infinity();
            constexpr std::array odd = {0.0f,   -0.0f, 1e-20f, -1e-20f, 1e-10f,    100.0f,  -100.0f, 1e4f,
                                        -1e4f,  1.0f,  -1.0f,  NAN,     65536.0f,  1e6f,    -1e6f,   1e20f,
                                        -1e30f, 3e38f, -3e38f, 1e-40f,  -infinity, infinity};
            const int last = group == Group::huge ? 11 : 21;
            each([&] {
                glm::vec4 corner;
                for (int i = 0; i < 4; ++i) corner[i] = u(i == 3 ? 0.0f : -1.5f, 1.5f);
                if (random.integer(0, 2) == 0) corner[random.integer(0, 3)] = odd[std::size_t(random.integer(0, last))];
                return corner;
            });
            break;
        }
    }
    return corners;
}

}  // namespace raster::testing
