// observe_flat.cpp: the observed draws of flat shading.
#include <raster/scene/observe.h>

namespace raster {

DrawCounts draw_flat(Target& target, const PlannedDraw& planned, SceneObserver& observer) {
    DrawCounts counts;
    with_flat_shader(planned, [&](const auto& shader, const auto& mesh, const State& state) {
        counts = draw(target, shader, mesh, state, observer);
    });
    return counts;
}

}  // namespace raster
