// json.h: JSON whose numbers are floats, written as short as they can be, with members in the order they were added.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace raster::tool {

using Json =
    nlohmann::basic_json<nlohmann::ordered_map, std::vector, std::string, bool, std::int64_t, std::uint64_t, float>;

/// Indented text with a final line end. Arrays of numbers stay on one line. Names in other encodings than UTF-8 get
/// replacement characters.
std::string json_text(const Json& json);

}  // namespace raster::tool
