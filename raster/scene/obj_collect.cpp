// obj_collect.cpp: one function a statement.
#include <raster/scene/obj_collect.h>

#include <algorithm>
#include <cmath>

namespace raster::obj {
namespace {

constexpr float nan = std::numeric_limits<float>::quiet_NaN();

bool is_finite(float x) { return x - x == 0; }

}  // namespace

Collector::Collector(std::string_view file, const ObjOptions& options, Log& log, Start start)
    : here_{file},
      options_(options),
      log_(log),
      max_items_(3 * std::min(options.max_triangles, max_corners / 3)),
      start_(start) {
    if (start == Start::in_between) state_ = {0, Run::as_before, Run::as_before, Run::smoothing_as_before};
}

/// The index from 0; below 0 for one that is missing (0) or counts back beyond the start. Where that is not known yet,
/// what counts back is noted.
std::int64_t Collector::resolve(int index, std::size_t count, int part, std::int64_t& lowest) {
    if (index > 0) return std::int64_t(index) - 1;
    if (index == 0) return -1;
    const std::int64_t from_zero = std::int64_t(count) + index;
    if (start_ == Start::at_the_top) return from_zero;
    lowest = std::min(lowest, from_zero);
    counting_back_.push_back(std::uint32_t(3 * data_.corners.size()) + std::uint32_t(part));
    return from_zero;
}

bool Collector::has_room(std::size_t count, std::string_view what) {
    if (count < max_items_) return true;
    log_.fail(here_, "more " + std::string(what) + " statements than the limit of " + std::to_string(max_items_) +
                         ", three times that of triangles");
    return false;
}

void Collector::position(const Numbers& numbers) {
    if (!has_room(data_.positions.size(), "v")) return;
    ++log_.report().positions;
    const auto at = [&](int i) { return i < numbers.count ? numbers.value[i] + 0.0f : nan; };  // no -0
    const glm::vec3 p(at(0), at(1), at(2));
    const bool is_good = is_finite(p.x) && is_finite(p.y) && is_finite(p.z);
    if (!is_good && data_.bad_positions++ == 0) {
        data_.bad_position_line = here_.line;
        data_.bad_position_word = numbers.first_bad.empty() ? "too few numbers" : in_quotes(numbers.first_bad);
        // Otherwise the faces that use it will be counted.
        if (log_.is_strict()) log_.fail(here_, "no finite position: " + data_.bad_position_word);
    }
    data_.positions.push_back(is_good ? p : glm::vec3(nan));
    color(numbers);
    if (numbers.count == 4 && numbers.value[3] != 1)
        log_.note(here_, "a weight of a vertex (v x y z w) is not used here");
}

void Collector::color(const Numbers& numbers) {
    const bool has_color = numbers.count >= 6;
    if (has_color && data_.colors.empty()) data_.colors.assign(data_.positions.size() - 1, glm::vec3(1));
    if (!has_color && data_.colors.empty()) return;
    glm::vec3 c(1);
    if (has_color) {
        c = {numbers.value[3], numbers.value[4], numbers.value[5]};
        if (!is_finite(c.x) || !is_finite(c.y) || !is_finite(c.z)) {
            c = glm::vec3(1);
            log_.count(here_, "vertex colour that is no number, taken for white",
                       "vertex colours that are no numbers, taken for white");
        }
    }
    data_.colors.push_back(c);
}

void Collector::uv(const Numbers& numbers) {
    if (!has_room(data_.uvs.size(), "vt")) return;
    ++log_.report().texture_coordinates;
    const glm::vec2 t(numbers.value[0], numbers.count > 1 ? numbers.value[1] : 0.0f);
    const bool is_good = numbers.count > 0 && is_finite(t.x) && is_finite(t.y);
    if (!is_good)
        log_.count(here_, "texture coordinate that is no number, taken for missing",
                   "texture coordinates that are no numbers, taken for missing");
    data_.uvs.push_back(is_good ? t + 0.0f : glm::vec2(nan));
}

void Collector::normal(const Numbers& numbers) {
    if (!has_room(data_.normals.size(), "vn")) return;
    ++log_.report().normals;
    const glm::dvec3 n(numbers.value[0], numbers.value[1], numbers.value[2]);
    const double length = std::sqrt(glm::dot(n, n));
    const bool is_good = numbers.count >= 3 && numbers.finite() && length > 0;
    if (!is_good)
        log_.count(here_, "normal without a direction, taken for missing",
                   "normals without a direction, taken for missing");
    data_.normals.push_back(is_good ? glm::vec3(n / length) + 0.0f : glm::vec3(nan));
}

void Collector::face(std::span<const Corner> corners) {
    ++log_.report().faces;
    if (corners.size() < 3) {
        ++log_.report().dropped_faces;
        return log_.count(here_, "face dropped: fewer than 3 corners", "faces dropped: fewer than 3 corners");
    }
    triangles_ += corners.size() - 2;
    if (triangles_ > options_.max_triangles || data_.corners.size() + corners.size() > max_corners)
        return log_.fail(here_, "more triangles than the limit of " + std::to_string(options_.max_triangles));
    const bool may_be_below = start_ == Start::in_between;
    for (const Corner& c : corners) {
        if (c.position > 0 && c.uv >= 0 && c.normal >= 0) {  // as in most files
            data_.corners.push_back({c.position - 1, c.uv - 1, c.normal - 1});
            continue;
        }
        const std::int64_t p = resolve(c.position, data_.positions.size(), 0, lowest_.position);
        if (p < 0 && !(may_be_below && c.position < 0))
            return log_.fail(here_, "vertex " + std::to_string(c.position) + " does not exist: " +
                                        std::to_string(data_.positions.size()) + " were given so far");
        const std::int64_t t = resolve(c.uv, data_.uvs.size(), 1, lowest_.uv);
        const std::int64_t n = resolve(c.normal, data_.normals.size(), 2, lowest_.normal);
        if (may_be_below) {
            data_.corners.push_back({std::int32_t(p), std::int32_t(t), std::int32_t(n)});
            continue;
        }
        if (c.uv != 0 && t < 0) report_bad_uv_index(here_, log_);
        if (c.normal != 0 && n < 0) report_bad_normal_index(here_, log_);
        data_.corners.push_back({std::int32_t(p), t < 0 ? -1 : std::int32_t(t), n < 0 ? -1 : std::int32_t(n)});
    }
    begin_run();
    data_.face_ends.push_back(std::uint32_t(data_.corners.size()));
    data_.face_lines.push_back(std::uint32_t(std::min<std::size_t>(here_.line, 0xffffffffu)));
}

// Names are kept only when a face comes, so that a file of names alone takes no memory.
void Collector::use_new_name() {
    if (!new_name_) return;
    const auto [found, is_new] = name_numbers_.emplace(*new_name_, int(data_.names.size()));
    if (is_new) data_.names.push_back(*new_name_);
    state_.name = found->second;
    new_name_.reset();
}

void Collector::use_new_material() {
    if (!new_material_) return;
    const auto [found, is_new] = material_numbers_.emplace(*new_material_, int(data_.material_names.size()));
    if (is_new) {
        data_.material_names.push_back(*new_material_);
        data_.material_lines.push_back(std::uint32_t(std::min<std::size_t>(material_line_, 0xffffffffu)));
    }
    state_.material = found->second;
    new_material_.reset();
}

void Collector::begin_run() {
    use_new_name();
    use_new_material();
    state_.first_face = std::uint32_t(data_.face_ends.size());
    if (data_.runs.empty() || !data_.runs.back().continues_as(state_)) data_.runs.push_back(state_);
}

void Collector::material(std::string_view name) {
    new_material_ = name;
    material_line_ = here_.line;
}

void Collector::name(std::string_view text) {
    constexpr std::size_t longest_name = 127;  // each part has a copy
    new_name_ = text.substr(0, longest_name);
}

void Collector::smoothing(std::string_view group) {
    const float number = group == "off" ? 0.0f : group == "on" ? 1.0f : parse_number(group);
    if (number >= 0 && number < 4e9f) {
        state_.smoothing = std::uint32_t(number);
    } else {
        log_.warn(here_, "s without off or the number of a smoothing group");
    }
}

void report_bad_uv_index(const Place& place, Log& log) {
    log.count(place, "texture coordinate index that is 0, out of range or no number, taken for missing",
              "texture coordinate indices that are 0, out of range or no numbers, taken for missing");
}

void report_bad_normal_index(const Place& place, Log& log) {
    log.count(place, "normal index that is 0, out of range or no number, taken for missing",
              "normal indices that are 0, out of range or no numbers, taken for missing");
}

}  // namespace raster::obj
