// report_json.h: the little JSON that reports are written in and read back from (RFC 8259).
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace raster {

/// A JSON string with its quotes. Also safe inside an HTML script element: `<` is escaped. Bytes that are no UTF-8
/// become U+FFFD.
std::string json_string(std::string_view text);

/// Digits that read back as the same number; null for infinity and NaN, which JSON does not know.
std::string json_number(double value);

/// An object, written member by member. Values are JSON already.
class JsonObject {
public:
    JsonObject& add(std::string_view name, const std::string& json);
    JsonObject& text(std::string_view name, std::string_view value) { return add(name, json_string(value)); }
    JsonObject& number(std::string_view name, double value) { return add(name, json_number(value)); }
    std::string str() const { return "{" + members_ + "}"; }

private:
    std::string members_;
};

std::string json_array(const std::vector<std::string>& values);

/// A value that was read. Numbers, true and false are kept as they were written.
struct JsonValue {
    enum class Kind { null, literal, text, array, object } kind = Kind::null;
    std::string text;
    std::vector<JsonValue> items;
    std::map<std::string, JsonValue, std::less<>> members;

    /// The text of a member that is a string, a number, true or false; else "".
    std::string member_text(std::string_view name) const;
};

/// Reads a whole document, nested at most 64 deep; nothing if it is not JSON.
std::optional<JsonValue> parse_json(std::string_view document);

}  // namespace raster
