// obj_parse.h: the bytes of an OBJ file into arrays, on all threads.
#pragma once

#include <raster/scene/obj_collect.h>

namespace raster::obj {

/// Large enough that a piece's own costs are nothing beside reading it.
constexpr std::size_t usual_piece_bytes = std::size_t(1) << 17;

/// Reads the statements. Errors and warnings go to the log; after an error the data is incomplete. `finder` opens
/// material files, and may be null. Texts longer than `piece_bytes` are read in pieces, on all threads of the current
/// task arena; the result and the log are the same as if they were not.
ObjData parse_statements(std::string_view bytes, std::string_view file, const Finder* finder, const ObjOptions& options,
                         Log& log, std::size_t piece_bytes = usual_piece_bytes);

}  // namespace raster::obj
