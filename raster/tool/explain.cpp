// explain.cpp: a model and two of its pictures in, causes out.
#include "explain.h"

#include <cstdio>

#include <raster/trace/explain.h>
#include <raster/trace/history_text.h>

#include "json.h"
#include "report.h"

namespace raster::tool {
namespace {

constexpr std::size_t most_clusters = 16;

std::string hex(const std::array<std::uint8_t, 3>& c) {
    char text[8];
    std::snprintf(text, sizeof text, "#%02X%02X%02X", c[0], c[1], c[2]);
    return text;
}

std::string describe(const DiffExplanation& e, std::size_t number) {
    const PixelRect& box = e.cluster.box;
    const std::string at = "(" + std::to_string(e.x) + "," + std::to_string(e.y) + ")";
    return "  " + std::to_string(number) + ". " + to_string(e.cause) + ": " + e.reason + "\n     " +
           counted(e.cluster.pixels, "pixel") + " within " + std::to_string(box.x) + "," + std::to_string(box.y) + "," +
           std::to_string(box.width) + "," + std::to_string(box.height) + "; at " + at + " expected " +
           hex(e.expected) + ", actual " + hex(e.actual) + "\n     pixel " + at + ": " + verdict_text(e.history) + "\n";
}

Json explanation_json(const DiffExplanation& e) {
    const PixelRect& box = e.cluster.box;
    Json json;
    json["cause"] = to_string(e.cause);
    json["reason"] = e.reason;
    json["pixels"] = e.cluster.pixels;
    json["box"] = {box.x, box.y, box.width, box.height};
    json["pixel"] = {e.x, e.y};
    json["expected"] = hex(e.expected);
    json["actual"] = hex(e.actual);
    json["verdict"] = verdict_text(e.history);
    return json;
}

}  // namespace

void add_explain_flags(CLI::App& app, ExplainFlags& flags) {
    add_value(
        app, "--explain", "MODEL", flags.load.model, parse_path,
        "Both pictures are of this model: tells the cause of each cluster of differing pixels from the history of a"
        " pixel in it: edge tie, depth tie, missing triangle, rounding of one step, shading. The flags below say"
        " how it was drawn; the size is the pictures'.")
        ->group("Why it differs");
    add_reading_flags(app, flags.load);
    add_view_flags(app, flags.view);
    add_picture_flags(app, flags.picture);
}

Result<Explained> explain(const ExplainFlags& flags, const Comparison& comparison) {
    if (!comparison.expected.image || !comparison.actual.image || !comparison.diff.figures) return Explained{};
    if (comparison.diff.figures->differing == 0) return Explained{};
    ViewFlags view_flags = flags.view;
    const auto [width, height] =
        std::visit([](const auto& image) { return std::pair(image.width, image.height); }, *comparison.expected.image);
    if (!view_flags.size) view_flags.size = Size{width, height};
    const Result<ViewPlan> plan = ViewPlan::make(view_flags);
    if (!plan) return plan.error();
    Progress progress(ProgressMode::none);
    Result<Loaded> loaded = load(flags.load, progress, true);
    if (!loaded) return loaded.error();
    const RenderOptions options = flags.picture.options_for(loaded->model);
    if (!flags.picture.display_for(loaded->model, options).is_plain())
        return Error{ErrorKind::usage,
                     "--explain: only pictures of the plain display can be explained; draw both with --display plain"};
    const Result<View> view = plan->view_of(loaded->model);
    if (!view) return view.error();

    Target target(view->size.width, view->size.height);
    const auto explanations = explain_diff(target, *comparison.expected.image, *comparison.actual.image,
                                           comparison.diff, loaded->model, view->matrices, options, most_clusters);
    if (!explanations) return explanations.error();
    const std::size_t clusters = diff_clusters(comparison.diff).size();
    Explained result;
    result.text = "why, by " + flags.load.model + ":\n";
    Json json = Json::array();
    for (std::size_t i = 0; i < explanations->size(); ++i) {
        result.text += describe((*explanations)[i], i + 1);
        json.push_back(explanation_json((*explanations)[i]));
    }
    if (clusters > explanations->size())
        result.text += "  and " + counted(std::int64_t(clusters - explanations->size()), "smaller cluster") + "\n";
    result.json = json.dump();
    return result;
}

}  // namespace raster::tool
