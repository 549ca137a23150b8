// picture.cpp: flags to RenderOptions and ObjOptions.
#include "picture.h"

#include <algorithm>

#if !defined(RASTER_NO_THREADS)
#include <tbb/global_control.h>
#include <tbb/task_arena.h>
#endif

#include <raster/scene/shape_list.h>

#include "report.h"

namespace raster::tool {
namespace {

constexpr int max_threads = 256;
constexpr std::size_t max_warning_lines = 20;

constexpr Choices<ShadingFrequency, 3> shadings = {
    {{"flat", ShadingFrequency::flat}, {"gouraud", ShadingFrequency::gouraud}, {"phong", ShadingFrequency::phong}}};
constexpr Choices<Visibility, 2> visibilities = {{{"zbuffer", Visibility::zbuffer}, {"painter", Visibility::painter}}};
constexpr Choices<Style, 3> styles = {
    {{"surface", Style::surface}, {"wireframe", Style::wireframe}, {"points", Style::points}}};
constexpr Choices<Cull, 3> culls = {{{"none", Cull::none}, {"back", Cull::back}, {"front", Cull::front}}};
constexpr Choices<FillRule, 2> fill_rules = {{{"opengl", FillRule::bottom_left}, {"direct3d", FillRule::top_left}}};
constexpr Choices<Filter, 2> filters = {{{"nearest", Filter::nearest}, {"bilinear", Filter::bilinear}}};
constexpr Choices<Wrap, 3> wraps = {{{"repeat", Wrap::repeat}, {"clamp", Wrap::clamp}, {"mirror", Wrap::mirror}}};
constexpr Choices<Encoding, 3> encodings = {
    {{"auto", Encoding::automatic}, {"srgb", Encoding::srgb}, {"plain", Encoding::plain}}};
constexpr Choices<int, 1> sample_counts = {{{"1", 1}}};

std::string model_help() {
    std::string text =
        "A Wavefront OBJ file; its materials and textures are found beside it. Or a scene file, .json, whose lights,"
        " camera and settings count where no flag is given (docs/scene.md). Or a shape, shape:NAME[:KEY=VALUE]...:";
    for (const Shape& shape : shape_list()) {
        text += shape.name == shape_list().front().name ? " " : ", ";
        text += shape.name;
        for (const ShapeParameter& p : shape.parameters)
            text += (&p == &shape.parameters.front() ? " (" : ", ") + std::string(p.name);
        if (!shape.parameters.empty()) text += ")";
    }
    return text + ".";
}

}  // namespace

void add_load_flags(CLI::App& app, LoadFlags& flags) {
    app.add_option("MODEL", flags.model, model_help())->required()->group("Arguments");
    add_reading_flags(app, flags);
}

void add_reading_flags(CLI::App& app, LoadFlags& flags) {
    // Whatever command it is: a scene says what its flags would, where they are not given.
    app.final_callback([&app, &flags] {
        if (!is_scene(flags.model)) return;
        flags.scene = SceneFile::read(flags.model);
        if (!*flags.scene) return;
        if (const Status status = (*flags.scene)->set_flags(app); !status) flags.scene = status.error();
    });
    ObjOptions& o = flags.options;
    const auto angle = [](std::string_view text) { return parse_number_within(text, 0.0f, 180.0f); };
    add_value(app, "--crease-angle", "DEG", o.crease_angle, angle,
              "Where the file has no normals: edges sharper than this stay sharp, 0 to 180 degrees. [60, and as the"
              " file's smoothing groups say]")
        ->group("Model");
    add_switch(app, "--strict", o.strict, "Faults in the model's files are errors (exit 1) instead of warnings.")
        ->group("Model");
    add_switch(app, "--allow-outside", o.allow_outside, "Materials and textures may lie outside the model's folder.")
        ->group("Model");
}

Result<Loaded> load(const LoadFlags& flags, Progress& progress, bool quiet) {
    Loaded loaded;
    ObjOptions options = flags.options;
    options.progress = [&](double part) { progress.update(part); };
    if (flags.scene && !*flags.scene) return flags.scene->error();
    progress.begin("load");
    Result<Model> model = flags.scene              ? (*flags.scene)->load(options, loaded.report)
                          : is_shape(flags.model) ? load_shape(flags.model)
                                                   : load_obj(flags.model, options, loaded.report);
    progress.end();
    if (!quiet || !model) {
        const std::vector<std::string> messages = loaded.report.messages();
        for (std::size_t i = 0; i < std::min(messages.size(), max_warning_lines); ++i) say("warning: " + messages[i]);
        if (messages.size() > max_warning_lines)
            say("warning: " + counted(std::int64_t(messages.size() - max_warning_lines), "more kind") +
                " of fault; `raster info` lists them");
    }
    if (!model) return model.error();
    loaded.model = std::move(*model);
    return loaded;
}

void add_picture_flags(CLI::App& app, PictureFlags& flags) {
    RenderOptions& o = flags.options;
    const auto shading = [](CLI::Option* option) { option->group("Shading"); };
    shading(add_choice(app, "--shade", o.frequency, shadings,
                       "How often light is computed: once a triangle, a vertex (colours are interpolated), or a pixel"
                       " (normals are). [phong]"));
    std::string names;
    for (const std::string_view name : reflectance_names()) names += (names.empty() ? "" : ", ") + std::string(name);
    shading(add_value(app, "--reflectance", "MODEL", o.reflectance, parse_reflectance,
                      "How surfaces reflect light whose materials do not say it: " + names +
                          ". phong is (r v)^n, blinn-phong (n h)^n and blinn-phong-quarter (n h)^(n/4), n the"
                          " material's Ns; cook-torrance has Beckmann's facets and divides by 4 pi,"
                          " cook-torrance-pi by pi; he-torrance's roughness is 2 sigma / tau at tau = 2 um, and its"
                          " mirror shows lights as discs of 1 degree's radius; ward is the bounded form of 2010,"
                          " ward-1992 the first. [blinn-phong]"));
    shading(add_values(app, "--light", "LIGHT", flags.lights, parse_light, light_help));
    shading(add_values(app, "--material", "CHANGE", flags.materials, parse_material, material_help()));
    shading(app.add_flag("--two-sided,!--no-two-sided", o.two_sided,
                         "Light back faces from their own side, or like the front. [--two-sided]"));
    shading(add_choice(app, "--texture-filter", o.filter, filters,
                       "How a texture is read; v points up, from its bottom edge. [bilinear]"));
    shading(add_choice(app, "--texture-wrap", o.wrap, wraps,
                       "What lies beyond a texture's edges, where its material asks for no clamping. [repeat]"));
    shading(app.add_flag("--textures,!--no-textures", o.textures, "Use textures, or not. [--textures]"));

    const auto display = [](CLI::Option* option) { option->group("Display"); };
    display(
        add_choice(app, "--display", flags.encoding, encodings,
                   "All light is linear. srgb encodes it for the screen, decodes colour textures, and shows the"
                   " background as given; plain stores it as it is, clamped at 1, as textbooks do. auto is srgb where"
                   " a material's reflectance model is physical, and plain where all are lambert, phong or"
                   " blinn-phong. A .pfm picture is light in any case. [auto]"));
    const auto stops = [](std::string_view text) { return parse_number_within(text, -30.0f, 30.0f); };
    display(add_value(app, "--exposure", "STOPS", flags.exposure, stops,
                      "Doubles the light so many times before it is shown, -30 to 30. [0]"));

    const auto visibility = [](CLI::Option* option) { option->group("Visibility"); };
    visibility(add_choice(app, "--hidden", o.visibility, visibilities,
                          "How hidden surfaces are removed: by depth a pixel, or by drawing triangles from back to"
                          " front. [zbuffer]",
                          {"scanline"}));
    visibility(add_choice(app, "--cull", o.cull, culls, "Which faces are left out. [none]"));
    visibility(add_choice(app, "--fill-rule", o.fill_rule, fill_rules,
                          "Who owns a pixel centre exactly on an edge: left and bottom edges, or left and top."
                          " [opengl]"));
    visibility(add_choice(app, "--samples", flags.samples, sample_counts,
                          "Samples a pixel; 4, 8 and 16 are to come. [1]", {"4", "8", "16"}));
    add_value(app, "--background", "COLOR", o.background, parse_background,
              "R,G,B or R,G,B,A from 0 to 1, one number for a grey, #RRGGBB, #RRGGBBAA, or transparent; with an alpha"
              " below 1 the picture has an alpha channel. [0.2]")
        ->group("Picture");
}

void add_style_flags(CLI::App& app, RenderOptions& options) {
    constexpr const char* group = "Style";
    add_choice(app, "--style", options.style, styles,
               "What is drawn of the triangles: all of them, their edges, or their corners. What lies behind is seen"
               " through a wireframe; --cull back leaves out the far side of closed models. [surface]")
        ->group(group);
    add_value(
        app, "--line-width", "N", options.line_width, [](std::string_view text) { return parse_count(text, 1, 100); },
        "Of a wireframe, in pixels, 1 to 100. [1]")
        ->group(group);
    add_value(app, "--point-size", "N", options.point_size,
              [](std::string_view text) { return parse_number_within(text, 1.0f, 100.0f); },
              "Of points, in pixels, 1 to 100. [3]")
        ->group(group);
}

RenderOptions PictureFlags::options_for(Model& model) const {
    RenderOptions result = options;
    if (!lights.empty()) result.lights.clear();
    for (const std::vector<Light>& given : lights)
        result.lights.insert(result.lights.end(), given.begin(), given.end());
    for (const MaterialChange& change : materials) {
        for (Material& material : model.materials) change.apply_to(material);
        change.apply_to(result.default_material);
    }
    result.decode_srgb = display_for(model, result).srgb;
    return result;
}

Display PictureFlags::display_for(const Model& model, const RenderOptions& changed) const {
    const auto is_physical = [&](const Material& material) {
        return material.physically_based ||
               !is_empirical(find_reflectance(material.reflectance).value_or(changed.reflectance));
    };
    const bool physical = model.materials.empty() ? is_physical(changed.default_material)
                                                  : std::ranges::any_of(model.materials, is_physical);
    return {encoding == Encoding::srgb || (encoding == Encoding::automatic && physical), exposure};
}

void add_thread_flags(CLI::App& app, ThreadFlags& flags) {
    const auto parse = [](std::string_view text) { return parse_count(text, 1, max_threads); };
    add_value(app, "--threads", "N", flags.threads, parse,
              "Draw with this many threads, 1 to 256; the picture is the same. [one a processor]")
        ->group("Other flags");
}

void with_threads(const ThreadFlags& flags, const std::function<void()>& work) {
#if !defined(RASTER_NO_THREADS)
    if (flags.threads) {
        const auto count = std::size_t(*flags.threads);
        const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, count);
        tbb::task_arena arena(*flags.threads);
        arena.execute(work);
        return;
    }
#endif
    work();
}

}  // namespace raster::tool
