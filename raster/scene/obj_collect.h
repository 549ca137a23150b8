// obj_collect.h: the statements of an OBJ file as arrays, with the line of each face.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include <raster/scene/normals.h>
#include <raster/scene/obj_material.h>
#include <raster/scene/obj_tokens.h>

namespace raster::obj {

/// Faces from `first_face` on, up to the next run, with the same name, material and smoothing group.
struct Run {
    std::uint32_t first_face;
    int name;      ///< into ObjData::names
    int material;  ///< into ObjData::material_names; -1 before the first usemtl
    std::uint32_t smoothing;

    // Of a Collector that starts in between, until a statement says otherwise.
    static constexpr int as_before = -2;
    static constexpr std::uint32_t smoothing_as_before = 0xfffffffeu;  // no number of a group is so large

    bool continues_as(const Run& next) const {
        return name == next.name && material == next.material && smoothing == next.smoothing;
    }
};

constexpr std::size_t max_corners = std::numeric_limits<std::int32_t>::max() - 1;

/// What the file says, before any of it is judged as geometry.
struct ObjData {
    std::vector<glm::vec3> positions;       ///< NaN where the statement has no finite numbers
    std::vector<glm::vec3> colors;          ///< one a position, or empty when no vertex has one
    std::vector<glm::vec2> uvs;             ///< NaN likewise
    std::vector<glm::vec3> normals;         ///< unit length, or NaN
    /// Of all faces, one after the other: indices from 0 into the arrays above; -1 is missing. Not yet checked against
    /// the arrays' ends, since a face may come before its vertices.
    std::vector<Corner> corners;
    std::vector<std::uint32_t> face_ends;   ///< a face: where its corners end
    std::vector<std::uint32_t> face_lines;  ///< a face: its line
    std::vector<Run> runs;
    std::vector<std::string> names;
    std::vector<std::string> material_names;
    std::vector<std::uint32_t> material_lines;  ///< where each name is used first
    MaterialLibrary material_library;

    std::size_t bad_positions = 0;
    std::size_t bad_position_line = 0;  ///< the first
    std::string bad_position_word;
};

/// Where in the file a Collector starts.
enum class Start {
    at_the_top,
    in_between,  ///< what comes before is being read elsewhere: names, materials, groups and counts are not known yet
};

/// Takes one statement after the other into an ObjData. Faults go to the log.
class Collector {
public:
    Collector(std::string_view file, const ObjOptions& options, Log& log, Start start = Start::at_the_top);

    /// The line that the next statements stand in.
    void set_line(std::size_t line) { here_.line = line; }
    const Place& here() const { return here_; }

    void position(const Numbers& numbers);  ///< v x y z, v x y z w or v x y z r g b
    void uv(const Numbers& numbers);        ///< vt u or vt u v
    void normal(const Numbers& numbers);    ///< vn x y z

    /// f, with its corners as they are written.
    void face(std::span<const Corner> corners);
    void material(std::string_view name);    ///< usemtl
    void name(std::string_view text);        ///< o and g
    void smoothing(std::string_view group);  ///< s

    ObjData& data() { return data_; }

    /// Whether take_over() leaves everything as if the statements of `next`, a Collector that started in between, had
    /// come here one by one: no limit is passed, and no index counts back beyond the start.
    bool can_take_over(const Collector& next) const;
    /// Appends what `next` has collected. Its lines come after the first `lines_before`.
    void take_over(Collector& next, std::size_t lines_before);

private:
    /// The lowest index of a kind that counts back, from this Collector's start; it can lie before that.
    struct Lowest {
        std::int64_t position = 0, uv = 0, normal = 0;
    };

    std::int64_t resolve(int index, std::size_t count, int part, std::int64_t& lowest);
    void use_new_name();
    void use_new_material();
    void take_over_runs(Collector& next, std::size_t lines_before);
    bool has_room(std::size_t count, std::string_view what);
    void color(const Numbers& numbers);
    void begin_run();

    Place here_;
    const ObjOptions& options_;
    Log& log_;
    const std::size_t max_items_;  ///< of v, vt and vn statements each
    ObjData data_;
    std::unordered_map<std::string, int> name_numbers_, material_numbers_;
    std::optional<std::string> new_name_, new_material_;  ///< that no face has used yet
    std::size_t material_line_ = 0;
    Run state_{0, -1, -1, smoothing_by_angle};
    std::size_t triangles_ = 0;
    const Start start_;
    Lowest lowest_;
    std::vector<std::uint32_t> counting_back_;  ///< 3 times the corner and 0 to 2 for the part; in between only
};

/// The warnings about indices that are taken for missing.
void report_bad_uv_index(const Place& place, Log& log);
void report_bad_normal_index(const Place& place, Log& log);

}  // namespace raster::obj
