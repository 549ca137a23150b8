// assemble.h: stage 2, from a list of indices to triangles (OpenGL 4.6, 10.1).
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
        case Topology::triangles: break;
    }
    return {3 * i, 3 * i + 1, 3 * i + 2};
}

}  // namespace raster
