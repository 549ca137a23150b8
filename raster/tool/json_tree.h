// json_tree.h: JSON with the place of each value in its file, for messages that name line and column.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <raster/result.h>

namespace raster::tool {

/// A value and where it begins.
struct JsonNode {
    enum class Kind { null, boolean, number, text, array, object };
    Kind kind = Kind::null;
    bool boolean = false;
    double number = 0;
    std::string text;
    std::vector<JsonNode> items;     ///< of an array; of an object, parallel to `keys`
    std::vector<std::string> keys;   ///< in the order of the file, each once
    std::vector<std::size_t> places; ///< of the keys
    std::size_t place = 0;           ///< byte in the file

    bool is(Kind k) const { return kind == k; }
    /// The member of that name; null when there is none, or this is no object.
    const JsonNode* find(std::string_view key) const;
};

/// A document with its name and its text, which outlive the tree.
struct JsonDocument {
    std::string path;
    std::string text;
    JsonNode root;

    /// bad_input with "PATH:LINE:COLUMN: what", both counted from 1; columns are those of bytes.
    Error error_at(std::size_t place, const std::string& what) const;
    Error error_at(const JsonNode& node, const std::string& what) const { return error_at(node.place, what); }
};

/// Parses a text. Errors: what is not JSON, a member given twice, nesting deeper than 32.
Result<JsonDocument> parse_json(std::string path, std::string text);

}  // namespace raster::tool
