// clip.h: stage 3, cutting triangles at the planes of the view volume and the user's (Sutherland and Hodgman 1974).
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <algorithm>
#include <limits>
#include <span>

#include <raster/stages/vertex.h>
#include <raster/state.h>

namespace raster {

/// The planes in the order in which they cut. Inside is where the distance is not negative. Plane i of the user's is
/// ClipPlane(clip_plane_count + i).
enum class ClipPlane { right, left, top, bottom, near, far };
inline constexpr int clip_plane_count = 6;
inline constexpr int max_clip_planes = clip_plane_count + max_user_planes;
using UserPlanes = std::span<const glm::vec4>;

/// Coefficients over (x, y, z, w) of clip space.
inline constexpr std::array<glm::vec4, clip_plane_count> clip_planes = {
    glm::vec4(-1, 0, 0, 1), glm::vec4(1, 0, 0, 1), glm::vec4(0, -1, 0, 1),
    glm::vec4(0, 1, 0, 1),  glm::vec4(0, 0, 1, 1), glm::vec4(0, 0, -1, 1)};

/// Bit i is set where the position is outside plane i.
template <class F>
inline Int<F> outcode(const vec<4, F>& clip) {
    const auto bit = [](Mask<F> outside, int plane) { return select(outside, Int<F>(1 << plane), Int<F>(0)); };
    return bit(clip.x > clip.w, 0) | bit(clip.x + clip.w < F(0), 1) | bit(clip.y > clip.w, 2) |
           bit(clip.y + clip.w < F(0), 3) | bit(clip.z + clip.w < F(0), 4) | bit(clip.z > clip.w, 5);
}

/// Whether all four components are numbers, and one is not 0 or a denormal: (0, 0, 0, 0) is no point. Others never reach
/// fixed point.
template <class F>
inline Mask<F> is_finite(const vec<4, F>& clip) {
    // x - x is 0 for numbers and NaN for NaN and both infinities.
    const F zero = ((clip.x - clip.x) + (clip.y - clip.y)) + ((clip.z - clip.z) + (clip.w - clip.w));
    const F largest = max(max(abs(clip.x), abs(clip.y)), max(abs(clip.z), abs(clip.w)));
    return (zero == F(0)) & (largest >= F(std::numeric_limits<float>::min()));
}

/// The signed distance to a plane, scaled by the length of its normal.
template <class F>
inline F clip_distance(const glm::vec4& plane, const vec<4, F>& clip) {
    return ((clip.x * F(plane.x) + clip.y * F(plane.y)) + clip.z * F(plane.z)) + clip.w * F(plane.w);
}
inline float clip_distance(ClipPlane plane, const glm::vec4& clip, UserPlanes user = {}) {
    const int i = int(plane) - clip_plane_count;
    return clip_distance(i < 0 ? clip_planes[std::size_t(plane)] : user[std::size_t(i)], clip);
}

/// How many of a state's planes count.
inline int user_plane_count(UserPlanes user) { return std::min(int(user.size()), max_user_planes); }

/// Bit clip_plane_count + i is set where the position is outside plane i of the user's.
template <class F>
inline Int<F> user_outcode(UserPlanes user, const vec<4, F>& clip) {
    Int<F> code(0);
    for (int i = 0; i < user_plane_count(user); ++i)
        code = code |
               select(clip_distance(user[std::size_t(i)], clip) < F(0), Int<F>(1 << (clip_plane_count + i)), Int<F>(0));
    return code;
}

/// A convex polygon on its way through the planes. Each plane adds at most one corner to a triangle's three.
template <std::size_t N>
struct ClipPolygon {
    using Vertex = ShadedVertex<float, N>;
    std::array<Vertex, 3 + max_clip_planes> corners;
    int count = 0;
    bool clipped = false;  ///< a plane has cut it

