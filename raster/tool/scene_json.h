// scene_json.h: values of a scene file: checked members, vectors, transforms, and the command line's words for them.
#pragma once

#include <span>

#include <glm/glm.hpp>

#include "json_tree.h"

namespace raster::tool {

/// Errors of all functions are bad_input with FILE:LINE:COLUMN.

/// An error unless the node is an object with no other members than these.
Status check_members(const JsonDocument& document, const JsonNode& node, const std::vector<std::string>& known);

/// The same value as a flag has it: a number, a text, true or false, or a list of them with a separator.
Result<std::string> flag_text(const JsonDocument& document, const JsonNode& node, char separator = ',');

/// A light or a material as --light and --material have it, NAME:KEY=VALUE:KEY=VALUE, out of a text of that kind or of
/// an object, in which `name_key` holds the name. `parse` is what reads it; where it finds a mistake, the error names
/// the place of the member.
template <class Parse>
auto read_spec(const JsonDocument& document, const JsonNode& node, const char* name_key, const Parse& parse)
    -> decltype(parse(std::string_view()));

/// A finite number; a list of three.
Result<float> read_number(const JsonDocument& document, const JsonNode& node);
Result<glm::vec3> read_vector(const JsonDocument& document, const JsonNode& node);

/// A list of steps, of which the first is done first: translate, scale, rotate, matrix.
Result<glm::mat4> read_transform(const JsonDocument& document, const JsonNode& node);

namespace detail {
/// The text of a specification out of the first `count` members besides the name.
Result<std::string> spec_text(const JsonDocument& document, const JsonNode& node, const char* name_key,
                              std::size_t count);
}  // namespace detail

template <class Parse>
auto read_spec(const JsonDocument& document, const JsonNode& node, const char* name_key, const Parse& parse)
    -> decltype(parse(std::string_view())) {
    const std::size_t members = node.is(JsonNode::Kind::object) ? node.items.size() : 0;
    const Result<std::string> text = detail::spec_text(document, node, name_key, members);
    if (!text) return text.error();
    auto value = parse(std::string_view(*text));
    if (value) return value;
    // The mistake is in the name, or in the first member with which there is one.
    const auto fails = [&](std::size_t count) {
        return !parse(std::string_view(*detail::spec_text(document, node, name_key, count)));
    };
    const JsonNode* name = node.find(name_key);
    std::size_t place = node.place;
    if (name && fails(0)) {
        place = name->place;
    } else {
        for (std::size_t count = members; count > 0 && fails(count); --count) place = node.places[count - 1];
    }
    return document.error_at(place, value.error().message);
}

}  // namespace raster::tool
