// render_pixel.cpp: the draws of Phong shading.
#include <raster/pipeline.h>
#include <raster/scene/draw_plan.h>

namespace raster {

DrawCounts draw_pixel_shaded(Target& target, const PlannedDraw& planned) {
    DrawCounts counts;
    with_pixel_shader(planned, [&](const auto& shader, const auto& mesh, const State& state) {
        counts = draw(target, shader, mesh, state);
    });
    return counts;
}

}  // namespace raster
