// sink.h: an observer whose events are virtual, so that shaders compile once for all that watch; and the draws it watches.
#pragma once

#include <raster/scene/draw_plan.h>
#include <raster/trace/events.h>

namespace raster::step {

/// Is told of every stage. What it does not want it leaves alone.
class Sink {
public:
    virtual ~Sink() = default;
    virtual void begin(const PlannedDraw&, int /*draw*/) {}
    virtual void on(const VertexEvent&) {}
    virtual void on(const AssembleEvent&) {}
    virtual void on(const ClipPlaneEvent&) {}
    virtual void on(const ClipEvent&) {}
    virtual void on(const ProjectEvent&) {}
    virtual void on(const CullEvent&) {}
    virtual void on(const SetupEvent&) {}
    virtual void on(const CoverageEvent&) {}
    virtual void on(const DepthEvent&) {}
    virtual void on(const InterpolateEvent&) {}
    virtual void on(const FragmentEvent&) {}
    virtual void on(const BlendEvent&) {}
};

/// The number in the model of triangle `triangle` of a draw.
inline std::int64_t model_number(const PlannedDraw& draw, std::int64_t triangle) {
    const ShadingUniforms& u = draw.uniforms;
    if (u.triangle_numbers.empty()) return triangle + u.first_triangle;
    return u.triangle_numbers[std::size_t(triangle)];
}

/// render() of scene/render.h with an observer and all planes of shaded_plane: the same picture.
DrawCounts watch(Target& target, const Model& model, const CameraMatrices& camera, const RenderOptions& options,
                 Sink& sink);

}  // namespace raster::step
