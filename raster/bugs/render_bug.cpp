// render_bug.cpp: the draws of a picture with a bug in their state, their shader or their pipeline.
#include <raster/bugs/render_bug.h>

#include <raster/bugs/unnormalised_shader.h>
#include <raster/bugs/variant.h>

namespace raster {
namespace {

State with_bug(Bug bug, State state) {
    switch (bug) {
        case Bug::no_depth_test: state.depth_compare = Compare::always; break;
        case Bug::z_flipped: std::swap(state.viewport.near_depth, state.viewport.far_depth); break;
        case Bug::wrong_cull: state.cull = state.cull == Cull::front ? Cull::back : Cull::front; break;
        default: break;
    }
    return state;
}

DrawCounts draw_with_bug(Bug bug, SceneObserver& observer, Target& target, const PlannedDraw& planned) {
    DrawCounts counts;
    const BugVariant variant(bug, target.height());
    const auto visit = [&]<class S>(const S& shader, const auto& mesh, const State& state) {
        counts =
            detail::ObservedDraw<S, SceneObserver, const BugVariant>(target, shader, mesh, state, observer, variant)
                .run();
    };
    if (planned.frequency == ShadingFrequency::flat) {
        with_flat_shader(planned, visit);
    } else if (planned.frequency == ShadingFrequency::gouraud) {
        with_gouraud_shader(planned, visit);
    } else if (bug != Bug::no_renormalise) {
        with_runtime_pixel_shader(planned, visit);
    } else {
        with_runtime_pixel_shader(planned, [&]<Detail level>(const PixelShader<RuntimeModel, level>& right,
                                                             const auto& mesh, const State& state) {
            visit(UnnormalisedPixelShader<level>{right}, mesh, state);
        });
    }
    return counts;
}

}  // namespace

DrawCounts render_bug(Bug bug, SceneObserver& observer, Target& target, const Model& model,
                      const CameraMatrices& camera, const RenderOptions& options) {
    target.clear(options.background);
    DrawCounts counts;
    int draw = 0;
    const DrawPlan plan(model, options, target.extra_channels() > 0);
    plan.for_each(camera, [&](const PlannedDraw& right) {
        PlannedDraw planned = right;
        planned.state = with_bug(bug, planned.state);
        observer.on(DrawEvent{draw++, planned, target});
        counts += draw_with_bug(bug, observer, target, planned);
    });
    return counts;
}

DrawCounts render_bug(Bug bug, Target& target, const Model& model, const CameraMatrices& camera,
                      const RenderOptions& options) {
    struct Nobody {
    } nobody;
    SceneObserverFor observer(nobody);
    return render_bug(bug, observer, target, model, camera, options);
}

}  // namespace raster
