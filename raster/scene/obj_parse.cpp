// obj_parse.cpp: tinyobjloader reads the file, from a stream that checks each statement before handing it over.
//
// tinyobjloader tells statements apart and takes them to pieces. By itself it says nothing of bad numbers and
// indices, does not know the line, and opens whatever a file names; so it gets one clean statement at a time, and
// while it calls back about it, the checked numbers and the line of this statement are at hand.
#include <raster/scene/obj_parse.h>

#include <algorithm>
#include <cmath>
#include <istream>
#include <streambuf>
#include <unordered_map>

#include <tiny_obj_loader.h>

#include <raster/scene/obj_lines.h>
#include <raster/scene/obj_tokens.h>

namespace raster::obj {
namespace {

constexpr float nan = std::numeric_limits<float>::quiet_NaN();

// Curves, surfaces and display settings: right in an OBJ file, but nothing that is drawn here.
constexpr std::string_view unused_statements[] = {
    "vp",         "cstype",    "deg",   "bmat",  "step", "curv",  "curv2",    "surf",     "parm", "trim",   "hole",
    "scrv",       "sp",        "end",   "con",   "mg",   "bevel", "c_interp", "d_interp", "lod",  "maplib", "usemap",
    "shadow_obj", "trace_obj", "ctech", "stech", "call", "csh",   "bzp",      "bsp",      "cdc",  "cdp",    "res"};

bool is_finite(float x) { return x - x == 0; }

std::string join(std::string_view a, std::string_view b) { return std::string(a) + std::string(b); }

class Parser final : public std::streambuf, public tinyobj::MaterialReader {
public:
    Parser(std::string_view bytes, std::string_view file, const Finder* finder, const ObjOptions& options, Log& log)
        : size_(bytes.size()),
          lines_(bytes, options.max_line_bytes),
          file_(file),
          options_(options),
          material_files_(finder, options.max_material_bytes),
          max_items_(std::min<std::size_t>(3 * std::min(options.max_triangles, max_corners / 3), max_corners)),
          log_(log) {}

    ObjData run() {
        tinyobj::callback_t callbacks;
        callbacks.vertex_cb = [](void* self, float, float, float, float) { static_cast<Parser*>(self)->position(); };
        callbacks.texcoord_cb = [](void* self, float, float, float) { static_cast<Parser*>(self)->uv(); };
        callbacks.normal_cb = [](void* self, float, float, float) { static_cast<Parser*>(self)->normal(); };
        callbacks.index_cb = [](void* self, tinyobj::index_t* corners, int count) {
            static_cast<Parser*>(self)->face({corners, std::size_t(count)});
        };
        callbacks.usemtl_cb = [](void* self, const char* name, int) { static_cast<Parser*>(self)->material(name); };
        callbacks.group_cb = [](void* self, const char** names, int count) {
            static_cast<Parser*>(self)->group({names, std::size_t(count)});
        };
        callbacks.object_cb = [](void* self, const char* name) { static_cast<Parser*>(self)->name(name); };

        std::istream stream(this);
        stream.exceptions(std::ios::badbit);  // or the end of memory would look like the end of the file
        std::string warnings, errors;         // all of them are reported here, with their lines
        tinyobj::LoadObjWithCallback(stream, callbacks, this, this, &warnings, &errors);
        finish();
        return std::move(data_);
    }

private:
    static constexpr std::size_t max_corners = std::numeric_limits<std::int32_t>::max() - 1;

    Place here() const { return {file_, lines_.line()}; }

    // ------------------------------------------------------------------------ the stream that is handed over

    int_type underflow() override {
        while (!log_.failed() && lines_.next()) {
            tell_progress();
            if (!prepare(lines_.text())) continue;
            statement_ += '\n';
            setg(statement_.data(), statement_.data(), statement_.data() + statement_.size());
            return traits_type::to_int_type(statement_.front());
        }
        return traits_type::eof();
    }

