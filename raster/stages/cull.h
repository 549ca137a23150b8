// cull.h: stage 5, which way a triangle faces, and whether that way is wanted.
#pragma once

#include <array>

#include <raster/stages/project.h>

namespace raster {

/// Twice the signed area in square subpixels; positive when the corners run counter-clockwise on the picture.
inline std::int64_t signed_area(const std::array<SubpixelVertex<float>, 3>& v) {
    const std::int64_t dx01 = v[0].x - v[1].x, dy01 = v[0].y - v[1].y;
    const std::int64_t dx20 = v[2].x - v[0].x, dy20 = v[2].y - v[0].y;
    return dx01 * dy20 - dx20 * dy01;
}

inline bool is_front_facing(FrontFace front_face, std::int64_t area) {
    return (area > 0) == (front_face == FrontFace::counter_clockwise);
}

inline bool is_culled(Cull cull, bool front_facing) {
    return cull == Cull::both || cull == (front_facing ? Cull::front : Cull::back);
}

}  // namespace raster
