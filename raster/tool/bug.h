// bug.h: --bug: a picture as a rasterizer with a classic mistake draws it, beside the right one.
#pragma once

#include <optional>
#include <string>

#include <raster/bugs/bug.h>
#include <raster/scene/render.h>

#include "flags.h"
#include "view.h"

namespace raster::tool {

Result<std::optional<Bug>> parse_bug(std::string_view text);

void add_bug_flag(CLI::App& app, std::optional<Bug>& bug);

/// Draws the picture with the bug.
DrawCounts render_with_bug(Bug bug, Target& target, const Model& model, const View& view, const RenderOptions& options);

/// Writes right, wrong and difference side by side to `path`, and gives what there is to say: the mistake, how many
/// pixels differ, the first event at which the runs part.
Result<std::string> write_bug_difference(Bug bug, const Target& wrong, const Model& model, const View& view,
                                         const RenderOptions& options, const std::string& path);

}  // namespace raster::tool
