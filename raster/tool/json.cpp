// json.cpp: JSON for people too: short arrays on one line.
#include "json.h"

namespace raster::tool {
namespace {

bool is_flat(const Json& json) {
    for (const Json& element : json)
        if (element.is_structured()) return false;
    return true;
}

std::string plain(const Json& json) { return json.dump(-1, ' ', false, Json::error_handler_t::replace); }

void write(std::string& out, const Json& json, std::size_t indent) {
    if (!json.is_structured() || json.empty()) {
        out += plain(json);
        return;
    }
    const bool one_line = json.is_array() && is_flat(json);
    const std::string line = one_line ? "" : "\n" + std::string(indent + 2, ' ');
    out += json.is_array() ? '[' : '{';
    bool first = true;
    for (auto member = json.begin(); member != json.end(); ++member) {
        if (!first) out += one_line ? ", " : ",";
        first = false;
        out += line;
        if (json.is_object()) out += plain(member.key()) + ": ";
        write(out, *member, indent + 2);
    }
    if (!one_line) out += "\n" + std::string(indent, ' ');
    out += json.is_array() ? ']' : '}';
}

}  // namespace

std::string json_text(const Json& json) {
    std::string out;
    write(out, json, 0);
    return out + "\n";
}

}  // namespace raster::tool
