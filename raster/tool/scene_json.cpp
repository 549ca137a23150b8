// scene_json.cpp: strict readers of JSON values.
#include "scene_json.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include <raster/scene/transform.h>

#include "parse.h"

namespace raster::tool {
namespace {

using Kind = JsonNode::Kind;

std::string number_text(double number) {
    char text[40];
    return {text, std::to_chars(text, text + sizeof text, number).ptr};
}

Result<glm::mat4> read_rotation(const JsonDocument& document, const JsonNode& node) {
    if (const Status status = check_members(document, node, {"axis", "degrees"}); !status) return status.error();
    const JsonNode *axis = node.find("axis"), *degrees = node.find("degrees");
    if (!axis || !degrees) return document.error_at(node, "a rotation has an axis and degrees");
    const Result<std::string> text = flag_text(document, *axis);
    if (!text) return text.error();
    const Result<glm::vec3> direction = parse_direction(*text);
    if (!direction) return document.error_at(*axis, direction.error().message);
    const Result<float> angle = read_number(document, *degrees);
    if (!angle) return angle.error();
    return rotate(double(*angle), *direction);
}

Result<glm::mat4> read_matrix(const JsonDocument& document, const JsonNode& node) {
    const Error wrong = document.error_at(node, "a matrix has 4 rows of 4 numbers, the last of them [0, 0, 0, 1]");
    if (!node.is(Kind::array) || node.items.size() != 4) return wrong;
    glm::mat4 m(1.0f);
    for (int row = 0; row < 4; ++row) {
        const JsonNode& numbers = node.items[std::size_t(row)];
        if (!numbers.is(Kind::array) || numbers.items.size() != 4) return wrong;
        for (int column = 0; column < 4; ++column) {
            const Result<float> number = read_number(document, numbers.items[std::size_t(column)]);
            if (!number) return number.error();
            m[column][row] = *number;
        }
    }
    if (m[0][3] != 0 || m[1][3] != 0 || m[2][3] != 0 || m[3][3] != 1) return wrong;
    return m;
}

Result<glm::mat4> read_scale(const JsonDocument& document, const JsonNode& node) {
    glm::vec3 factors(0.0f);
    if (node.is(Kind::number)) {
        const Result<float> factor = read_number(document, node);
        if (!factor) return factor.error();
        factors = glm::vec3(*factor);
    } else if (node.is(Kind::array)) {
        const Result<glm::vec3> read = read_vector(document, node);
        if (!read) return read.error();
        factors = *read;
    } else {
        return document.error_at(node, "here a number or a list of three numbers is expected");
    }
    if (factors.x == 0 || factors.y == 0 || factors.z == 0)
        return document.error_at(node, "scaled by 0 nothing is left");
    return scale(factors);
}

Result<glm::mat4> read_step(const JsonDocument& document, const JsonNode& step) {
    if (const Status status = check_members(document, step, {"translate", "scale", "rotate", "matrix"}); !status)
        return status.error();
    if (step.items.size() != 1)
        return document.error_at(step, "a step of a transform is one of translate, scale, rotate, matrix");
    const std::string& what = step.keys.front();
    const JsonNode& value = step.items.front();
    if (what == "scale") return read_scale(document, value);
    if (what == "rotate") return read_rotation(document, value);
    if (what == "matrix") return read_matrix(document, value);
    const Result<glm::vec3> offset = read_vector(document, value);
    if (!offset) return offset.error();
    return translate(*offset);
}

}  // namespace

Status check_members(const JsonDocument& document, const JsonNode& node, const std::vector<std::string>& known) {
    if (!node.is(Kind::object)) return document.error_at(node, "here an object {...} is expected");
    for (std::size_t i = 0; i < node.keys.size(); ++i) {
        const std::string& key = node.keys[i];
        if (std::ranges::find(known, key) != known.end()) continue;
        std::string names;
        for (const std::string& name : known) names += (names.empty() ? "" : ", ") + name;
        return document.error_at(node.places[i],
                                 in_quotes(key) + " is none of " + names + did_you_mean(key, known));
    }
    return Done{};
}

Result<std::string> flag_text(const JsonDocument& document, const JsonNode& node, char separator) {
    switch (node.kind) {
        case Kind::boolean: return std::string(node.boolean ? "true" : "false");
        case Kind::number: return number_text(node.number);
        case Kind::text: return node.text;
        case Kind::array: {
            std::string text;
            for (const JsonNode& item : node.items) {
                if (item.is(Kind::array)) return document.error_at(item, "here a number or a text is expected");
                const Result<std::string> one = flag_text(document, item, separator);
                if (!one) return one;
                if (!text.empty()) text += separator;
                text += *one;
            }
            return text;
        }
        case Kind::null:
        case Kind::object: break;
    }
    return document.error_at(node, "here a number, a text or a list is expected");
}

Result<std::string> detail::spec_text(const JsonDocument& document, const JsonNode& node, const char* name_key,
                                      std::size_t count) {
    if (node.is(Kind::text)) return node.text;
    if (!node.is(Kind::object)) return document.error_at(node, "here an object {...} or a text is expected");
    std::string text;
    if (const JsonNode* name = node.find(name_key)) {
        if (!name->is(Kind::text)) return document.error_at(*name, "here a text is expected");
        text = name->text;
    }
    for (std::size_t i = 0; i < count; ++i) {
        const std::string& key = node.keys[i];
        if (key == name_key) continue;
        const Result<std::string> value = flag_text(document, node.items[i]);
        if (!value) return value;
        if (key.find_first_of(":=") != key.npos || value->find(':') != value->npos)
            return document.error_at(node.places[i], "a ':' or '=' cannot be in here");
        text += (text.empty() ? "" : ":") + key + "=" + *value;
    }
    return text;
}

Result<float> read_number(const JsonDocument& document, const JsonNode& node) {
    if (!node.is(Kind::number) || !std::isfinite(float(node.number)))
        return document.error_at(node, "here a number is expected");
    return float(node.number);
}

Result<glm::vec3> read_vector(const JsonDocument& document, const JsonNode& node) {
    if (!node.is(Kind::array) || node.items.size() != 3)
        return document.error_at(node, "here a list of three numbers is expected");
    glm::vec3 v(0.0f);
    for (int i = 0; i < 3; ++i) {
        const Result<float> number = read_number(document, node.items[std::size_t(i)]);
        if (!number) return number.error();
        v[i] = *number;
    }
    return v;
}

Result<glm::mat4> read_transform(const JsonDocument& document, const JsonNode& node) {
    if (!node.is(Kind::array)) return document.error_at(node, "a transform is a list of steps");
    glm::mat4 all(1.0f);
    for (const JsonNode& item : node.items) {
        const Result<glm::mat4> step = read_step(document, item);
        if (!step) return step;
        all = product(*step, all);
    }
    return all;
}

}  // namespace raster::tool
