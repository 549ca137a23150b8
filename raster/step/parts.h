// parts.h: the parts of the page: its sources, and what fills them.
#pragma once

#include <raster/step/json_text.h>
#include <raster/step/record.h>
#include <raster/step/step.h>

namespace raster::step {

/// The page's source files in raster/step/page, put into the program when it is built.
namespace page_source {
extern const char* const html;
extern const char* const style;
extern const char* const script;
}  // namespace page_source

/// What a page is made of besides the record.
struct Scene {
    const Model& model;
    const CameraMatrices& camera;
    const RenderOptions& options;
    const StepOptions& step;
};

/// Everything in words and numbers; pictures come as data URLs. Triangles count from 1 here, as in all that the command
/// prints.
void write_scene(JsonText& json, const Scene& scene, const Record& record);
void write_triangles(JsonText& json, const Record& record);
void write_fragments(JsonText& json, const Scene& scene, const Record& record);
void write(JsonText& json, const ShadingRecord& shading);

/// The picture, its terms, the other shading frequencies, the painter's picture and, with a bug, the right one and
/// where they differ; cut to a rectangle.
Status write_pictures(JsonText& json, const Scene& scene, const Record& record);

/// The model's triangles for the 3D view, thinned out where there are many. Says into `left_out` if so.
void write_mesh(JsonText& json, const Model& model, const glm::mat4& world_from_object,
                std::vector<std::string>& left_out);

}  // namespace raster::step
