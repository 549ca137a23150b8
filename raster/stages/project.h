// project.h: stage 4, from clip space to the window: perspective divide, viewport, and the snap to the subpixel grid.
#pragma once

#include <raster/lanes.h>
#include <raster/state.h>

namespace raster {

/// Subpixel positions are integers, 256 to the pixel.
inline constexpr int subpixel_bits = 8;
inline constexpr int subpixels = 1 << subpixel_bits;

/// A position in the window: x and y in pixels from the top left corner, z 0 near to 1 far, oow = 1 / clip w.
template <class F>
struct WindowVertex {
    F x, y, z, oow;
};

/// The viewport of a draw: a width of 0 stands for the whole target.
inline Viewport effective_viewport(Viewport v, int target_width, int target_height) {
    if (v.width == 0) v.x = v.y = 0, v.width = target_width, v.height = target_height;
    return v;
}

/// Coordinates beyond this many pixels would not fit the fixed-point types.
inline constexpr int max_window_coordinate = 16384;

inline bool is_valid(const Viewport& v) {
    const auto fits = [](int start, int size) {
        return start >= -max_window_coordinate && size > 0 && size <= max_window_coordinate - start;
    };
    return fits(v.x, v.width) && fits(v.y, v.height);
}

/// A viewport as factors and offsets: window = ndc * scale + offset.
struct ViewportTransform {
    glm::vec3 scale, offset;

    explicit ViewportTransform(const Viewport& v)
        : scale(float(v.width) * 0.5f, float(v.height) * -0.5f, (v.far_depth - v.near_depth) * 0.5f),
          offset(float(v.x) + float(v.width) * 0.5f, float(v.y) + float(v.height) * 0.5f,
                 (v.far_depth + v.near_depth) * 0.5f) {}
};

/// Divide by w, then scale and offset (OpenGL 4.6, 13.8.1), with y turned so that row 0 is on top. w is not 0: the clip
/// stage leaves only positions inside the volume.
template <class F>
inline WindowVertex<F> project(const vec<4, F>& clip, const ViewportTransform& viewport) {
    const F oow = F(1) / clip.w;
    return {(clip.x * oow) * F(viewport.scale.x) + F(viewport.offset.x),
            (clip.y * oow) * F(viewport.scale.y) + F(viewport.offset.y),
            (clip.z * oow) * F(viewport.scale.z) + F(viewport.offset.z), oow};
}

/// A window coordinate on the subpixel grid, measured from the centre of pixel 0, so that pixel centres are the
/// multiples of 256. Halves round to even.
template <class F>
inline Int<F> snap(F window) {
    return round_to_int((window - F(0.5f)) * F(float(subpixels)));
}

/// A snapped position.
template <class F>
struct SubpixelVertex {
    Int<F> x, y;
};
template <class F>
inline SubpixelVertex<F> snap(const WindowVertex<F>& v) {
    return {snap(v.x), snap(v.y)};
}

}  // namespace raster
