// scene_objects.h: the objects of a scene file, read, placed and painted.
#pragma once

#include <raster/scene/obj.h>

#include "json_tree.h"

namespace raster::tool {

/// All "objects" of a scene as one model in world space. Model files are found beside the scene, as textures are beside
/// a model. Errors are bad_input with FILE:LINE:COLUMN, or those of load_obj.
Result<Model> load_scene_objects(const JsonDocument& document, const ObjOptions& options, LoadReport& report);

}  // namespace raster::tool
