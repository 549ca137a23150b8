// model.cpp: measures of a model.
#include <raster/scene/model.h>

#include <limits>

namespace raster {

Box bounding_box(const Model& model) {
    constexpr float infinity = std::numeric_limits<float>::infinity();
    Box box{glm::vec3(infinity), glm::vec3(-infinity)};
    for (const std::uint32_t i : model.indices) {
        box.min = glm::min(box.min, model.vertices[i].position);
        box.max = glm::max(box.max, model.vertices[i].position);
    }
    return box;
}

}  // namespace raster
