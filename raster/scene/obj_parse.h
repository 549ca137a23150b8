// obj_parse.h: the bytes of an OBJ file, checked, through tinyobjloader, into arrays.
#pragma once

#include <raster/scene/obj_collect.h>

namespace raster::obj {

/// Reads the statements. Errors and warnings go to the log; after an error the data is incomplete. `finder` opens
/// material files, and may be null.
ObjData parse_statements(std::string_view bytes, std::string_view file, const Finder* finder, const ObjOptions& options,
                         Log& log);

}  // namespace raster::obj
