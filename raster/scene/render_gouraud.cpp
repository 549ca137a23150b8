// render_gouraud.cpp: the draws of Gouraud shading.
#include <raster/pipeline.h>
#include <raster/scene/draw_plan.h>

namespace raster {

DrawCounts draw_gouraud(Target& target, const PlannedDraw& planned) {
    DrawCounts counts;
    with_gouraud_shader(planned, [&](const auto& shader, const auto& mesh, const State& state) {
        counts = draw(target, shader, mesh, state);
    });
    return counts;
}

}  // namespace raster
