// step.cpp: `raster step`: a model file in, one HTML page out, in which the reader steps through the draw.
#include <filesystem>

#include <raster/image/apng.h>
#include <raster/image/file.h>
#include <raster/step/stage_pictures.h>

#include "bug.h"
#include "commands.h"
#include "picture.h"
#include "progress.h"
#include "report.h"
#include "step_page.h"

namespace raster::tool {
namespace {

constexpr int max_questions = 100;
constexpr int frame_milliseconds = 1500;

struct StepArguments {
    LoadFlags load;
    ViewFlags view;
    PictureFlags picture;
    ThreadFlags threads;
    ProgressMode progress = ProgressMode::automatic;
    std::string output;
    std::string apng;  ///< path, or empty
    StepOptions options;
    bool quiet = false;
};

/// The command line without what chooses a place in the page, for the page to show.
std::string command_without_place(const CLI::App& app, const std::string& model) {
    const auto quoted = [](const std::string& word) {
        const bool plain = word.find_first_not_of("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789"
                                                  "._-+=:,/#@") == std::string::npos && !word.starts_with('#');
        return plain ? word : "'" + word + "'";
    };
    std::string text = "raster step " + quoted(model);
    for (const CLI::Option* option : app.get_options()) {
        const std::string name = option->get_name();
        if (option->count() == 0 || !name.starts_with("--")) continue;
        if (name == "--pixel" || name == "--triangle" || name == "--stage" || name == "--output" || name == "--quiz" ||
            name == "--apng" || name == "--quiet" || name == "--progress" || name == "--threads")
            continue;
        const bool is_switch = option->get_items_expected_max() == 0;
        for (const std::string& value : option->results()) {
            text += " " + name;
            if (is_switch) break;
            text += " " + quoted(value);
        }
    }
    return text;
}

/// The stages as an animation, for slides.
Status write_stages(const std::string& path, const Model& model, const ViewPlan& plan, const RenderOptions& options,
                    const Display& display) {
    const Result<View> view = plan.view_of(model);
    if (!view) return view.error();
    std::vector<Image8> frames;
    for (StagePicture& stage : stage_pictures(model, view->matrices, view->size.width, view->size.height, options,
                                              display))
        frames.push_back(std::move(stage.image));
    const Result<Bytes> file = encode_apng(frames, frame_milliseconds);
    if (!file) return file.error();
    return write_file(path, *file);
}

Result<int> run_step(StepArguments& a) {
    const Result<ViewPlan> plan = ViewPlan::make(a.view);
    if (!plan) return plan.error();
    if (a.output.empty()) a.output = step_page_path(a.load.model);
    if (const Status status = check_page(a.output, {a.load.model, a.view.json}); !status) return status.error();
    if (a.apng == a.output) return Error{ErrorKind::usage, a.apng + ": two outputs cannot have one name"};
    if (a.options.bug && (!a.apng.empty() || a.options.questions > 0))
        return Error{ErrorKind::usage, "--apng and --quiz are of the right pipeline, so they exclude --bug"};
    if (!a.apng.empty())
        if (const Status status = check_page(a.apng, {a.load.model, a.view.json, a.output}); !status)
            return status.error();

    Progress progress(a.progress);
    Result<Loaded> loaded = Loaded{};
    with_threads(a.threads, [&] { loaded = load(a.load, progress, a.quiet); });
    if (!loaded) return loaded.error();
    const Status safe = check_no_input({a.output, a.apng}, texture_paths(a.load.model, loaded->model));
    if (!safe) return safe.error();
    a.options.name = std::filesystem::path(a.load.model).filename().string();
    const RenderOptions options = a.picture.options_for(loaded->model);
    a.options.display = a.picture.display_for(loaded->model, options);
    Result<std::size_t> written = std::size_t(0);
    with_threads(a.threads, [&] { written = write_step_page(a.output, loaded->model, *plan, options, a.options); });
    if (!written) return written.error();
    if (!a.apng.empty())
        if (const Status status = write_stages(a.apng, loaded->model, *plan, options, a.options.display);
            !status) return status.error();
    if (!a.quiet) say(a.output + ": " + with_separators(std::int64_t(*written)) + " bytes; open it in a browser");
    return exit_done;
}

}  // namespace

Run add_step(CLI::App& app) {
    const auto a = std::make_shared<StepArguments>();
    add_load_flags(app, a->load);
    add_value(app, "-o,--output", "FILE", a->output, parse_path,
              "The page: one HTML file that opens from disk; - is standard output. [the model's name with .step.html,"
              " in the current folder]")
        ->group("Page");
    add_value(
        app, "--pixel", "X,Y", a->options.pixel,
        [](std::string_view t) -> Result<std::optional<glm::ivec2>> {
            const Result<glm::ivec2> pixel = parse_pixel(t);
            if (!pixel) return pixel.error();
            return std::optional(*pixel);
        },
        "The pixel of interest, from 0,0 at the top left. What lies around it is in the page. [one where surfaces "
        "overlap]")
        ->group("Page");
    add_value(
        app, "--triangle", "N", a->options.triangle,
        [](std::string_view t) -> Result<std::optional<std::int64_t>> {
            const Result<int> number = parse_count(t, 1, INT_MAX);
            if (!number) return number.error();
            return std::optional(std::int64_t(*number - 1));
        },
        "The triangle shown first, from 1 in the model's order, as by --aov triangle. [the one that gave the pixel its "
        "colour]")
        ->group("Page");
    Choices<std::string, std::size(stage_names)> stages;
    for (std::size_t i = 0; i < stages.size(); ++i) stages[i] = {stage_names[i], stage_names[i]};
    add_value(
        app, "--stage", "STAGE", a->options.stage,
        [stages](std::string_view text) { return parse_choice(text, stages); },
        "The stage shown first: vertex, assemble, clip, project, cull, setup, coverage, depth, interpolate, fragment"
        " or blend. [vertex]")
        ->group("Page");
    add_value(
        app, "--quiz", "N", a->options.questions, [](std::string_view t) { return parse_count(t, 1, max_questions); },
        "The page opens with a worksheet of N questions, 1 to 100, about this draw, to be printed, with the"
        " answers on a sheet of their own.")
        ->group("Page");
    std::string names;
    for (const BugInfo& info : bugs) names += (names.empty() ? "" : ", ") + std::string(info.name);
    add_value(app, "--bug", "NAME", a->options.bug, parse_bug,
              "The page of a pipeline with a classic mistake, which opens where it parts from the right one, with both"
              " pictures and their difference. Names, which `raster render --help` explains: " + names + ".")
        ->group("Page");
    add_value(
        app, "--apng", "FILE", a->apng, parse_path,
        "Also the stages as an animated PNG, for slides: points, lines, coverage, depth, normals, light, picture.")
        ->group("Page");
    add_view_flags(app, a->view);
    add_picture_flags(app, a->picture);
    add_thread_flags(app, a->threads);
    add_progress_flags(app, a->progress);
    add_switch(app, "-q,--quiet", a->quiet, "Say nothing but errors.")->group("Other flags");
    app.footer(
        "Pages are of triangles, not of the lines and points of `raster render --style`.\n"
        "Examples:\n"
        "  raster step teapot.obj\n"
        "  raster step teapot.obj --pixel 400,250 --stage depth\n"
        "  raster step bunny.obj --triangle 7 --shade gouraud\n"
        "  raster step teapot.obj --quiz 10 -o worksheet.html\n"
        "  raster step teapot.obj --bug wrong-cull -o wrong.html");
    return [a, &app] {
        a->options.command = command_without_place(app, a->load.model);
        return run_step(*a);
    };
}

}  // namespace raster::tool
