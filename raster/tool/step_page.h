// step_page.h: the stepper page as a file, for `step` and for `demo`.
#pragma once

#include <string>
#include <vector>

#include <raster/step/step.h>

#include "outputs.h"
#include "view.h"

namespace raster::tool {

/// "models/teapot.obj" gives "teapot.step.html": in the current folder.
std::string step_page_path(const std::string& model);

/// An error if the page cannot be written there or would replace an input.
Status check_page(const std::string& path, const std::vector<std::string>& inputs);

/// Makes and writes the page; gives its size in bytes.
Result<std::size_t> write_step_page(const std::string& path, const Model& model, const ViewPlan& plan,
                                    const RenderOptions& options, const StepOptions& step);

}  // namespace raster::tool
