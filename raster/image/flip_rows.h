// flip_rows.h: the colours of FLIP, a row of pixels at a time.
#pragma once

namespace raster::flip {

/// Three numbers of each pixel, in planes of whole blocks (row_block of metrics_rows.h).
struct Planes {
    float *a, *b, *c;
};

/// Opponent colours (y, red_green, blue_yellow) of linear red, green and blue. Like seen_colors in the processor's
/// widest registers, whatever the program was compiled for, and with the bits of flip_color.h everywhere.
void opponent_colors(const Planes& rgb, int count, const Planes& out);

/// Filtered opponent colours become colours as seen, in place: l, a, b of HuntLab.
void seen_colors(const Planes& colors, int count);

}  // namespace raster::flip
