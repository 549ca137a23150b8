// model.cpp: measures of a model.
#include <raster/scene/model.h>

#include <limits>

#include <raster/scene/used_vertices.h>

namespace raster {

Box bounding_box(const Model& model) {
    constexpr float infinity = std::numeric_limits<float>::infinity();
    Box box{glm::vec3(infinity), glm::vec3(-infinity)};
    for_each_used_vertex(model, [&](const SurfaceVertex<float>& vertex) {
        box.min = glm::min(box.min, vertex.position);
        box.max = glm::max(box.max, vertex.position);
    });
    return box;
}

}  // namespace raster
