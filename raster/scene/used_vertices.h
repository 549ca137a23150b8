// used_vertices.h: the vertices of a model that can be seen.
#pragma once

#include <cstdint>
#include <vector>

#include <raster/scene/model.h>

namespace raster {

/// Calls visit(vertex) once for each vertex that a triangle uses, in the order in which they do.
template <class Visit>
void for_each_used_vertex(const Model& model, const Visit& visit) {
    std::vector<std::uint8_t> is_visited(model.vertices.size());
    for (const std::uint32_t i : model.indices) {
        if (is_visited[i]) continue;
        is_visited[i] = 1;
        visit(model.vertices[i]);
    }
}

}  // namespace raster
