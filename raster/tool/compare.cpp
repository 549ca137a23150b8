// compare.cpp: `raster compare`: a picture by the library and by Mesa's OpenGL, and how far they are apart.
#include <raster/image/diff.h>
#include <raster/image/diff_picture.h>
#include <raster/image/diff_words.h>
#include <raster/image/file.h>

#include "commands.h"
#include "json.h"
#include "opengl_picture.h"
#include "outputs.h"
#include "picture.h"
#include "report.h"
#include "view.h"

namespace raster::tool {
namespace {

struct CompareArguments {
    LoadFlags load;
    ViewFlags view;
    PictureFlags picture;
    std::string output;  ///< path of our picture; the others stand beside it
    bool json = false;
};

Image8 to_image(const std::vector<std::uint32_t>& colors, int width, int height) {
    Image8 image(width, height, 3);
    std::uint8_t* out = image.samples.data();
    for (const std::uint32_t color : colors)
        for (int shift = 0; shift < 24; shift += 8) *out++ = std::uint8_t(color >> shift);
    return image;
}

/// What the comparison found.
struct Findings {
    std::string opengl;  ///< its version
    std::size_t drawn = 0, coverage = 0, depth = 0;  ///< pixels drawn by OpenGL; that only one draws; of other depth
    Figures colors;
};

Findings find(const OpenGlPicture& theirs, const Target& ours, const Figures& figures) {
    Findings f;
    f.colors = figures;
    constexpr std::uint32_t far_end = 0xffffff;
    for (std::size_t i = 0; i < theirs.depth.size(); ++i) {
        const std::uint32_t a = theirs.depth[i], b = ours.depth()[i];
        f.drawn += a != far_end;
        f.coverage += (a == far_end) != (b == far_end);
        f.depth += a != b;
    }
    return f;
}

std::string text_of(const Findings& f) {
    const auto row = [](std::string left, const std::string& right) {
        left.resize(22, ' ');
        return "  " + left + right + "\n";
    };
    const Figures& c = f.colors;
    return "compared with " + f.opengl + "\n" + row("pixels drawn", grouped((long long)f.drawn)) +
           row("coverage differs", grouped((long long)f.coverage) + " pixels") +
           row("24-bit depth differs", grouped((long long)f.depth) + " pixels") +
           row("colour differs", grouped(c.differing) + " pixels, at most " + exact_number(c.max) + "/255") +
           row("mean, RMS", significant_number(c.mean) + ", " + significant_number(c.rms)) +
           row("PSNR, SSIM, FLIP", psnr_number(c.psnr) + " dB, " + ssim_number(c.ssim) + ", " + flip_number(c.flip));
}

Json json_of(const Findings& f) {
    const Figures& c = f.colors;
    Json json;
    json["opengl"] = f.opengl;
    json["pixels_drawn"] = f.drawn;
    json["coverage_differs"] = f.coverage;
    json["depth_differs"] = f.depth;
    json["color_differs"] = c.differing;
    json["color_max"] = c.max;
    json["color_mean"] = c.mean;
    json["color_rms"] = c.rms;
    json["ssim"] = c.ssim;
    json["flip"] = c.flip;
    return json;
}

Result<int> run_compare(CompareArguments& a) {
    const Result<ViewPlan> plan = ViewPlan::make(a.view);
    if (!plan) return plan.error();
    if (a.output.empty()) a.output = default_picture_path(a.load.model);
    const std::string ours_path = beside(a.output, ".raster.png"), theirs_path = beside(a.output, ".opengl.png");
    const std::string difference_path = beside(a.output, ".difference.png");
    for (const std::string& path : {ours_path, theirs_path, difference_path})
        if (const Status status = check_writable(path); !status) return status.error();
    const auto gl = OpenGl::make();
    if (!gl) return gl.error();

    Progress progress(ProgressMode::automatic);
    Result<Loaded> loaded = load(a.load, progress, false);
    if (!loaded) return loaded.error();
    const RenderOptions options = a.picture.options_for(loaded->model);
    const Result<View> view = plan->view_of(loaded->model);
    if (!view) return view.error();
    const int width = view->size.width, height = view->size.height;

    Target target(width, height);
    render(target, loaded->model, view->matrices, options);
    const auto theirs = render_by_opengl(**gl, loaded->model, view->matrices, options, width, height);
    if (!theirs) return theirs.error();
    const Image8 our_image = to_image(target.color8(), width, height);
    const Image8 their_image = to_image(theirs->color, width, height);
    const Result<Diff> diff = diff_images(their_image, our_image);
    if (!diff) return diff.error();
    Findings findings = find(*theirs, target, *diff->figures);
    findings.opengl = (*gl)->version();

    for (const auto& [path, image] :
         {std::pair{&ours_path, our_image},
          {&theirs_path, their_image},
          {&difference_path, difference_picture(their_image, *diff)}}) {
        if (const Status written = write_image(*path, image); !written) return written.error();
        say(*path);
    }
    const Status printed = print(a.json ? json_text(json_of(findings)) : text_of(findings));
    return printed ? Result<int>(exit_done) : printed.error();
}

}  // namespace

Run add_compare(CLI::App& app) {
    const auto a = std::make_shared<CompareArguments>();
    add_load_flags(app, a->load);
    add_value(
        app, "-o,--output", "FILE", a->output, parse_path,
        "NAME.png writes NAME.raster.png, NAME.opengl.png and NAME.difference.png. [the model's name, in the current"
        " folder]")
        ->group("Picture");
    add_view_flags(app, a->view);
    add_picture_flags(app, a->picture);
    add_style_flags(app, a->picture.options);
    add_switch(app, "--json", a->json, "The figures as one JSON object.")->group("Other flags");
    app.footer(
        "The other picture is made by OSMesa, Mesa's OpenGL without a display (Debian:\n"
        "libosmesa6), with GLSL shaders written from the same formulas. Coverage and depth\n"
        "should be equal, colours differ by 1/255 at most: docs/conformance.md.\n"
        "Example:\n"
        "  raster compare teapot.obj --shade gouraud");
    return [a] { return run_compare(*a); };
}

}  // namespace raster::tool
