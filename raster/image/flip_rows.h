// flip_rows.h: the colours of FLIP, a row of pixels at a time.
#pragma once

#include <cstdint>

namespace raster::flip {

/// Three numbers of each pixel, in planes of whole blocks (row_block of metrics_rows.h).
struct Planes {
    float *a, *b, *c;
};

/// Opponent colours (y, red_green, blue_yellow) of linear red, green and blue. Like what follows in the processor's
/// widest registers, whatever the program was compiled for, and with the bits of flip_color.h everywhere.
void opponent_colors(const Planes& rgb, int count, const Planes& out);

/// The same of pixels of three sRGB encoded bytes, four at a time: the planes have room for a multiple.
void opponent_colors_of_bytes(const std::uint8_t* rgb, int count, const Planes& out);

/// Filtered opponent colours become colours as seen, in place: l, a, b of HuntLab.
void seen_colors(const Planes& colors, int count);

/// What the eye makes of a row of pixels: colours as seen, and the filters' answers to edges and points along x and y.
struct SeenRow {
    Planes colors;
    const float *edge_x, *edge_y, *point_x, *point_y;
};

/// The FLIP errors of two rows (sections 4.2 and 4.3 of the paper). `scratch` has twice the room of `errors`.
void errors_between(const SeenRow& expected, const SeenRow& actual, int count, float* errors, float* scratch);

/// Errors rounded up to steps, 0 to most_step: only 0 becomes 0. Has room for whole blocks.
inline constexpr int most_step = 31;
void steps_of_errors(const float* errors, int count, std::uint8_t* steps);

}  // namespace raster::flip
