// render.cpp: `raster render`: a model file in, pictures out.
#include <chrono>

#include "bug.h"
#include "commands.h"
#include "hash.h"
#include "outputs.h"
#include "picture.h"
#include "planes.h"
#include "progress.h"
#include "render_picture.h"
#include "report.h"
#include "view.h"

namespace raster::tool {
namespace {

constexpr int max_frames = 3600;

struct RenderArguments {
    LoadFlags load;
    ViewFlags view;
    PictureFlags picture;
    ThreadFlags threads;
    OutputPlan outputs;
    ProgressMode progress = ProgressMode::automatic;
    bool quiet = false;
    bool hash = false;
    std::optional<Bug> bug;
};

/// Everything that can be known to be wrong before the model is read.
Result<ViewPlan> check_arguments(RenderArguments& a) {
    Result<ViewPlan> plan = ViewPlan::make(a.view);
    if (!plan) return plan;
    if (a.outputs.frames > 0 && plan->is_from_file())
        return Error{ErrorKind::usage, "--turntable moves the camera, so it excludes --camera-json"};
    if (a.bug && (a.outputs.frames > 0 || !a.outputs.planes.empty()))
        return Error{ErrorKind::usage, "--bug draws one picture without planes: it excludes --turntable and --aov"};
    if (a.bug && a.picture.options.style != Style::surface)
        return Error{ErrorKind::usage, "--bug is about triangles: it excludes --style wireframe and points"};
    if (a.outputs.picture.empty()) a.outputs.picture = default_picture_path(a.load.model);
    if (const Status status = check(a.outputs, {a.load.model, a.view.json}); !status) return status.error();
    if (a.bug && (a.outputs.format == OutputFormat::pfm || is_standard_output(a.outputs.picture)))
        return Error{ErrorKind::usage, "--bug writes files of 8 bits: .png or .ppm"};
    return plan;
}

Result<int> run_render(RenderArguments& a) {
    const Result<ViewPlan> plan = check_arguments(a);
    if (!plan) return plan.error();
    Progress progress(a.progress);
    Timer timer;
    Result<Loaded> loaded = Loaded{};
    with_threads(a.threads, [&] { loaded = load(a.load, progress, a.quiet); });
    if (!loaded) return loaded.error();
    const double load_time = timer.lap();
    std::vector<std::string> paths = a.outputs.paths();
    if (a.bug) paths.push_back(beside(a.outputs.picture, ".difference.png"));
    const Status safe = check_no_input(paths, texture_paths(a.load.model, loaded->model));
    if (!safe) return safe.error();

    const RenderOptions options = a.picture.options_for(loaded->model);
    const Display display = a.picture.display_for(loaded->model, options);
    PictureJob job{loaded->model, options, display, *plan, a.outputs, a.hash, a.quiet};
    job.bug = a.bug;
    job.load_time = load_time;
    job.warnings = loaded->report.warnings.size() + loaded->report.warnings_left_out;
    Status status = Done{};
    with_threads(a.threads, [&] { status = render_pictures(job, progress); });
    return status ? Result<int>(exit_done) : status.error();
}

}  // namespace

Run add_render(CLI::App& app) {
    const auto a = std::make_shared<RenderArguments>();
    add_load_flags(app, a->load);
    add_value(
        app, "-o,--output", "FILE", a->outputs.picture, parse_path,
        "The picture: .png, .ppm (8 bits, no alpha) or .pfm (floats); - is a PNG on standard output. A file of that"
        " name is replaced, whole or not at all. [the model's name with .png, in the current folder]")
        ->group("Picture");
    add_view_flags(app, a->view);
    add_picture_flags(app, a->picture);
    add_style_flags(app, a->picture.options);
    add_value(app, "--aov", "PLANES", a->outputs.planes, parse_planes, planes_help)->group("Picture");
    const auto frames = [](std::string_view text) { return parse_count(text, 1, max_frames); };
    add_value(app, "--turntable", "N", a->outputs.frames, frames,
              "N pictures once round the model, 1 to 3600: NAME.000.png and so on.")
        ->group("Picture");
    add_value(app, "--camera-json-out", "FILE", a->outputs.camera_json, parse_path,
              "Writes the camera with its exact matrices, for --camera-json or another program; - is standard output."
              " Of a turntable, the first picture's.")
        ->group("Camera");
    add_switch(app, "--hash", a->hash,
               "Prints HASH  FILE on standard output, where HASH is the FNV-1a 64 of width, height (4 bytes each, the"
               " least significant first) and the pixels, R, G, B, A a byte each (for .pfm, 4 floats each), row by row"
               " from the top left. With -o - it goes to standard error.")
        ->group("Other flags");
    add_bug_flag(app, a->bug);
    add_thread_flags(app, a->threads);
    add_progress_flags(app, a->progress);
    add_switch(app, "-q,--quiet", a->quiet, "Say nothing but errors.")->group("Other flags");
    app.footer(
        "Examples:\n"
        "  raster render teapot.obj\n"
        "  raster render teapot.obj --size 1920x1080 --shade flat -o flat.png\n"
        "  raster render teapot.obj --style wireframe --cull back --shade flat\n"
        "  raster render teapot.obj --light point:pos=0,4,4:color=#ffd0a0\n"
        "  raster render teapot.obj --turntable 36 --background 1");
    return [a] { return run_render(*a); };
}

}  // namespace raster::tool
