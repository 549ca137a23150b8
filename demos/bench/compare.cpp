// compare.cpp: pixel by pixel.
#include "compare.h"

#include <algorithm>
#include <cstdlib>

namespace bench {

Differences compare(Ours& ours, Rival& rival) {
    constexpr std::uint32_t far_depth = 0xffffff;
    Differences d;
    const auto &our_color = ours.color(), &rival_color = rival.color();
    const auto &our_depth = ours.depth(), rival_depth = rival.depth();
    for (std::size_t i = 0; i < our_color.size(); ++i) {
        d.color_pixels += our_color[i] != rival_color[i];
        for (int shift = 0; shift < 32; shift += 8)
            d.largest_color = std::max(
                d.largest_color, std::abs(int(our_color[i] >> shift & 255) - int(rival_color[i] >> shift & 255)));
        d.coverage_pixels += (our_depth[i] != far_depth) != (rival_depth[i] != far_depth);
        d.depth_pixels += our_depth[i] != rival_depth[i];
        d.largest_depth = std::max(d.largest_depth, std::abs(int(our_depth[i]) - int(rival_depth[i])));
    }
    return d;
}

std::string disagreement(const Differences& d, const Scene& scene, bool equal_depths) {
    const int color_tolerance = scene.shading == Shading::textured ? 2 : 1;
    const auto text = [](auto value) { return std::to_string(value); };
    if (d.coverage_pixels > 0) return "the pictures cover " + text(d.coverage_pixels) + " pixels differently";
    if (d.largest_color > color_tolerance)
        return "colours differ by " + text(d.largest_color) + "/255, " + text(color_tolerance) + "/255 are allowed";
    if (equal_depths && d.depth_pixels > 0)
        return "the depths of " + text(d.depth_pixels) + " pixels differ, by " + text(d.largest_depth) + " at most";
    return "";
}

}  // namespace bench