    /// Makes statement_ what tinyobjloader shall see. False if it need not see it.
    bool prepare(std::string_view text) {
        const std::string_view key = next_word(text);
        if (key == "v" || key == "vt" || key == "vn") {
            numbers_ = parse_numbers(without_comment(text));
            statement_ = join(key, " 0");  // the numbers are read already, see parse_number
        } else if (key == "f") {
            prepare_face(without_comment(text));
        } else if (key == "usemtl" || key == "o") {
            statement_ = join(key, " ").append(text);
        } else if (key == "g") {
            statement_ = join("g ", text.empty() ? "default" : text);
        } else if (key == "mtllib") {
            // The names are taken from the line itself: tinyobjloader splits them at blanks and eats backslashes,
            // asks for one of them only, and never twice for the same.
            mtllib_names_ = text;
            statement_ = "mtllib " + std::to_string(lines_.line());
        } else {
            handle(key, text);
            return false;
        }
        return !log_.failed();
    }

    /// Statements that tinyobjloader does not call back about.
    void handle(std::string_view key, std::string_view text) {
        if (key == "s") {
            smoothing(without_comment(text));
        } else if (key == "l") {
            ++log_.report().lines;
        } else if (key == "p") {
            ++log_.report().points;
        } else if (std::find(std::begin(unused_statements), std::end(unused_statements), key) !=
                   std::end(unused_statements)) {
            log_.note(here(), join(key, " is not drawn here"));
        } else {
            log_.warn(here(), "unknown statement " + in_quotes(key));
        }
    }

    /// The corners in their plainest form. A position that cannot be is the end; anything else counts as missing.
    void prepare_face(std::string_view text) {
        statement_ = "f";
        for (std::string_view word = next_word(text); !word.empty(); word = next_word(text)) {
            const CornerWord corner = parse_corner(word);
            const auto bad = CornerWord::Index::bad, good = CornerWord::Index::good;
            if (!corner.well_formed)
                return log_.fail(here(), in_quotes(word) + " is not a corner such as 7, 7/2, 7//3 or 7/2/3");
            if (corner.state[0] == bad)
                return log_.fail(here(),
                                 in_quotes(corner.part[0]) + " is not the number of a vertex; they count from 1");
            if (corner.state[1] == bad) report_bad_uv_index(here(), log_);
            if (corner.state[2] == bad) report_bad_normal_index(here(), log_);
            statement_.append(" ").append(corner.part[0]);
            if (corner.state[1] == good) statement_.append("/").append(corner.part[1]);
            if (corner.state[2] == good) statement_.append(corner.state[1] == good ? "/" : "//").append(corner.part[2]);
        }
        if (statement_ == "f") {
            ++log_.report().faces;
            drop_small_face();
        }
    }

    // ------------------------------------------------------------------------------ what tinyobjloader found

    void position() {
        if (!has_room(data_.positions.size(), "v")) return;
        ++log_.report().positions;
        const auto at = [&](int i) { return i < numbers_.count ? numbers_.value[i] + 0.0f : nan; };  // no -0
        const glm::vec3 p(at(0), at(1), at(2));
        const bool is_good = is_finite(p.x) && is_finite(p.y) && is_finite(p.z);
        if (!is_good && data_.bad_positions++ == 0) {
            data_.bad_position_line = lines_.line();
            data_.bad_position_word = numbers_.first_bad.empty() ? "too few numbers" : in_quotes(numbers_.first_bad);
            // Otherwise the faces that use it will be counted.
            if (log_.is_strict()) log_.fail(here(), "no finite position: " + data_.bad_position_word);
        }
        data_.positions.push_back(is_good ? p : glm::vec3(nan));
        color();
        if (numbers_.count == 4 && numbers_.value[3] != 1)
            log_.note(here(), "a weight of a vertex (v x y z w) is not used here");
    }

