// catalogue.cpp: the list of kinds, and what scenes of many kinds are made of.
#include "catalogue_parts.h"

namespace raster::conformance {

glm::vec4 random_color(Random& random, float low, float high) {
    glm::vec4 color;
    for (int i = 0; i < 4; ++i) color[i] = random.uniform(low, high);
    return color;
}

Scene empty_scene(Random& random) {
    constexpr int sizes[][2] = {{256, 256}, {256, 256}, {256, 256}, {256, 256},  {256, 256},
                                {256, 256}, {512, 512}, {640, 480}, {1280, 720}, {1920, 1080}};
    const auto& size = sizes[random.integer(0, 9)];
    Scene scene;
    scene.width = size[0], scene.height = size[1];
    scene.clear_color = {0.1f, 0.2f, 0.3f, 1};
    return scene;
}

Draw make_draw(Group group, Random& random, int count, int width, int height, Coloring coloring) {
    Draw draw;
    draw.coloring = coloring;
    const float beyond = coloring == Coloring::fixed_function ? 0.0f : 0.2f;
    for (int i = 0; i < count; ++i)
        for (const glm::vec4& position : make_triangle(group, random, width, height)) {
            const glm::vec4 color = random_color(random, -beyond, 1 + beyond);
            const float u = random.uniform(-3, 3);
            draw.vertices.push_back({position, color, {u, random.uniform(-3, 3)}});
        }
    return draw;
}

Blend random_blend(Random& random) { return Blend(random.integer(0, 2)); }

Group random_group(Random& random, bool unclipped) {
    return Group(random.integer(0, unclipped ? int(Group::axis_aligned) : int(Group::collinear)));
}

const std::vector<Kind>& exact_kinds() {
    static const std::vector<Kind> kinds = [] {
        std::vector<Kind> all = primitive_kinds();
        for (const Kind& kind : state_kinds()) all.push_back(kind);
        return all;
    }();
    return kinds;
}

}  // namespace raster::conformance