    void add(const Vertex& v) { corners[std::size_t(count++)] = v; }
};

/// How far `between` lies from a to b in the window, as a fraction; t where that cannot be told.
inline float window_fraction(const glm::vec4& a, const glm::vec4& b, const glm::vec4& between, float t) {
    for (int i = 0; i < 2; ++i) {
        if (a[i] == b[i]) continue;
        const float from = a[i] / a.w, to = b[i] / b.w;
        const float fraction = (between[i] / between.w - from) / (to - from);
        if (std::isfinite(fraction)) return fraction;
    }
    return t;
}

/// The point where the edge from `a` to `b` meets the plane, with t in 0..1 from a. Position and varyings are
/// interpolated alike in clip space, where both are linear, but for the varyings that are linear in the window.
template <Shader S, std::size_t N>
inline ShadedVertex<float, N> clip_intersection(const ShadedVertex<float, N>& a, const ShadedVertex<float, N>& b,
                                                float t) {
    ShadedVertex<float, N> r;
    for (int i = 0; i < 4; ++i) r.clip[i] = a.clip[i] + t * (b.clip[i] - a.clip[i]);
    for (std::size_t i = 0; i < N; ++i) {
        const bool linear_in_window = interpolation_of<S>(int(i)) == Interpolation::noperspective;
        const float u = linear_in_window ? window_fraction(a.clip, b.clip, r.clip, t) : t;
        r.varyings[i] = a.varyings[i] + u * (b.varyings[i] - a.varyings[i]);
    }
    return r;
}

/// The part of the polygon on the inner side of one plane. Empty when a distance is not finite.
template <Shader S, std::size_t N>
inline ClipPolygon<N> clip_against(ClipPlane plane, const ClipPolygon<N>& polygon, UserPlanes user = {}) {
    ClipPolygon<N> result;
    result.clipped = true;
    for (int i = 0; i < polygon.count; ++i) {
        const auto& a = polygon.corners[std::size_t(i)];
        const auto& b = polygon.corners[std::size_t(i + 1 == polygon.count ? 0 : i + 1)];
        const float da = clip_distance(plane, a.clip, user);
        const float db = clip_distance(plane, b.clip, user);
        if (!std::isfinite(da) || !std::isfinite(db)) return {};
        if (da >= 0) result.add(a);
        if ((da >= 0) != (db >= 0)) {
            // Starting from the nearer end keeps the new corner close to where both neighbours of this edge put it.
            const bool from_a = da >= 0 ? !(-db < da) : -da < db;
            result.add(from_a ? clip_intersection<S>(a, b, da / (da - db))
                              : clip_intersection<S>(b, a, db / (db - da)));
        }
    }
    return result;
}

/// Whether a corner that clipping left is inside the volume, give or take the rounding that corners from far away bring.
/// Numbers so large that rounding throws a corner out by half the volume cannot be drawn, nor fit fixed point.
inline bool is_near_volume(const glm::vec4& clip) {
    const float limit = 1.5f * clip.w;
    return clip.w >= std::numeric_limits<float>::min() && abs(clip.x) <= limit && abs(clip.y) <= limit &&
           abs(clip.z) <= limit;
}

/// The part of a triangle inside all planes that `outside`, the union of its corners' outcodes, names. seen(plane,
/// before, after) is called for each cut. Empty when the numbers are too large to cut.
template <Shader S, std::size_t N, class Seen>
inline ClipPolygon<N> clip_triangle(ClipPolygon<N> polygon, std::int32_t outside, const Seen& seen,
                                    UserPlanes user = {}) {
    for (int plane = 0; plane < max_clip_planes && polygon.count >= 3; ++plane) {
        if (!(outside & (1 << plane))) continue;
        const ClipPolygon<N> before = polygon;
        polygon = clip_against<S>(ClipPlane(plane), before, user);
        seen(ClipPlane(plane), before, polygon);
    }
    for (int i = 0; i < polygon.count; ++i)
        if (!is_near_volume(polygon.corners[std::size_t(i)].clip)) return {};
    return polygon;
}

/// A flat varying is the provoking vertex's, also where clipping has cut that vertex away.
template <Shader S, std::size_t N>
inline void keep_flat_varyings(ClipPolygon<N>& polygon, const ShadedVertex<float, N>& provoking) {
    for (int i = 0; i < varying_count<S>; ++i)
        if (interpolation_of<S>(i) == Interpolation::flat)
            for (auto& corner : polygon.corners) corner.varyings[std::size_t(i)] = provoking.varyings[std::size_t(i)];
}

/// Triangle i of the fan that a clipped polygon is drawn as, i from 0 to count - 3: its corners' places. The order
/// keeps the winding, and puts corner 0 last.
inline std::array<int, 3> clip_fan(int i) { return {i + 1, i + 2, 0}; }

}  // namespace raster
