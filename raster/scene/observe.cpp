// observe.cpp: the draws of a picture, one after the other, each watched.
#include <raster/scene/observe.h>

namespace raster {

DrawCounts render_for(SceneObserver& observer, Target& target, const Model& model, const CameraMatrices& camera,
                      const RenderOptions& options) {
    target.clear(options.background);
    DrawCounts counts;
    int draw = 0;
    const DrawPlan plan(model, options, target.extra_channels() > 0);
    plan.for_each(camera, [&](const PlannedDraw& planned) {
        observer.on(DrawEvent{draw++, planned, target});
        switch (planned.frequency) {
            case ShadingFrequency::flat: counts += draw_flat(target, planned, observer); break;
            case ShadingFrequency::gouraud: counts += draw_gouraud(target, planned, observer); break;
            case ShadingFrequency::phong: counts += draw_pixel_shaded(target, planned, observer); break;
        }
    });
    return counts;
}

}  // namespace raster
