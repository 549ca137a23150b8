// variant.h: a pipeline with one of the bugs: what the observed draw lets a variant change, changed for the worse.
#pragma once

#include <raster/bugs/bug.h>
#include <raster/math.h>
#include <raster/stages/setup.h>

namespace raster {

/// The hooks of detail::ObservedDraw (pipeline.h). Each is called after the stage and changes what it gave. Bugs that
/// are a wrong state, or a wrong shader, are not here (draws.h).
class BugVariant {
public:
    BugVariant(Bug bug, int target_height) : bug_(bug), target_height_(target_height) {}

    /// After the clip test of one corner.
    void change_outcode(std::int32_t& outcode) const {
        if (bug_ == Bug::no_near_clip) outcode = 0;
    }

    /// After projection.
    void change_window(WindowVertex<float>& v) const {
        switch (bug_) {
            case Bug::pixel_corner:
                v.x += 0.5f;
                v.y += 0.5f;
                break;
            case Bug::y_flipped: v.y = float(target_height_) - v.y; break;
            case Bug::no_near_clip:
                // Nothing bounds what was not clipped; the grid of subpixels still has to hold it.
                v.x = within_grid(v.x);
                v.y = within_grid(v.y);
                if (!(abs(v.z) <= grid_limit)) v.z = 1;
                if (!(abs(v.oow) <= grid_limit)) v.oow = 1;
                break;
            default: break;
        }
    }

    /// After the snap.
    void change_subpixel(SubpixelVertex<float>& v) const {
        if (bug_ != Bug::whole_pixels) return;
        v.x = ((v.x + subpixels / 2) >> subpixel_bits) * subpixels;
        v.y = ((v.y + subpixels / 2) >> subpixel_bits) * subpixels;
    }

    /// After the edges are made.
    void change_setup(TriangleSetup& setup) const {
        if (bug_ != Bug::no_top_left && bug_ != Bug::strict_edges) return;
        for (Edge<float>& edge : setup.edges) edge.inclusive = bug_ == Bug::no_top_left;
    }

    /// Before the planes are made: 1 / w of the three corners.
    void change_perspective(std::array<float, 3>& oow) const {
        if (bug_ == Bug::affine) oow = {1, 1, 1};
    }

private:
    static constexpr float grid_limit = 131072;
    static float within_grid(float x) { return x == x ? clamp(x, -grid_limit, grid_limit) : 0; }

    Bug bug_;
    int target_height_;
};

}  // namespace raster
