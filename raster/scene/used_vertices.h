// used_vertices.h: the vertices of a model that can be seen.
#pragma once

#include <cstdint>
#include <vector>

#include <raster/scene/model.h>

namespace raster {

/// Calls visit(vertex) once for each vertex that a triangle uses, in the order in which they are stored.
template <class Visit>
void for_each_used_vertex(const Model& model, const Visit& visit) {
    std::vector<std::uint8_t> is_used(model.vertices.size());
    for (const std::uint32_t i : model.indices) is_used[i] = 1;
    for (std::size_t i = 0; i < is_used.size(); ++i)
        if (is_used[i]) visit(model.vertices[i]);
}

}  // namespace raster
