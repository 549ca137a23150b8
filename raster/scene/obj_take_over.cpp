// obj_take_over.cpp: what was collected from a later piece of the file, put behind what came before.
#include <raster/scene/obj_collect.h>

#include <algorithm>

namespace raster::obj {
namespace {

template <class T>
void append(std::vector<T>& all, const std::vector<T>& more) {
    all.insert(all.end(), more.begin(), more.end());
}

/// Line numbers beyond 32 bits stay at the largest.
std::uint32_t line_after(std::uint32_t line, std::size_t lines_before) {
    return std::uint32_t(std::min<std::size_t>(line + lines_before, 0xffffffffu));
}

}  // namespace

bool Collector::can_take_over(const Collector& next) const {
    const auto has_room = [&](std::size_t mine, std::size_t more) { return mine + more <= max_items_; };
    const auto reaches = [](std::size_t mine, std::int64_t lowest) { return std::int64_t(mine) + lowest >= 0; };
    return has_room(data_.positions.size(), next.data_.positions.size()) &&
           has_room(data_.uvs.size(), next.data_.uvs.size()) &&
           has_room(data_.normals.size(), next.data_.normals.size()) &&
           triangles_ + next.triangles_ <= options_.max_triangles &&
           data_.corners.size() + next.data_.corners.size() <= max_corners &&
           reaches(data_.positions.size(), next.lowest_.position) && reaches(data_.uvs.size(), next.lowest_.uv) &&
           reaches(data_.normals.size(), next.lowest_.normal);
}

void Collector::take_over(Collector& next, std::size_t lines_before) {
    ObjData& more = next.data_;
    for (const std::uint32_t which : next.counting_back_) {
        Corner& corner = more.corners[which / 3];
        if (which % 3 == 0) corner.position += std::int32_t(data_.positions.size());
        if (which % 3 == 1) corner.uv += std::int32_t(data_.uvs.size());
        if (which % 3 == 2) corner.normal += std::int32_t(data_.normals.size());
    }
    if (data_.colors.empty() && !more.colors.empty()) data_.colors.assign(data_.positions.size(), glm::vec3(1));
    if (!data_.colors.empty() && more.colors.empty()) more.colors.assign(more.positions.size(), glm::vec3(1));
    if (data_.bad_positions == 0 && more.bad_positions > 0) {
        data_.bad_position_line = more.bad_position_line + lines_before;
        data_.bad_position_word = more.bad_position_word;
    }
    data_.bad_positions += more.bad_positions;
    take_over_runs(next, lines_before);  // before the faces, which it counts
    append(data_.positions, more.positions);
    append(data_.colors, more.colors);
    append(data_.uvs, more.uvs);
    append(data_.normals, more.normals);
    const auto corners_before = std::uint32_t(data_.corners.size());
    append(data_.corners, more.corners);
    for (std::uint32_t& end : more.face_ends) end += corners_before;
    append(data_.face_ends, more.face_ends);
    for (std::uint32_t& line : more.face_lines) line = line_after(line, lines_before);
    append(data_.face_lines, more.face_lines);
    triangles_ += next.triangles_;
}

/// Names and materials have other numbers there, and what the first runs have may be what was in force here.
void Collector::take_over_runs(Collector& next, std::size_t lines_before) {
    const auto faces_before = std::uint32_t(data_.face_ends.size());
    const ObjData& more = next.data_;
    for (const Run& run : more.runs) {
        if (run.name != Run::as_before) name(more.names[std::size_t(run.name)]);
        if (run.material != Run::as_before) {
            new_material_ = more.material_names[std::size_t(run.material)];
            material_line_ = line_after(more.material_lines[std::size_t(run.material)], lines_before);
        }
        if (run.smoothing != Run::smoothing_as_before) state_.smoothing = run.smoothing;
        use_new_name();
        use_new_material();
        state_.first_face = faces_before + run.first_face;
        if (data_.runs.empty() || !data_.runs.back().continues_as(state_)) data_.runs.push_back(state_);
    }
    // What no face has used yet.
    if (next.new_name_) new_name_ = next.new_name_;
    if (next.new_material_) {
        new_material_ = next.new_material_;
        material_line_ = next.material_line_ + lines_before;
    }
    if (next.state_.smoothing != Run::smoothing_as_before) state_.smoothing = next.state_.smoothing;
}

}  // namespace raster::obj
