// observe_gouraud.cpp: the observed draws of Gouraud shading.
#include <raster/scene/observe.h>

namespace raster {

DrawCounts draw_gouraud(Target& target, const PlannedDraw& planned, SceneObserver& observer) {
    DrawCounts counts;
    with_gouraud_shader(planned, [&](const auto& shader, const auto& mesh, const State& state) {
        counts = draw(target, shader, mesh, state, observer);
    });
    return counts;
}

}  // namespace raster