    void color() {
        const bool has_color = numbers_.count >= 6;
        if (has_color && data_.colors.empty()) data_.colors.assign(data_.positions.size() - 1, glm::vec3(1));
        if (!has_color && data_.colors.empty()) return;
        glm::vec3 c(1);
        if (has_color) {
            c = {numbers_.value[3], numbers_.value[4], numbers_.value[5]};
            if (!is_finite(c.x) || !is_finite(c.y) || !is_finite(c.z)) {
                c = glm::vec3(1);
                log_.count(here(), "vertex colour that is no number, taken for white",
                           "vertex colours that are no numbers, taken for white");
            }
        }
        data_.colors.push_back(c);
    }

    void uv() {
        if (!has_room(data_.uvs.size(), "vt")) return;
        ++log_.report().texture_coordinates;
        const glm::vec2 t(numbers_.value[0], numbers_.count > 1 ? numbers_.value[1] : 0.0f);
        const bool is_good = numbers_.count > 0 && is_finite(t.x) && is_finite(t.y);
        if (!is_good)
            log_.count(here(), "texture coordinate that is no number, taken for missing",
                       "texture coordinates that are no numbers, taken for missing");
        data_.uvs.push_back(is_good ? t + 0.0f : glm::vec2(nan));
    }

    void normal() {
        if (!has_room(data_.normals.size(), "vn")) return;
        ++log_.report().normals;
        const glm::dvec3 n(numbers_.value[0], numbers_.value[1], numbers_.value[2]);
        const double length = std::sqrt(glm::dot(n, n));
        const bool is_good = numbers_.count >= 3 && numbers_.finite() && length > 0;
        if (!is_good)
            log_.count(here(), "normal without a direction, taken for missing",
                       "normals without a direction, taken for missing");
        data_.normals.push_back(is_good ? glm::vec3(n / length) + 0.0f : glm::vec3(nan));
    }

    void face(std::span<const tinyobj::index_t> corners) {
        ++log_.report().faces;
        if (corners.size() < 3) return drop_small_face();
        triangles_ += corners.size() - 2;
        if (triangles_ > options_.max_triangles || data_.corners.size() + corners.size() > max_corners)
            return log_.fail(here(), "more triangles than the limit of " + std::to_string(options_.max_triangles));
        for (const tinyobj::index_t& c : corners) {
            const std::int64_t p = from_zero(c.vertex_index, data_.positions.size());
            if (p < 0)
                return log_.fail(here(), "vertex " + std::to_string(c.vertex_index) + " does not exist: " +
                                             std::to_string(data_.positions.size()) + " were given so far");
            std::int64_t t = from_zero(c.texcoord_index, data_.uvs.size());
            std::int64_t n = from_zero(c.normal_index, data_.normals.size());
            if (c.texcoord_index != 0 && t < 0) report_bad_uv_index(here(), log_);
            if (c.normal_index != 0 && n < 0) report_bad_normal_index(here(), log_);
            data_.corners.push_back({std::int32_t(p), std::int32_t(std::max<std::int64_t>(t, -1)),
                                     std::int32_t(std::max<std::int64_t>(n, -1))});
        }
        const Run* last = data_.runs.empty() ? nullptr : &data_.runs.back();
        if (!last || last->name != name_ || last->material != material_ || last->smoothing != smoothing_)
            data_.runs.push_back({std::uint32_t(data_.face_ends.size()), name_, material_, smoothing_});
        data_.face_ends.push_back(std::uint32_t(data_.corners.size()));
        data_.face_lines.push_back(std::uint32_t(std::min<std::size_t>(lines_.line(), 0xffffffffu)));
    }

    /// The index from 0; below 0 for one that is missing (0) or counts back beyond the start.
    static std::int64_t from_zero(int index, std::size_t count) {
        return index > 0 ? std::int64_t(index) - 1 : index < 0 ? std::int64_t(count) + index : -1;
    }

