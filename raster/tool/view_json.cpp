// view_json.cpp: the camera file: written so that a reader gets the same floats back, read with care.
#include "view_json.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include <raster/image/file.h>
#include <raster/image/limits.h>
#include <raster/scene/transform.h>

namespace raster::tool {
namespace {

constexpr const char* camera_format = "raster-camera";
constexpr int camera_version = 1;
constexpr std::size_t max_file_bytes = std::size_t(64) << 20;  // `info --json` lists every part of a model

/// As C's %a and Python's float.hex: "-0x1.8p+1".
std::string hexadecimal(float number) {
    std::array<char, 32> room;
    const auto [end, code] =
        std::to_chars(room.data(), room.data() + room.size(), std::abs(number), std::chars_format::hex);
    return (std::signbit(number) ? "-0x" : "0x") + std::string(room.data(), end);
}

Json to_json(const glm::mat4& m) {
    Json decimal = Json::array(), hex = Json::array();
    for (int row = 0; row < 4; ++row) {
        Json numbers = Json::array(), texts = Json::array();
        for (int column = 0; column < 4; ++column) {
            numbers.push_back(m[column][row]);
            texts.push_back(hexadecimal(m[column][row]));
        }
        decimal.push_back(std::move(numbers));
        hex.push_back(std::move(texts));
    }
    Json json;
    json["rows"] = std::move(decimal);
    json["rows_hexadecimal"] = std::move(hex);
    return json;
}

/// Reads one document; the first mistake ends it.
class Reader {
public:
    Reader(std::string path, const Json& document) : path_(std::move(path)), document_(document) {}

    Result<View> read() {
        const Json* json = &document_;
        if (json->is_object() && json->value("format", "") == "raster-info" && json->contains("camera"))
            json = &(*json)["camera"];
        if (!json->is_object() || json->value("format", "") != camera_format)
            return wrong("no camera file: \"format\" is not \"raster-camera\" or \"raster-info\"");
        if (!json->contains("version") || (*json)["version"] != camera_version)
            return wrong("\"version\" is not 1, which is what this program reads");

        View view;
        if (!json->contains("viewport")) return wrong("\"viewport\" is missing");
        const Json& viewport = (*json)["viewport"];
        const std::int64_t width = whole(viewport, "width"), height = whole(viewport, "height");
        const std::string problem = size_problem(width, height);
        if (!problem.empty()) return wrong("viewport: " + problem);
        view.size = {int(width), int(height)};
        if (json->contains("parameters")) view.camera = parameters((*json)["parameters"]);
        if (json->contains("matrices")) {
            const Json& matrices = (*json)["matrices"];
            view.matrices.eye_from_world = matrix(matrices, "eye_from_world");
            view.matrices.clip_from_eye = matrix(matrices, "clip_from_eye");
            view.matrices.clip_from_world = matrices.contains("clip_from_world")
                                                ? matrix(matrices, "clip_from_world")
                                                : product(view.matrices.clip_from_eye, view.matrices.eye_from_world);
        } else if (view.camera && problem_.empty()) {
            const Result<CameraMatrices> made = camera_matrices(*view.camera, double(width) / double(height));
            if (!made) return wrong("parameters: " + made.error().message);
            view.matrices = *made;
        } else {
            fail("neither \"matrices\" nor \"parameters\" are there");
        }
        if (!problem_.empty()) return wrong(problem_);
        return view;
    }

private:
    Error wrong(const std::string& what) const { return {ErrorKind::bad_input, path_ + ": " + what}; }
    void fail(const std::string& what) {
        if (problem_.empty()) problem_ = what;
    }

    std::int64_t whole(const Json& json, const char* name) {
        if (!json.is_object() || !json.contains(name) || !json[name].is_number_integer()) {
            fail("\"" + std::string(name) + "\" is no whole number");
            return 0;
        }
        // Above INT64_MAX it would wrap; anything that large is refused by its size.
        const auto number = json[name].get<std::int64_t>();
        return json[name].is_number_unsigned() && number < 0 ? INT64_MAX / 4
                                                             : std::clamp<std::int64_t>(number, -1, 1 << 30);
    }

    float number(const Json& json, const std::string& name) {
        if (json.is_number()) {
            const float value = json.get<float>();
            if (std::isfinite(value)) return value;
        } else if (json.is_string()) {
            const std::string& text = json.get_ref<const std::string&>();
            const bool negative = text.starts_with('-');
            const std::size_t digits = negative ? 1 : 0;
            float value = 0;
            if (text.compare(digits, 2, "0x") == 0) {
                const char* end = text.data() + text.size();
                const auto [stop, code] = std::from_chars(text.data() + digits + 2, end, value, std::chars_format::hex);
                if (stop == end && code == std::errc() && std::isfinite(value)) return negative ? -value : value;
            }
        }
        fail("\"" + name + "\" holds something that is no finite number");
        return 0;
    }

