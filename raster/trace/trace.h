// trace.h: a picture as a list of events, one JSON object a line (docs/trace.md, docs/trace.schema.json).
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <raster/scene/display.h>
#include <raster/scene/observe.h>

namespace raster {

/// The stages by which a trace can be filtered, in their order. clip stands for the lines `clip` and `clip_plane`.
inline constexpr std::array<std::string_view, 11> trace_stages = {
    "vertex", "assemble", "clip", "project", "cull", "setup", "coverage", "depth", "interpolate", "fragment", "blend"};

/// What goes into a trace. The picture's own draws are run whatever is left out.
struct TraceFilter {
    /// Only these pixels, and only triangles whose box reaches one of them.
    std::optional<PixelBox> pixels;
    std::vector<std::int64_t> triangles;           ///< only these, by number in the model from 0; empty is all
    std::vector<std::string_view> stages;          ///< only these; empty is all
    std::size_t max_bytes = std::size_t(1) << 30;  ///< a longer trace is an error
};

/// What the header says besides the scene.
struct TraceSource {
    std::string program;  ///< "raster 0.1.0"
    std::string model;    ///< the file's name
    Display display = {}; ///< what becomes of the target's light on the screen
};

/// The trace of the picture that render() makes into `target`: a header line, a line for each draw, vertex and event,
/// and a last line with the counts. Error of kind usage when it would be longer than the filter allows.
Result<std::string> trace_picture(Target& target, const Model& model, const CameraMatrices& camera,
                                  const RenderOptions& options, const TraceFilter& filter, const TraceSource& source);

}  // namespace raster
