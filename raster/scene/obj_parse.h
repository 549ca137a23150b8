// obj_parse.h: the statements of an OBJ file into arrays, with the line of each face.
#pragma once

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include <raster/scene/normals.h>
#include <raster/scene/obj_material.h>

namespace raster::obj {

/// Indices from 0 into the arrays of ObjData; -1 is missing. Not yet checked against the arrays' ends, since a face
/// may come before its vertices.
struct Corner {
    std::int32_t position, uv, normal;
};

/// Faces from `first_face` on, up to the next run, with the same name, material and smoothing group.
struct Run {
    std::uint32_t first_face;
    int name;      ///< into ObjData::names
    int material;  ///< into ObjData::material_names; -1 before the first usemtl
    std::uint32_t smoothing;
};

/// What the file says, before any of it is judged as geometry.
struct ObjData {
    std::vector<glm::vec3> positions;       ///< NaN where the statement has no finite numbers
    std::vector<glm::vec3> colors;          ///< one a position, or empty when no vertex has one
    std::vector<glm::vec2> uvs;             ///< NaN likewise
    std::vector<glm::vec3> normals;         ///< unit length, or NaN
    std::vector<Corner> corners;            ///< of all faces, one after the other
    std::vector<std::uint32_t> face_ends;   ///< a face: where its corners end
    std::vector<std::uint32_t> face_lines;  ///< a face: its line
    std::vector<Run> runs;
    std::vector<std::string> names;
    std::vector<std::string> material_names;
    std::vector<std::uint32_t> material_lines;  ///< where each name is used first
    MaterialLibrary library;

    std::size_t bad_positions = 0;
    std::size_t bad_position_line = 0;  ///< the first
    std::string bad_position_word;
};

/// The warnings about indices that are taken for missing.
void report_bad_uv_index(const Place& place, Log& log);
void report_bad_normal_index(const Place& place, Log& log);

/// Reads the statements. Errors and warnings go to the log; after an error the data is incomplete. `finder` opens
/// material files, and may be null.
ObjData parse_statements(std::string_view bytes, std::string_view file, const Finder* finder, const ObjOptions& options,
                         Log& log);

}  // namespace raster::obj
