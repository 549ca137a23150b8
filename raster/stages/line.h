// line.h: aliased lines of whole widths: which part is visible, the parallelogram it covers, and its planes.
//
// A line is a parallelogram whose short sides lie along the minor axis (OpenGL 4.6, 14.5.2.2). Its ends are moved so
// that it covers what the diamond-exit rule says (14.5.1): a pixel belongs to the line when the line leaves the diamond
// around its centre. The order of operations is that of Mesa's llvmpipe, with which it agrees to the last bit.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include <raster/stages/clip.h>
#include <raster/stages/coverage.h>

namespace raster {

/// A window coordinate on the subpixel grid as lines and points have it: halves round away from zero.
inline std::int32_t snap_half_away(float window) {
    const float scaled = (window - 0.5f) * float(subpixels);
    return truncate_to_int(scaled >= 0 ? scaled + 0.5f : scaled - 0.5f);
}

/// The part of a line inside all planes that `outside`, the union of its ends' outcodes, names. Nothing when none is.
template <Shader S, std::size_t N>
inline std::optional<std::array<ShadedVertex<float, N>, 2>> clip_line(const ShadedVertex<float, N>& v0,
                                                                      const ShadedVertex<float, N>& v1,
                                                                      std::int32_t outside, UserPlanes user = {}) {
    float t0 = 0, t1 = 0;  // how much is cut off at each end
    for (int plane = 0; plane < max_clip_planes; ++plane) {
        if (!(outside & (1 << plane))) continue;
        const float d0 = clip_distance(ClipPlane(plane), v0.clip, user);
        const float d1 = clip_distance(ClipPlane(plane), v1.clip, user);
        if (!std::isfinite(d0) || !std::isfinite(d1)) return {};
        if (d0 < 0) t0 = max(t0, d0 / (d0 - d1));
        if (d1 < 0) t1 = max(t1, d1 / (d1 - d0));
        if (t0 + t1 >= 1) return {};
    }
    std::array<ShadedVertex<float, N>, 2> r = {v0, v1};
    if (outcode(v0.clip) | user_outcode(user, v0.clip)) r[0] = clip_intersection<S>(v0, v1, t0);
    if (outcode(v1.clip) | user_outcode(user, v1.clip)) r[1] = clip_intersection<S>(v1, v0, t1);
    for (const auto& v : r)
        if (!is_near_volume(v.clip)) return {};
    return r;
}

/// What all planes of one line share: values change along the line alone.
struct LineBasis {
    float x0, y0;  ///< window position of the first end relative to the centre of pixel (0, 0)
    float dx, dy;  ///< along the major axis alone, so that pixels beside each other have equal values
    float over_length;
};

/// Everything about a line that its pixels share, but for the varyings' planes.
struct LineSetup {
    std::array<Edge<float>, 4> edges;
    LineBasis basis;
    Plane<float> depth;
    PixelBox box;
};

/// The plane of a value that is a0 at the first end and a1 at the second.
inline Plane<float> make_line_plane(const LineBasis& b, float a0, float a1) {
    const float d = a0 - a1;
    const float dadx = d * b.dx * b.over_length, dady = d * b.dy * b.over_length;
    return {a0 - (dadx * b.x0 + dady * b.y0), dadx, dady};
}

namespace detail {

/// An end of a line in its pixel, relative to the centre, each -1/2 to 1/2.
struct LineEnd {
    float major, minor;
    float minor_fraction;  ///< 0 to 1, from the pixel's border
};

inline LineEnd line_end(float major, float minor) {
    return {major - std::floor(major) - 0.5f, minor - std::floor(minor) - 0.5f, minor - std::floor(minor)};
}

inline bool in_diamond(const LineEnd& e) { return abs(e.major) + abs(e.minor) < 0.5f; }

/// How far an end must move along the major axis so that its pixel is drawn, or is not, as the diamond-exit rule wants.
/// d is the first end minus the second. Signs are those of a picture whose y points up: up_major and up_minor turn
/// them.
struct EndMoves {
    float first = 0, second = 0;
};

inline EndMoves diamond_exit(LineEnd first, LineEnd second, float d_major, float d_minor, bool x_major) {
    const float slope = d_minor / d_major;
    if (second.minor == -0.5f && d_minor < 0) second.minor = 0.5f;
    const auto positive = [](float x) { return x >= 0; };
    const float major_sign = x_major ? 1.0f : -1.0f, minor_sign = -major_sign;
    const bool back = positive(-d_major * major_sign);  // the line runs toward larger coordinates
    const bool minor_back = positive(-d_minor * minor_sign);
    const auto crossing = [&](const LineEnd& e) { return e.minor_fraction + e.major * slope; };

    bool draws_first, draws_second;
    if (in_diamond(first))
        draws_first = true;
    else if (positive(first.major * major_sign) == back)
        draws_first = false;
    else if (positive(first.minor * minor_sign) != minor_back)
        draws_first = true;
    else
        draws_first = crossing(first) < 1 && crossing(first) > 0;

    if (in_diamond(second))
        draws_second = false;
    else if (positive(second.major * major_sign) != back)
        draws_second = false;
    else if (positive(second.minor * minor_sign) == minor_back)
        draws_second = true;
    else
        draws_second = crossing(second) < 1 && (x_major ? crossing(second) > 0 : crossing(second) >= 0);

    // What a parallelogram that ends where the line ends would draw.
    const bool has_first = positive(-first.major * major_sign) != positive(d_major * major_sign);
    const bool has_second = positive(second.major * major_sign) == back || second.major == 0;
    const float border = d_major < 0 ? -0.5f : 0.5f;
    return {has_first != draws_first ? border - first.major : 0,
            has_second != draws_second ? border - second.major : 0};
}

}  // namespace detail

/// Sets up the line from v0 to v1, `width` pixels wide along the minor axis; 1 and more. Nothing for a line without
/// length.
inline std::optional<LineSetup> make_line_setup(const WindowVertex<float>& v0, const WindowVertex<float>& v1, int width,
                                                FillRule rule, int target_width, int target_height) {
    const float dx = v0.x - v1.x, dy = v0.y - v1.y;
    const float square = dx * dx + dy * dy;
    if (square == 0) return {};
    const bool x_major = abs(dx) >= abs(dy);
    const float slope = x_major ? dy / dx : dx / dy;
    const auto end = [&](const WindowVertex<float>& v) {
        return x_major ? detail::line_end(v.x, v.y) : detail::line_end(v.y, v.x);
    };
    const detail::EndMoves moves =
        detail::diamond_exit(end(v0), end(v1), x_major ? dx : dy, x_major ? dy : dx, x_major);

    const auto corner = [&](const WindowVertex<float>& v, float move, int side) -> SubpixelVertex<float> {
        const float across = move * slope;
        const std::int32_t x = snap_half_away(v.x + (x_major ? move : across));
        const std::int32_t y = snap_half_away(v.y + (x_major ? across : move));
        const std::int32_t half = side * (width * subpixels / 2);
        return x_major ? SubpixelVertex<float>{x, y + half} : SubpixelVertex<float>{x + half, y};
    };
    // Counter-clockwise on the picture: from the right along the top, or from the top along the left.
    const bool reversed = x_major ? dx < 0 : dy > 0;
    const auto& a = reversed ? v1 : v0;
    const auto& b = reversed ? v0 : v1;
    const float move_a = reversed ? moves.second : moves.first, move_b = reversed ? moves.first : moves.second;
    const std::array<SubpixelVertex<float>, 4> corners = {corner(a, move_a, -1), corner(b, move_b, -1),
                                                          corner(b, move_b, 1), corner(a, move_a, 1)};
    LineSetup s;
    for (std::size_t i = 0; i < 4; ++i) s.edges[i] = make_edge(corners[i], corners[(i + 1) % 4], rule);
    const PixelBox one = bounding_pixels({corners[0], corners[1], corners[2]}, target_width, target_height);
    const PixelBox two = bounding_pixels({corners[0], corners[2], corners[3]}, target_width, target_height);
    s.box = {std::min(one.min_x, two.min_x), std::min(one.min_y, two.min_y), std::max(one.max_x, two.max_x),
             std::max(one.max_y, two.max_y)};
    const float stretch = 1 + slope * slope;
    s.basis = {v0.x - 0.5f, v0.y - 0.5f, x_major ? dx * stretch : 0, x_major ? 0 : dy * stretch, 1.0f / square};
    s.depth = make_line_plane(s.basis, v0.z, v1.z);
    return s;
}

}  // namespace raster
