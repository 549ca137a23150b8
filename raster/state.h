// state.h: what a draw call may be told besides its shader and its mesh.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>

#include <glm/glm.hpp>

namespace raster {

/// How indices become triangles, points or lines (OpenGL 4.6, 10.1).
enum class Topology { triangles, triangle_strip, triangle_fan, points, lines, line_strip, line_loop };

/// The comparison an incoming depth must pass against the stored one.
enum class Compare { never, less, equal, less_equal, greater, not_equal, greater_equal, always };

/// Which winding, as seen on the picture, is the front.
enum class FrontFace { counter_clockwise, clockwise };
enum class Cull { none, back, front, both };

/// What becomes of a fragment's colour s and the stored colour d.
enum class Blend {
    off,          ///< s
    source_over,  ///< s * s.a + d * (1 - s.a)
    additive,     ///< s + d
};

/// Who owns a pixel centre that lies exactly on an edge. Both rules give each centre of a closed surface one owner.
enum class FillRule {
    bottom_left,  ///< left and bottom edges, as Mesa's OpenGL does
    top_left,     ///< left and top edges, as Direct3D and Vulkan do
};

/// The window rectangle that ndc -1..1 maps to, in pixels; row 0 is on top. A width of 0 means the whole target.
/// All of it lies within -16384 and 16384; a draw with another viewport draws nothing.
struct Viewport {
    int x = 0;
    int y = 0;
    int width = 0;
    int height = 0;
    float near_depth = 0.0f;  ///< window z of ndc z = -1
    float far_depth = 1.0f;   ///< window z of ndc z = 1
};

/// A rectangle of pixels; row 0 is on top.
struct Scissor {
    int x = 0;
    int y = 0;
    int width = 0;
    int height = 0;
};

/// What is added to the depth of a triangle's pixels (OpenGL 4.6, 14.6.5): its steepest slope, in depth a pixel, times
/// `factor`, and `units` smallest steps of the depth buffer. Points and lines are not moved.
struct DepthOffset {
    float factor = 0;
    float units = 0;

    bool is_on() const { return factor != 0 || units != 0; }
};

/// How many clip planes a draw may have beside those of the view volume.
inline constexpr int max_user_planes = 8;

/// The state of a draw. The defaults are OpenGL's with the depth test on.
struct State {
    Topology topology = Topology::triangles;
    Viewport viewport;
    FrontFace front_face = FrontFace::counter_clockwise;
    Cull cull = Cull::none;
    FillRule fill_rule = FillRule::bottom_left;
    Compare depth_compare = Compare::less;
    bool depth_write = true;
    bool color_write = true;
    Blend blend = Blend::off;
    std::optional<Scissor> scissor;  ///< no pixel outside changes
    DepthOffset depth_offset;
    /// Coefficients over clip space x, y, z, w; what has a negative sum is cut away. Not owned; at most
    /// max_user_planes, the rest does nothing.
    std::span<const glm::vec4> clip_planes;
    int line_width = 1;    ///< of lines, in pixels, 1 and more
    float point_size = 1;  ///< of points, in pixels, rounded to whole ones, 1 and more
};

/// What became of the triangles (or points, or lines) of a draw. `submitted` is the sum of the others.
struct DrawCounts {
    std::int64_t submitted = 0;
    std::int64_t bad_index = 0;   ///< an index beyond the vertex array
    std::int64_t not_finite = 0;  ///< a NaN or infinite clip position
    std::int64_t outside = 0;     ///< wholly beyond one clip plane, or clipped to nothing
    std::int64_t culled = 0;      ///< facing the wrong way
    std::int64_t zero_area = 0;   ///< no area after snapping; a line without length
    std::int64_t drawn = 0;       ///< set up; whether it covers a pixel centre is another matter

    DrawCounts& operator+=(const DrawCounts& other) {
        submitted += other.submitted;
        bad_index += other.bad_index;
        not_finite += other.not_finite;
        outside += other.outside;
        culled += other.culled;
        zero_area += other.zero_area;
        drawn += other.drawn;
        return *this;
    }
    friend bool operator==(const DrawCounts&, const DrawCounts&) = default;
};

/// What becomes of one triangle's pieces, and so of the triangle: drawn when any piece is.
struct PieceFate {
    bool any_drawn = false;
    bool any_culled = false;

    void count(DrawCounts& counts) const {
        ++(any_drawn ? counts.drawn : any_culled ? counts.culled : counts.zero_area);
    }
};

}  // namespace raster
