// watch.h: the run that a page tells of: the picture's own draws, right or with a bug, before an observer.
#pragma once

#include <optional>

#include <raster/bugs/render_bug.h>
#include <raster/scene/display.h>

namespace raster::step {

/// A target in which the observed draws give what `raster render` shows: bytes, or light that a display will encode.
/// With a plane beside the colour, so that shaders tell the terms of the light; not with Gouraud shading, which would
/// round otherwise than in the picture.
inline Target watched_target(int width, int height, const RenderOptions& options, const Display& display) {
    return Target(width, height, display.is_plain() ? ColorFormat::rgba8 : ColorFormat::rgba_float,
                  DepthFormat::unorm24, options.frequency == ShadingFrequency::gouraud ? 0 : 1);
}

template <class Observer>
DrawCounts watch(Target& target, const Model& model, const CameraMatrices& camera, const RenderOptions& options,
                 Observer& observer, const std::optional<Bug>& bug = {}) {
    SceneObserverFor<Observer> all(observer);
    return bug ? render_bug(*bug, all, target, model, camera, options)
               : render_for(all, target, model, camera, options);
}

}  // namespace raster::step