    float named_number(const Json& json, const char* name) {
        if (json.is_object() && json.contains(name)) return number(json[name], name);
        fail("\"" + std::string(name) + "\" is missing");
        return 0;
    }

    glm::vec3 vector(const Json& json, const char* name) {
        glm::vec3 v(0.0f);
        if (json.is_object() && json.contains(name) && json[name].is_array() && json[name].size() == 3) {
            for (int i = 0; i < 3; ++i) v[i] = number(json[name][std::size_t(i)], name);
        } else {
            fail("\"" + std::string(name) + "\" is no list of three numbers");
        }
        return v;
    }

    Camera parameters(const Json& json) {
        Camera camera;
        camera.position = vector(json, "position");
        camera.focal_point = vector(json, "focal_point");
        camera.up = vector(json, "up");
        camera.view_angle = named_number(json, "view_angle_degrees");
        camera.near_plane = named_number(json, "near");
        camera.far_plane = named_number(json, "far");
        return camera;
    }

    glm::mat4 matrix(const Json& matrices, const char* name) {
        glm::mat4 m(1.0f);
        if (!matrices.is_object() || !matrices.contains(name) || !matrices[name].is_object()) {
            fail("\"" + std::string(name) + "\" is missing in \"matrices\"");
            return m;
        }
        const Json& json = matrices[name];
        const char* member = json.contains("rows_hexadecimal") ? "rows_hexadecimal" : "rows";
        bool is_4_by_4 = json.contains(member) && json[member].is_array() && json[member].size() == 4;
        for (int row = 0; is_4_by_4 && row < 4; ++row) {
            const Json& numbers = json[member][std::size_t(row)];
            is_4_by_4 = numbers.is_array() && numbers.size() == 4;
            for (int column = 0; is_4_by_4 && column < 4; ++column)
                m[column][row] = number(numbers[std::size_t(column)], name);
        }
        if (!is_4_by_4) fail("\"" + std::string(name) + "\" has no 4 rows of 4 numbers");
        return m;
    }

    std::string path_;
    const Json& document_;
    std::string problem_;
};

}  // namespace

Json to_json(const glm::vec3& v) { return Json::array({v.x, v.y, v.z}); }

Json to_json(const View& view) {
    Json json;
    json["format"] = camera_format;
    json["version"] = camera_version;
    json["viewport"]["width"] = view.size.width;
    json["viewport"]["height"] = view.size.height;
    if (view.camera) {
        Json& parameters = json["parameters"];
        parameters["position"] = to_json(view.camera->position);
        parameters["focal_point"] = to_json(view.camera->focal_point);
        parameters["up"] = to_json(view.camera->up);
        parameters["view_angle_degrees"] = view.camera->view_angle;
        parameters["near"] = view.camera->near_plane;
        parameters["far"] = view.camera->far_plane;
    }
    Json& matrices = json["matrices"];
    matrices["convention"] =
        "column vectors: clip = clip_from_eye * eye_from_world * world; visible is -w <= x, y, z <= w";
    matrices["eye_from_world"] = to_json(view.matrices.eye_from_world);
    matrices["clip_from_eye"] = to_json(view.matrices.clip_from_eye);
    matrices["clip_from_world"] = to_json(view.matrices.clip_from_world);
    return json;
}

std::string camera_json(const View& view) { return json_text(to_json(view)); }

Result<View> read_camera_json(const std::string& path) {
    const Result<Bytes> bytes = read_file(path, max_file_bytes);
    if (!bytes) return bytes.error();
    const auto* text = reinterpret_cast<const char*>(bytes->data());
    try {
        return Reader(path, Json::parse(text, text + bytes->size())).read();
    } catch (const Json::parse_error& error) {
        const std::size_t place = std::min(error.byte, bytes->size());
        const auto line = 1 + std::count(text, text + (place > 0 ? place - 1 : 0), '\n');
        return Error{ErrorKind::bad_input, path + ":" + std::to_string(line) + ": this is no JSON"};
    } catch (const Json::exception& error) {
        // Other mistakes: a number beyond float, a member of another type.
        std::string what = error.what();
        if (const std::size_t end = what.find("] "); end != std::string::npos) what.erase(0, end + 2);
        return Error{ErrorKind::bad_input, path + ": " + what};
    }
}

}  // namespace raster::tool
