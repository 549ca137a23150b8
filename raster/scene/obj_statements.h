// obj_statements.h: text of an OBJ file, checked, through tinyobjloader, into a Collector.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include <raster/scene/obj_collect.h>

namespace raster::obj {

/// A part of the file, which starts and ends between statements.
struct Piece {
    std::string_view text;
    std::size_t lines_before = 0;
    std::function<void(std::size_t)> progress = {};  ///< told now and then how much of `text` is read; may be empty
};

/// An mtllib statement: what stands behind the word.
struct Mtllib {
    std::string names;
    std::size_t line;
};

struct PieceRead {
    std::size_t lines = 0;  ///< those before included
    std::size_t line_too_long = 0;          ///< 0: none; reading ended there
    std::size_t first_line_with_zeros = 0;  ///< 0: none
    std::vector<Mtllib> mtllibs;            ///< that were not read
};

/// Reads the statements, up to the first error. `material_files` opens material files; without it mtllib statements are
/// noted and nothing is opened.
PieceRead read_statements(const Piece& piece, const ObjOptions& options, MaterialFiles* material_files,
                          Collector& collect, Log& log);

}  // namespace raster::obj
