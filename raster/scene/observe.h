// observe.h: a picture of a model drawn one pixel after the other, with an observer that is told of every step.
#pragma once

#include <raster/scene/draw_plan.h>

namespace raster {

/// A triangle's number in the model, from 0, by its number in a draw.
inline std::int64_t number_in_model(const PlannedDraw& draw, std::int64_t triangle) {
    const ShadingUniforms& u = draw.uniforms;
    if (u.triangle_numbers.empty()) return u.first_triangle + triangle;
    return u.triangle_numbers[std::size_t(triangle)];
}

/// Before a draw of a picture: which one it is, and all it was told.
struct DrawEvent {
    int draw;  ///< counted from 0
    const PlannedDraw& planned;
    const Target& target;  ///< as the draws before left it
};

/// All events of a picture as virtual functions, so that one compiled draw a shader serves every observer.
class SceneObserver {
public:
    virtual ~SceneObserver() = default;
    virtual WatchedPixels watched_pixels() const = 0;
    virtual void on(const DrawEvent&) = 0;
    virtual void on(const VertexEvent&) = 0;
    virtual void on(const AssembleEvent&) = 0;
    virtual void on(const ClipEvent&) = 0;
    virtual void on(const ClipPlaneEvent&) = 0;
    virtual void on(const ProjectEvent&) = 0;
    virtual void on(const CullEvent&) = 0;
    virtual void on(const SetupEvent&) = 0;
    virtual void on(const CoverageEvent&) = 0;
    virtual void on(const DepthEvent&) = 0;
    virtual void on(const InterpolateEvent&) = 0;
    virtual void on(const FragmentEvent&) = 0;
    virtual void on(const BlendEvent&) = 0;
};

/// Hands the events on that an observer has an `on` for. Without `watched_pixels` it watches the whole target.
template <class Observer>
class SceneObserverFor final : public SceneObserver {
public:
    explicit SceneObserverFor(Observer& observer) : observer_(observer) {}
    WatchedPixels watched_pixels() const override {
        if constexpr (requires { observer_.watched_pixels(); }) {
            return observer_.watched_pixels();
        } else {
            return {{0, 0, max_target_size, max_target_size}};
        }
    }
    void on(const DrawEvent& e) override { hand_on(e); }
    void on(const VertexEvent& e) override { hand_on(e); }
    void on(const AssembleEvent& e) override { hand_on(e); }
    void on(const ClipEvent& e) override { hand_on(e); }
    void on(const ClipPlaneEvent& e) override { hand_on(e); }
    void on(const ProjectEvent& e) override { hand_on(e); }
    void on(const CullEvent& e) override { hand_on(e); }
    void on(const SetupEvent& e) override { hand_on(e); }
    void on(const CoverageEvent& e) override { hand_on(e); }
    void on(const DepthEvent& e) override { hand_on(e); }
    void on(const InterpolateEvent& e) override { hand_on(e); }
    void on(const FragmentEvent& e) override { hand_on(e); }
    void on(const BlendEvent& e) override { hand_on(e); }

private:
    template <class Event>
    void hand_on(const Event& event) {
        if constexpr (Observes<Observer, Event>) observer_.on(event);
    }
    Observer& observer_;
};

/// The picture that `render` of scene/render.h makes, to the last bit at the watched pixels; others may stay as
/// cleared.
DrawCounts render_for(SceneObserver& observer, Target& target, const Model& model, const CameraMatrices& camera,
                      const RenderOptions& options);

/// The same for any object with some overloads of `on`.
template <class Observer>
DrawCounts render_observed(Target& target, const Model& model, const CameraMatrices& camera,
                           const RenderOptions& options, Observer& observer) {
    SceneObserverFor<Observer> all(observer);
    return render_for(all, target, model, camera, options);
}

/// The observed draws of one shading frequency each.
DrawCounts draw_flat(Target& target, const PlannedDraw& planned, SceneObserver& observer);
DrawCounts draw_gouraud(Target& target, const PlannedDraw& planned, SceneObserver& observer);
DrawCounts draw_pixel_shaded(Target& target, const PlannedDraw& planned, SceneObserver& observer);

}  // namespace raster
