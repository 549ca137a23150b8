// point.h: aliased points: squares of whole widths (OpenGL 2.1, 3.3.1).
#pragma once

#include <algorithm>

#include <raster/stages/line.h>

namespace raster {

/// The pixels of a point, cut at the target. `size` is rounded to whole pixels, halves down, 1 and more. With odd sizes
/// the point's own pixel is in the middle; with even ones the nearest pixel corner. A position on the border of two
/// rows belongs to the upper one under the bottom-left rule, else to the lower one.
inline PixelBox point_pixels(const WindowVertex<float>& v, float size, FillRule rule, int width, int height) {
    const auto to_grid = [](float x) {
        const float scaled = x * float(subpixels);
        return truncate_to_int(scaled >= 0 ? scaled + 0.5f : scaled - 0.5f);
    };
    const std::int32_t x = to_grid(v.x), y = to_grid(v.y) - (rule == FillRule::bottom_left ? 1 : 0);
    const std::int32_t pixels = std::max((to_grid(size) + subpixels / 2 - 1) >> subpixel_bits, 1);
    const bool odd = pixels & 1;
    const auto first = [&](std::int32_t at) {
        return odd ? (at >> subpixel_bits) - (pixels - 1) / 2 : ((at + subpixels / 2) >> subpixel_bits) - pixels / 2;
    };
    const int x0 = first(x), y0 = first(y);
    return {std::max(x0, 0), std::max(y0, 0), std::min(x0 + pixels - 1, width - 1),
            std::min(y0 + pixels - 1, height - 1)};
}

/// A point is clipped by its centre alone: all of it or nothing.
inline bool is_point_visible(const glm::vec4& clip, UserPlanes user = {}) {
    return is_finite(clip) && (outcode(clip) | user_outcode(user, clip)) == 0;
}

}  // namespace raster
