// sink.cpp: the observed draws.
#include <raster/step/sink.h>

#include <raster/pipeline.h>

namespace raster::step {

DrawCounts watch(Target& target, const Model& model, const CameraMatrices& camera, const RenderOptions& options,
                 Sink& sink) {
    target.clear(options.background);
    DrawCounts counts;
    int number = 0;
    const DrawPlan plan(model, options, true);  // so every draw is of Detail::terms
    plan.for_each(camera, [&](const PlannedDraw& d) {
        sink.begin(d, number++);
        const auto run = [&](const auto& shader) { counts += draw(target, shader, d.mesh, d.state, sink); };
        switch (d.frequency) {
            case ShadingFrequency::flat: return run(FlatShader<Detail::terms>{d.uniforms, d.faces});
            case ShadingFrequency::gouraud: return run(GouraudShader<Detail::terms>{d.uniforms, {d.reflectance}});
            case ShadingFrequency::phong:
                return run(PixelShader<RuntimeModel, Detail::terms>{d.uniforms, {d.reflectance}});
        }
    });
    return counts;
}

}  // namespace raster::step
