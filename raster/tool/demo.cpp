// demo.cpp: `raster demo`: a first picture without any file.
#include <filesystem>

#include <models/obj_text.h>
#include <raster/image/file.h>
#include <raster/scene/shapes.h>

#include "commands.h"
#include "picture.h"
#include "render_picture.h"
#include "report.h"
#include "step_page.h"
#include "view.h"

namespace raster::tool {
namespace {

constexpr const char* model_path = "teapot.obj";
constexpr const char* page_path = "teapot.step.html";

struct DemoArguments {
    ViewFlags view;
    PictureFlags picture;
    ThreadFlags threads;
    OutputPlan outputs;
    bool quiet = false;
};

Result<int> run_demo(DemoArguments& a) {
    const Result<ViewPlan> plan = ViewPlan::make(a.view);
    if (!plan) return plan.error();
    if (a.outputs.picture.empty()) a.outputs.picture = "teapot.png";
    if (const Status status = check(a.outputs, {a.view.json}); !status) return status.error();

    Model model = teapot();
    const RenderOptions options = a.picture.options_for(model);
    const PictureJob job{model, options, a.picture.display_for(model, options), *plan, a.outputs, false, true};
    Progress progress(ProgressMode::none);
    Status status = Done{};
    with_threads(a.threads, [&] { status = render_pictures(job, progress); });
    if (!status) return status.error();
    if (a.quiet || is_standard_output(a.outputs.picture)) return exit_done;

    StepOptions step;
    step.name = model_path;
    step.command = "raster step teapot.obj";
    step.display = job.display;
    Result<std::size_t> page = std::size_t(0);
    with_threads(a.threads, [&] { page = write_step_page(page_path, model, *plan, job.options, step); });
    if (!page) return page.error();

    // The model too, so that the next commands have something to work on; a file that is there is left alone.
    std::error_code ignored;
    const bool is_there = std::filesystem::exists(model_path, ignored);
    if (!is_there) {
        const std::string text =
            models::obj_text(model, "# The Utah teapot (Newell 1975), made by `raster demo`.\n", "");
        if (const Status written = write_file(model_path, std::as_bytes(std::span(text))); !written)
            return written.error();
    }
    const Status printed = print(a.outputs.picture + "  the picture: the Utah teapot, " +
                                 with_separators(std::int64_t(model.triangle_count())) + " triangles\n" + page_path +
                                 "  a page to open in a browser: how it was drawn, step by step\n" + model_path +
                                 (is_there ? "  was there already and is left alone\n" : "  the model\n") +
                                 "\nTry next:\n"
                                 "  raster render teapot.obj --shade flat --aov depth,normal\n"
                                 "  raster render teapot.obj --turntable 12 --light point:pos=0,6,6:color=#ffd0a0\n"
                                 "  raster step teapot.obj --stage depth --quiz 10 -o worksheet.html\n");
    return printed ? Result<int>(exit_done) : printed.error();
}

}  // namespace

Run add_demo(CLI::App& app) {
    const auto a = std::make_shared<DemoArguments>();
    add_value(app, "-o,--output", "FILE", a->outputs.picture, parse_path,
              "The picture: .png, .ppm or .pfm; - is a PNG on standard output. [teapot.png]")
        ->group("Picture");
    add_view_flags(app, a->view);
    add_picture_flags(app, a->picture);
    add_thread_flags(app, a->threads);
    add_switch(app, "-q,--quiet", a->quiet, "Say nothing but errors, and write the picture alone.")
        ->group("Other flags");
    return [a] { return run_demo(*a); };
}

}  // namespace raster::tool
