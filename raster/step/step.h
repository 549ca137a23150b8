// step.h: the stepper page: one HTML file in which a reader steps through an observed draw, from vertices to pixels.
#pragma once

#include <optional>
#include <string>

#include <raster/bugs/bug.h>
#include <raster/result.h>
#include <raster/scene/camera.h>
#include <raster/scene/display.h>
#include <raster/scene/render.h>

namespace raster {

/// What a page is about, and how much it may hold. Everything else is left out, and the page says so.
struct StepOptions {
    std::string name = "model";           ///< of the model, for the title
    std::string command;                  ///< that made the page, without --pixel and the like; shown to be run again
    std::optional<glm::ivec2> pixel;      ///< the pixel of interest; by default one where much happens
    std::optional<std::int64_t> triangle; ///< shown first, from 0; by default the one whose colour the pixel has
    std::string stage;                    ///< shown first: a name of stage_names, or empty
    std::optional<Bug> bug;               ///< of the run that is shown; the right one stands beside it
    Display display;                      ///< what becomes of the light on the screen
    int questions = 0;                    ///< of a worksheet that the page opens with; 0 for none
    int max_triangles = 40;               ///< that are shown from vertex to pixel
    int region_width = 25;                ///< pixels around the pixel of interest whose fragments are shown
    int region_height = 19;
    int max_fragments = 300;              ///< that are shown with all their numbers
    int max_picture_width = 800;          ///< larger pictures are cut to this around the pixel of interest
    int max_picture_height = 600;
};

/// The stages by name, in their order (docs/pipeline.md).
inline constexpr const char* stage_names[] = {"vertex",   "assemble", "clip",        "project",  "cull", "setup",
                                              "coverage", "depth",    "interpolate", "fragment", "blend"};

/// The page. The model is drawn with an observer, one pixel after the other, and what the page shows is what the
/// observer was told. Errors are of kind usage: a pixel outside the picture, a triangle or stage that is not there.
Result<std::string> step_page(const Model& model, const CameraMatrices& camera, int width, int height,
                              const RenderOptions& options, const StepOptions& step);

}  // namespace raster
