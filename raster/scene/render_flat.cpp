// render_flat.cpp: the draws of flat shading.
#include <raster/pipeline.h>
#include <raster/scene/draw_plan.h>

namespace raster {

DrawCounts draw_flat(Target& target, const PlannedDraw& planned) {
    DrawCounts counts;
    with_flat_shader(planned, [&](const auto& shader, const auto& mesh, const State& state) {
        counts = draw(target, shader, mesh, state);
    });
    return counts;
}

}  // namespace raster
