// state.h: what a draw call may be told besides its shader and its mesh.
#pragma once

#include <array>
#include <cstdint>

#include <glm/glm.hpp>

namespace raster {

/// How indices become triangles (OpenGL 4.6, 10.1).
enum class Topology { triangles, triangle_strip, triangle_fan };

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
};

/// What became of the triangles of a draw. `submitted` is the sum of the others.
struct DrawCounts {
    std::int64_t submitted = 0;
    std::int64_t bad_index = 0;   ///< an index beyond the vertex array
    std::int64_t not_finite = 0;  ///< a NaN or infinite clip position
    std::int64_t outside = 0;     ///< wholly beyond one clip plane, or clipped to nothing
    std::int64_t culled = 0;      ///< facing the wrong way
    std::int64_t zero_area = 0;   ///< no area after snapping
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
