// diff_picture.h: pictures of a comparison, for people.
#pragma once

#include <raster/image/diff.h>
#include <raster/image/png.h>

namespace raster {

/// The picture as a display shows it, 8 bits, RGB: floats clamped and sRGB encoded, transparency over white.
Image8 displayed(const AnyImage& image);

/// The expected picture, pale and grey, with pixels that fail in orange (the darker, the larger the difference),
/// those that differ and pass in blue, and those that do not count hatched. Same size. Never red and green.
IndexedImage indexed_difference(const AnyImage& expected, const Diff& diff);
Image8 difference_picture(const AnyImage& expected, const Diff& diff);

/// The FLIP error of each pixel from black, 0, to white, 1, rounded up to one of 32 greys.
/// Takes `flip_steps` away; empty if there is neither that nor a flip_map.
IndexedImage flip_picture(Diff&& diff);

/// Expected, actual and difference side by side, for a glance: at most 1024 pixels each, small ones magnified. Where
/// shrunk, a difference of one pixel stays visible. `difference` may be empty.
Image8 triptych(const AnyImage& expected, const AnyImage& actual, const IndexedImage& difference);

}  // namespace raster
