// trace.cpp: `raster trace`: every step that makes a picture, one JSON object a line.
#include <raster/trace/trace.h>

#include <algorithm>
#include <filesystem>

#include <raster/image/file.h>

#include "commands.h"
#include "outputs.h"
#include "picture.h"
#include "report.h"
#include "view.h"

namespace raster::tool {
namespace {

struct TraceArguments {
    LoadFlags load;
    ViewFlags view;
    PictureFlags picture;
    std::string output;
    std::optional<PixelRect> rect;
    std::vector<int> triangles;
    TraceFilter filter;
    bool quiet = false;
};

/// A list such as coverage,depth.
Result<std::vector<std::string_view>> parse_stages(std::string_view text) {
    std::vector<std::string_view> stages;
    for (const std::string_view word : split(text, ',')) {
        const auto found = std::ranges::find(trace_stages, word);
        if (found == trace_stages.end()) {
            std::string known;
            std::vector<std::string> names;
            for (const std::string_view stage : trace_stages) {
                names.emplace_back(stage);
                known += (known.empty() ? "" : ", ") + std::string(stage);
            }
            return Error{ErrorKind::usage, in_quotes(word) + " is none of " + known + did_you_mean(word, names)};
        }
        stages.push_back(*found);
    }
    return stages;
}

/// The chosen pixels, which must lie in the picture.
Status check_pixels(TraceArguments& a, const Size& size) {
    if (!a.rect) return Done{};
    const PixelRect& r = *a.rect;
    if (r.x < 0 || r.y < 0 || r.width > size.width - r.x || r.height > size.height - r.y)
        return Error{ErrorKind::usage, "the chosen pixels reach beyond the picture of " + to_text(size)};
    a.filter.pixels = PixelBox{r.x, r.y, r.x + r.width - 1, r.y + r.height - 1};
    return Done{};
}

Status check_triangles(TraceArguments& a, const Model& model) {
    for (const int number : a.triangles) {
        if (std::size_t(number) > model.triangle_count())
            return Error{ErrorKind::usage, "--triangle: there is no triangle " + std::to_string(number) +
                                               "; the model has " + std::to_string(model.triangle_count())};
        a.filter.triangles.push_back(number - 1);
    }
    return Done{};
}

Result<int> run_trace(TraceArguments& a) {
    const Result<ViewPlan> plan = ViewPlan::make(a.view);
    if (!plan) return plan.error();
    if (const Status status = check_pixels(a, plan->size()); !status) return status.error();
    if (a.output.empty()) a.output = beside(default_picture_path(a.load.model), ".trace.jsonl");
    if (const Status status = check_no_input({a.output}, {a.load.model, a.view.json}); !status) return status.error();
    if (const Status status = check_writable(a.output); !status) return status.error();
    Progress progress(ProgressMode::automatic);
    Result<Loaded> loaded = load(a.load, progress, a.quiet);
    if (!loaded) return loaded.error();
    if (const Status status = check_triangles(a, loaded->model); !status) return status.error();
    if (const Status status = check_no_input({a.output}, texture_paths(a.load.model, loaded->model)); !status)
        return status.error();
    RenderOptions options = a.picture.options_for(loaded->model);
    const Result<View> view = plan->view_of(loaded->model);
    if (!view) return view.error();

    // As `raster render` draws it: light that will be encoded for a screen is kept as floats.
    const Display display = a.picture.display_for(loaded->model, options);
    options.background = light_for(options.background, display);
    Target target(view->size.width, view->size.height,
                  display.is_plain() ? ColorFormat::rgba8 : ColorFormat::rgba_float);
    const TraceSource source{"raster " RASTER_VERSION, std::filesystem::path(a.load.model).filename().string(),
                             display};
    const Result<std::string> trace = trace_picture(target, loaded->model, view->matrices, options, a.filter, source);
    if (!trace) return trace.error();
    if (const Status status = write_file(a.output, std::as_bytes(std::span(*trace))); !status) return status.error();
    if (!a.quiet)
        say((is_standard_output(a.output) ? "standard output" : a.output) + ": " +
            counted(std::int64_t(std::ranges::count(*trace, '\n')), "line") + ", " +
            counted(std::int64_t(trace->size()), "byte"));
    return exit_done;
}

}  // namespace

Run add_trace(CLI::App& app) {
    const auto a = std::make_shared<TraceArguments>();
    add_load_flags(app, a->load);
    const auto trace = [](CLI::Option* option) { option->group("Trace"); };
    trace(add_value(app, "-o,--output", "FILE", a->output, parse_path,
                    "The trace; - is standard output. [the model's name with .trace.jsonl, in the current folder]"));
    const auto pixel = [](std::string_view text) -> Result<std::optional<PixelRect>> {
        const Result<glm::ivec2> place = parse_pixel(text);
        if (!place) return place.error();
        return std::optional(PixelRect{place->x, place->y, 1, 1});
    };
    const auto rect = [](std::string_view text) -> Result<std::optional<PixelRect>> {
        const Result<PixelRect> r = parse_rect(text);
        if (!r) return r.error();
        return std::optional(*r);
    };
    CLI::Option* one =
        add_value(app, "--pixel", "X,Y", a->rect, pixel, "Only this pixel, and the triangles whose box reaches it.");
    trace(one);
    CLI::Option* some = add_value(app, "--rect", "X,Y,W,H", a->rect, rect, "Only these pixels, likewise.");
    trace(some);
    some->excludes(one);
    const auto number = [](std::string_view text) { return parse_count(text, 1, std::numeric_limits<int>::max()); };
    trace(add_values(app, "--triangle", "N", a->triangles, number,
                     "Only this triangle, counted from 1 in the order of the file; may be given again."));
    trace(add_value(app, "--stage", "STAGES", a->filter.stages, parse_stages,
                    "Only these: a list of vertex, assemble, clip, project, cull, setup, coverage, depth, interpolate,"
                    " fragment, blend."));
    add_view_flags(app, a->view);
    add_picture_flags(app, a->picture);
    add_switch(app, "-q,--quiet", a->quiet, "Say nothing but errors.")->group("Other flags");
    app.footer(
        "docs/trace.md and docs/trace.schema.json tell what the lines mean. Traces are of\n"
        "triangles, not of the lines and points of `raster render --style`.\n"
        "Examples:\n"
        "  raster trace teapot.obj --pixel 400,300 -o -\n"
        "  raster trace teapot.obj --triangle 831 --stage vertex,clip,project,setup\n"
        "  raster trace teapot.obj --size 64x48");
    return [a] { return run_trace(*a); };
}

}  // namespace raster::tool
