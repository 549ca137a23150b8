// obj_build.h: what an OBJ file says into a Model: checked, cut into triangles, with normals, without repetitions.
#pragma once

#include <raster/scene/obj_parse.h>

namespace raster::obj {

/// Takes the arrays of `data` apart as it goes, to save memory; materials stay. Errors and warnings go to the log;
/// after an error the model is incomplete. Part::material is an index into data.material_names.
Model build_model(ObjData& data, std::string_view file, const ObjOptions& options, Log& log);

}  // namespace raster::obj
