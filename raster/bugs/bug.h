// bug.h: the mistakes that everybody makes once when writing a rasterizer, to be looked at one by one.
#pragma once

#include <array>
#include <optional>
#include <string_view>

namespace raster {

/// Each is one wrong line in one stage.
enum class Bug {
    no_top_left,
    strict_edges,
    affine,
    no_near_clip,
    z_flipped,
    no_depth_test,
    wrong_cull,
    no_renormalise,
    pixel_corner,
    whole_pixels,
    y_flipped,
};

struct BugInfo {
    Bug bug;
    std::string_view name;     ///< on the command line
    std::string_view mistake;  ///< what is wrong
    std::string_view symptom;  ///< what one sees, and on which scene
};

inline constexpr std::array<BugInfo, 11> bugs = {{
    {Bug::no_top_left, "no-top-left",
     "every edge owns the centres that lie on it: e >= 0, whichever side the edge is on",
     "pixels on shared edges are drawn twice, which see-through surfaces show"},
    {Bug::strict_edges, "strict-edges", "no edge owns the centres that lie on it: e > 0, whichever side the edge is on",
     "holes where a shared edge runs through pixel centres"},
    {Bug::affine, "affine", "varyings are interpolated linearly in the window, without the division by w",
     "textures and highlights bend along the diagonals of large faces"},
    {Bug::no_near_clip, "no-near-clip", "triangles are not clipped before they are divided by w",
     "what crosses the plane of the eye is thrown across the picture; move the camera into the model"},
    {Bug::z_flipped, "z-flipped", "window z runs from 1 near to 0 far, and the smaller one still wins",
     "what is farthest hides what is near: one sees the inside of closed models"},
    {Bug::no_depth_test, "no-depth-test", "depths are not compared", "what is drawn last wins"},
    {Bug::wrong_cull, "wrong-cull", "culling takes the wrong winding for the front", "closed models show their inside"},
    {Bug::no_renormalise, "no-renormalise", "interpolated normals are used as they are, shorter than 1",
     "Phong shading with dark patches in the middle of large triangles, and highlights that flicker between them"},
    {Bug::pixel_corner, "pixel-corner", "pixels are sampled at their corner (x, y), not at their centre",
     "the picture is shifted by half a pixel"},
    {Bug::whole_pixels, "whole-pixels", "corners are rounded to whole pixels before the edges are made",
     "outlines with teeth, small triangles that vanish or swell, cracks at T-junctions"},
    {Bug::y_flipped, "y-flipped", "window y runs up, while the picture's rows run down",
     "the picture is upside down, and front faces count as back faces"},
}};

constexpr const BugInfo& info_of(Bug bug) { return bugs[std::size_t(bug)]; }

inline std::optional<Bug> find_bug(std::string_view name) {
    for (const BugInfo& info : bugs)
        if (info.name == name) return info.bug;
    return {};
}

}  // namespace raster