    void material(std::string_view name) {
        const auto [found, is_new] = material_numbers_.emplace(name, int(data_.material_names.size()));
        if (is_new) {
            data_.material_names.emplace_back(name);
            data_.material_lines.push_back(std::uint32_t(lines_.line()));
        }
        material_ = found->second;
    }

    void group(std::span<const char* const> names) {
        std::string all;
        for (const char* each : names) all.append(all.empty() ? "" : " ").append(each);
        name(all);
    }

    void name(std::string_view text) {
        constexpr std::size_t longest_name = 127;  // each part has a copy
        text = text.substr(0, longest_name);
        const auto [found, is_new] = name_numbers_.emplace(text, int(data_.names.size()));
        if (is_new) data_.names.emplace_back(text);
        name_ = found->second;
    }

    void smoothing(std::string_view text) {
        const float number = text == "off" ? 0.0f : text == "on" ? 1.0f : parse_number(text);
        if (number >= 0 && number < 4e9f) {
            smoothing_ = std::uint32_t(number);
        } else {
            log_.warn(here(), "s without off or the number of a smoothing group");
        }
    }

    /// tinyobjloader asks for a material file. Its own materials and messages are not used.
    bool operator()(const std::string&, std::vector<tinyobj::material_t>*, std::map<std::string, int>*, std::string*,
                    std::string*) override {
        material_files_.read(mtllib_names_, here(), data_.library, log_);
        return false;
    }

    // -------------------------------------------------------------------------------------- faults and ends

    bool has_room(std::size_t count, std::string_view what) {
        if (count < max_items_) return true;
        log_.fail(here(), "more " + std::string(what) + " statements than the limit of " + std::to_string(max_items_) +
                              ", three times that of triangles");
        return false;
    }

    void drop_small_face() {
        ++log_.report().dropped_faces;
        log_.count(here(), "face dropped: fewer than 3 corners", "faces dropped: fewer than 3 corners");
    }

    void tell_progress() {
        if (!options_.progress || lines_.position() < next_progress_) return;
        options_.progress(0.7 * double(lines_.position()) / double(size_));
        next_progress_ = lines_.position() + size_ / 64;
    }

    void finish() {
        if (lines_.is_too_long())
            log_.fail(here(), "a line of more than " + std::to_string(options_.max_line_bytes) +
                                  " bytes; is this an OBJ file?");
        if (lines_.first_line_with_zeros() > 0)
            log_.warn({file_, lines_.first_line_with_zeros()}, "zero bytes, taken for blanks");
        log_.report().has_vertex_colors = !data_.colors.empty();
    }

    const std::size_t size_;
    LineReader lines_;
    const std::string_view file_;
    const ObjOptions& options_;
    MaterialFiles material_files_;
    const std::size_t max_items_;  ///< of v, vt and vn statements each
    Log& log_;
    ObjData data_;

    std::string statement_;  ///< what tinyobjloader reads at present
    Numbers numbers_;        ///< of that statement
    std::string_view mtllib_names_;

    std::unordered_map<std::string, int> name_numbers_, material_numbers_;
    int name_ = -1, material_ = -1;
    std::uint32_t smoothing_ = smoothing_by_angle;
    std::size_t triangles_ = 0;
    std::size_t next_progress_ = 0;
};

}  // namespace

void report_bad_uv_index(const Place& place, Log& log) {
    log.count(place, "texture coordinate index that is 0, out of range or no number, taken for missing",
              "texture coordinate indices that are 0, out of range or no numbers, taken for missing");
}

void report_bad_normal_index(const Place& place, Log& log) {
    log.count(place, "normal index that is 0, out of range or no number, taken for missing",
              "normal indices that are 0, out of range or no numbers, taken for missing");
}

ObjData parse_statements(std::string_view bytes, std::string_view file, const Finder* finder, const ObjOptions& options,
                         Log& log) {
    return Parser(bytes, file, finder, options, log).run();
}

}  // namespace raster::obj
