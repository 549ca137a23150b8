// events.h: what an observed draw tells at each stage: plain structs that hold the very numbers the stage computed.
//
// An observer is any object with an overload `on(const XEvent&)` for the events it wants. Spans and references are valid
// only during the call. Without an observer, or without the overload, nothing of this is compiled in.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include <raster/stages/clip.h>
#include <raster/stages/setup.h>

namespace raster {

/// Stage 1: a vertex after its shader.
struct VertexEvent {
    std::uint32_t vertex;
    std::span<const float> attributes;  ///< the shader's Vertex as numbers, object space
    glm::vec4 clip;
    std::span<const float> varyings;
};

/// Stage 2: three vertices become triangle number `triangle` of the draw.
struct AssembleEvent {
    std::int64_t triangle;
    std::array<std::uint32_t, 3> vertices;
    bool bad_index;  ///< dropped: a vertex does not exist
};

/// Stage 3: the triangle against the view volume.
struct ClipEvent {
    enum class Verdict { inside, not_finite, outside, clipped };
    std::int64_t triangle;
    std::array<glm::vec4, 3> clip;
    std::array<std::int32_t, 3> outcodes;
    Verdict verdict;
    int pieces;  ///< triangles that go on
};

/// A corner of a polygon that is being clipped.
struct ClipCorner {
    glm::vec4 clip;
    float distance;  ///< to the plane of the event
    std::span<const float> varyings;
};

/// Stage 3, one plane of a clipped triangle: the polygon before and after.
struct ClipPlaneEvent {
    std::int64_t triangle;
    ClipPlane plane;
    std::span<const ClipCorner> before;
    std::span<const ClipCorner> after;
};

/// Stage 4: a piece's corners in the window. Piece is 0 for an unclipped triangle.
struct ProjectEvent {
    std::int64_t triangle;
    int piece;
    std::array<glm::vec4, 3> clip;
    std::array<WindowVertex<float>, 3> window;
    std::array<SubpixelVertex<float>, 3> subpixel;
};

/// Stage 5: which way it faces.
struct CullEvent {
    enum class Verdict { kept, culled, zero_area };
    std::int64_t triangle;
    int piece;
    std::int64_t area;  ///< twice the signed area in square subpixels
    bool front_facing;
    Verdict verdict;
};

/// Stage 6: its edges and planes.
struct SetupEvent {
    std::int64_t triangle;
    int piece;
    const TriangleSetup& setup;
    Plane<float> oow;
    std::span<const Plane<float>> varyings;
};

/// Stage 7: the three edge functions at a pixel of its bounding box.
struct CoverageEvent {
    std::int64_t triangle;
    int piece;
    int x, y;
    std::array<std::int64_t, 3> edges;
    bool covered;
};

/// Stage 8: the depth test at a covered pixel.
struct DepthEvent {
    std::int64_t triangle;
    int piece;
    int x, y;
    float z;
    std::uint32_t incoming, stored;  ///< as encode_depth gives them
    bool passed;
};

/// Stage 9: the varyings at a pixel that passed.
struct InterpolateEvent {
    std::int64_t triangle;
    int piece;
    int x, y;
    float oow;
    std::span<const float> varyings;
};

/// Stage 10: what the shader made of them.
struct FragmentEvent {
    std::int64_t triangle;
    int piece;
    int x, y;
    std::span<const float> outputs;
};

/// Stage 11: the stored colour before and after.
struct BlendEvent {
    std::int64_t triangle;
    int piece;
    int x, y;
    glm::vec4 source, before, after;
};

/// For draws that nobody watches.
struct NoObserver {};

/// Where a draw is watched. A pixel is a pure function of the triangles, so the stages from coverage on need not run
/// elsewhere to give the same numbers here; what is not watched is not drawn.
struct WatchedPixels {
    PixelBox box;                ///< within the target
    bool coverage_of_all = false;  ///< coverage is told of every set-up triangle at all of these pixels, however far off
};

/// The pixels of a triangle's box at which the stages from coverage on run: all, unless the observer has a member
/// function `WatchedPixels watched_pixels() const`.
template <class Observer>
inline PixelBox pixels_to_run(const Observer& observer, const PixelBox& box) {
    if constexpr (requires { observer.watched_pixels(); }) {
        const WatchedPixels watched = observer.watched_pixels();
        return watched.coverage_of_all ? watched.box : intersection(box, watched.box);
    } else {
        return box;
    }
}

/// Whether an observer wants an event of this type.
template <class Observer, class Event>
concept Observes = requires(Observer& observer, const Event& event) { observer.on(event); };

/// Builds the event and hands it over; nothing at all when it is not wanted.
template <class Event, class Observer, class Make>
inline void notify(Observer& observer, const Make& make) {
    if constexpr (Observes<Observer, Event>) observer.on(Event(make()));
}

}  // namespace raster
