// assemble.h: stage 2, from a list of indices to triangles, lines or points (OpenGL 4.6, 10.1).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include <raster/state.h>

namespace raster {

/// How many triangles `count` indices make.
inline std::size_t triangle_count(Topology topology, std::size_t count) {
    if (topology == Topology::triangles) return count / 3;
    return count < 3 ? 0 : count - 2;
}

/// Which three entries of the index list are the corners of triangle i. The last is the provoking vertex; every other
/// triangle of a strip has its first two exchanged, so that all wind the same way.
inline std::array<std::size_t, 3> assemble(Topology topology, std::size_t i) {
    switch (topology) {
        case Topology::triangle_strip: return {i + (i & 1), i + 1 - (i & 1), i + 2};
        case Topology::triangle_fan: return {0, i + 1, i + 2};
        default: break;
    }
    return {3 * i, 3 * i + 1, 3 * i + 2};
}

/// How many corners a primitive has: 3 for triangles, 2 for lines, 1 for points.
inline int corner_count(Topology topology) {
    if (topology == Topology::points) return 1;
    return topology >= Topology::lines ? 2 : 3;
}

/// How many triangles, lines or points `count` indices make.
inline std::size_t primitive_count(Topology topology, std::size_t count) {
    switch (topology) {
        case Topology::points: return count;
        case Topology::lines: return count / 2;
        case Topology::line_strip: return count < 2 ? 0 : count - 1;
        case Topology::line_loop: return count < 2 ? 0 : count;
        default: return triangle_count(topology, count);
    }
}

/// Which two entries of an index list of `count` are the ends of line i. The second is the provoking vertex.
inline std::array<std::size_t, 2> assemble_line(Topology topology, std::size_t i, std::size_t count) {
    if (topology == Topology::lines) return {2 * i, 2 * i + 1};
    return {i, i + 1 == count ? 0 : i + 1};
}

}  // namespace raster
