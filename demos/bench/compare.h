// compare.h: whether this library and its rival drew the same picture, as far as the two can.
#pragma once

#include <cstddef>
#include <string>

#include "ours.h"
#include "rival.h"

namespace bench {

/// What differs between two pictures of one scene.
struct Differences {
    int largest_color = 0;            ///< of any channel, in 1/255
    int largest_depth = 0;            ///< in units of the 24-bit depth
    std::size_t color_pixels = 0;     ///< so many are not equal
    std::size_t depth_pixels = 0;
    std::size_t coverage_pixels = 0;  ///< drawn to in one picture and not in the other
};

Differences compare(Ours& ours, Rival& rival);

/// What is wrong between the two, or nothing. The same pixels are covered, colours are within 1/255 a channel, or 2/255
/// where textured. Depths are equal if `equal_depths`: where llvmpipe multiplies and adds in one rounding, its depths
/// are others, mostly by a unit or two and in steep triangles by hundreds.
std::string disagreement(const Differences& differences, const Scene& scene, bool equal_depths);

}  // namespace bench
