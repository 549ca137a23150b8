// render_bug.h: a picture as a rasterizer with one bug draws it, and the first step at which it parts from the right
// one.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include <raster/bugs/bug.h>
#include <raster/scene/observe.h>
#include <raster/trace/event_lines.h>

namespace raster {

/// As render(), but with the bug, one pixel after the other, watched by the observer.
DrawCounts render_bug(Bug bug, SceneObserver& observer, Target& target, const Model& model,
                      const CameraMatrices& camera, const RenderOptions& options);
/// The same with nobody watching.
DrawCounts render_bug(Bug bug, Target& target, const Model& model, const CameraMatrices& camera,
                      const RenderOptions& options);

/// Where two runs part.
struct FirstDifference {
    std::int64_t event;  ///< how many events are equal before it
    std::string right;   ///< the event of the right run, as a line of a trace; empty when that has ended
    std::string wrong;   ///< the event in its place with the bug, likewise
    EventPlace place;    ///< of the wrong one; of the right one where that is empty
};

/// The first event at which the run with the bug differs from the right one; nothing when all events are equal. Draws'
/// states are not compared, since they may be the bug itself.
std::optional<FirstDifference> first_difference(Bug bug, int width, int height, const Model& model,
                                                const CameraMatrices& camera, const RenderOptions& options);

}  // namespace raster
