// pixel.cpp: `raster pixel`: why a pixel has its colour.
#include <raster/trace/history_text.h>

#include <cstdio>

#include "commands.h"
#include "json.h"
#include "picture.h"
#include "report.h"
#include "view.h"

namespace raster::tool {
namespace {

struct PixelArguments {
    LoadFlags load;
    ViewFlags view;
    PictureFlags picture;
    int x = 0, y = 0;
    bool json = false;
};

Status check_pixel(const PixelArguments& a, const Size& size) {
    for (const auto& [name, value, end] : {std::tuple("X", a.x, size.width), {"Y", a.y, size.height}})
        if (value >= end)
            return Error{ErrorKind::usage, std::string(name) + ": " + std::to_string(value) +
                                               " is outside the picture of " + to_text(size) +
                                               "; pixels are counted from 0, at the top left"};
    return Done{};
}

/// With what the screen gets, where that is not the colour itself.
std::string text_of(const PixelHistory& history, const std::optional<glm::vec4>& shown) {
    std::string text = history_text(history);
    if (!shown) return text;
    char line[64];
    const auto c = std::uint32_t(pack_rgba8(*shown));
    std::snprintf(line, sizeof line, " the picture shows this light as #%02X%02X%02X\n", c & 255, c >> 8 & 255,
                  c >> 16 & 255);
    return text + line;
}

std::string json_of(const PixelHistory& history, const std::optional<glm::vec4>& shown) {
    Json json = Json::parse(history_json(history));
    json["shown"] = shown ? Json{shown->r, shown->g, shown->b, shown->a} : Json(json["color"]);
    return json_text(json);
}

Result<int> run_pixel(PixelArguments& a) {
    const Result<ViewPlan> plan = ViewPlan::make(a.view);
    if (!plan) return plan.error();
    if (const Status status = check_pixel(a, plan->size()); !status) return status.error();
    Progress progress(ProgressMode::automatic);
    Result<Loaded> loaded = load(a.load, progress, false);
    if (!loaded) return loaded.error();
    RenderOptions options = a.picture.options_for(loaded->model);
    const Result<View> view = plan->view_of(loaded->model);
    if (!view) return view.error();

    // As `raster render` draws it: light that will be encoded for a screen is kept as floats.
    const Display display = a.picture.display_for(loaded->model, options);
    options.background = light_for(options.background, display);
    Target target(view->size.width, view->size.height,
                  display.is_plain() ? ColorFormat::rgba8 : ColorFormat::rgba_float);
    const PixelHistory history = pixel_history(target, loaded->model, view->matrices, options, a.x, a.y);
    std::optional<glm::vec4> shown;
    if (!display.is_plain()) shown = displayed(target, display).color(a.x, a.y);
    const Status printed = print(a.json ? json_of(history, shown) : text_of(history, shown));
    return printed ? Result<int>(exit_done) : printed.error();
}

}  // namespace

Run add_pixel(CLI::App& app) {
    const auto a = std::make_shared<PixelArguments>();
    add_load_flags(app, a->load);
    const auto place = [](std::string_view text) { return parse_count(text, 0, max_target_size - 1); };
    add_value(app, "X", "", a->x, place, "The pixel's column, from 0 at the left.")->required()->group("Arguments");
    add_value(app, "Y", "", a->y, place, "Its row, from 0 at the top.")->required()->group("Arguments");
    add_view_flags(app, a->view);
    add_picture_flags(app, a->picture);
    add_switch(app, "--json", a->json, "Everything as one JSON object: all stages with all their numbers.")
        ->group("Other flags");
    app.footer(
        "The flags of `raster render` give the pixel of that picture. Triangles are\n"
        "numbered from 1 in the order of the file, as by --aov triangle. e=(...) are the\n"
        "three edge functions at the pixel's centre in square subpixels, * where the\n"
        "centre lies on the edge. Verdicts: WON, ALL_REJECTED, NEVER_COVERED, CLIPPED,\n"
        "CULLED, BACKGROUND, NAN. Histories are of triangles: the lines and points of\n"
        "`raster render --style` have none.\n"
        "Example:\n"
        "  raster pixel teapot.obj 400 300");
    return [a] { return run_pixel(*a); };
}

}  // namespace raster::tool
