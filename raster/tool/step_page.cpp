// step_page.cpp: the stepper page as a file.
#include "step_page.h"

#include <raster/image/file.h>

namespace raster::tool {

std::string step_page_path(const std::string& model) {
    return beside(default_picture_path(model), ".step.html");
}

Status check_page(const std::string& path, const std::vector<std::string>& inputs) {
    if (const Status status = check_writable(path); !status) return status;
    return check_no_input({path}, inputs);
}

Result<std::size_t> write_step_page(const std::string& path, const Model& model, const ViewPlan& plan,
                                    const RenderOptions& options, const StepOptions& step) {
    const Result<View> view = plan.view_of(model);
    if (!view) return view.error();
    const Result<std::string> page =
        step_page(model, view->matrices, view->size.width, view->size.height, options, step);
    if (!page) return page.error();
    const Status written = write_file(path, std::as_bytes(std::span(*page)));
    if (!written) return written.error();
    return page->size();
}

}  // namespace raster::tool
