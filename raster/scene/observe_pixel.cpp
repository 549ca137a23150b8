// observe_pixel.cpp: the observed draws of Phong shading.
#include <raster/scene/observe.h>

namespace raster {

DrawCounts draw_pixel_shaded(Target& target, const PlannedDraw& planned, SceneObserver& observer) {
    DrawCounts counts;
    with_runtime_pixel_shader(planned, [&](const auto& shader, const auto& mesh, const State& state) {
        counts = draw(target, shader, mesh, state, observer);
    });
    return counts;
}

}  // namespace raster
