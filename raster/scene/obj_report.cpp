// obj_report.cpp: faults into sentences.
#include <raster/scene/obj_report.h>

namespace raster {

std::string LoadWarning::message() const {
    const std::string at = line == 0 ? "" : std::to_string(line);
    if (plural.empty()) {
        const std::string times = count == 1 ? "" : " (" + std::to_string(count) + " times)";
        return file + ":" + (at.empty() ? "" : at + ":") + " " + text + times;
    }
    const std::string first = at.empty() ? "" : (count == 1 ? " (line " : " (first at line ") + at + ")";
    return file + ": " + std::to_string(count) + " " + (count == 1 ? text : plural) + first;
}

std::vector<std::string> LoadReport::messages() const {
    std::vector<std::string> all;
    for (const LoadWarning& warning : warnings) all.push_back(warning.message());
    if (warnings_left_out > 0) all.push_back("and " + std::to_string(warnings_left_out) + " more warnings");
    return all;
}

namespace obj {
namespace {

constexpr std::size_t most_warnings = 100;
constexpr std::size_t longest_quote = 120;

/// The length of the well-formed UTF-8 sequence at the start of `text`, 0 if there is none. Control characters
/// from U+0080 to U+009F are taken for broken: terminals obey them.
std::size_t utf8_length(std::string_view text) {
    const auto byte = [&](std::size_t i) { return i < text.size() ? static_cast<unsigned char>(text[i]) : 0u; };
    const auto follows = [&](std::size_t i) { return (byte(i) & 0xc0u) == 0x80u; };
    const unsigned a = byte(0), b = byte(1);
    if (a >= 0xc2 && a < 0xe0 && follows(1)) return a == 0xc2 && b < 0xa0 ? 0 : 2;
    if (a >= 0xe0 && a < 0xf0 && follows(1) && follows(2))
        return (a == 0xe0 && b < 0xa0) || (a == 0xed && b >= 0xa0) ? 0 : 3;
    if (a >= 0xf0 && a < 0xf5 && follows(1) && follows(2) && follows(3))
        return (a == 0xf0 && b < 0x90) || (a == 0xf4 && b >= 0x90) ? 0 : 4;
    return 0;
}

Error make_error(const Place& place, std::string_view text) {
    std::string message(place.file);
    if (place.line > 0) message += ":" + std::to_string(place.line);
    return {ErrorKind::bad_input, message + ": " + std::string(text)};
}

}  // namespace

std::string printable(std::string_view text) {
    std::string result;
    for (std::size_t i = 0; i < text.size();) {
        if (i >= longest_quote) {
            result += "...";
            break;
        }
        const auto c = static_cast<unsigned char>(text[i]);
        const std::size_t length = c < 0x80 ? std::size_t(c >= 0x20 && c != 0x7f) : utf8_length(text.substr(i));
        if (length > 0) {
            result += text.substr(i, length);
        } else {
            constexpr char digits[] = "0123456789abcdef";
            result += {'\\', 'x', digits[c >> 4], digits[c & 15]};
        }
        i += length > 0 ? length : 1;
    }
    return result;
}

std::string in_quotes(std::string_view text) { return "'" + printable(text) + "'"; }

void Log::count(const Place& place, std::string_view singular, std::string_view plural, std::size_t times) {
    if (strict_) fail(place, std::string(singular));
    add(place, singular, plural, times);
}

void Log::warn(const Place& place, const std::string& text) {
    if (strict_) fail(place, text);
    add(place, text, "", 1);
}

void Log::note(const Place& place, const std::string& text) { add(place, text, "", 1); }

void Log::fail(const Place& place, const std::string& text) {
    if (!error_) error_ = make_error(place, text);
}

bool Log::can_take_over(const LoadReport& next) const {
    return next.warnings_left_out == 0 && report_.warnings.size() + next.warnings.size() < most_warnings;
}

void Log::take_over(const LoadReport& next, std::size_t lines_before) {
    for (const LoadWarning& warning : next.warnings)
        add({warning.file, warning.line + lines_before}, warning.text, warning.plural, warning.count);
    report_.positions += next.positions;
    report_.texture_coordinates += next.texture_coordinates;
    report_.normals += next.normals;
    report_.faces += next.faces;
    report_.dropped_faces += next.dropped_faces;
    report_.lines += next.lines;
    report_.points += next.points;
}

void Log::add(const Place& place, std::string_view text, std::string_view plural, std::size_t times) {
    std::string key(place.file);
    key += '\n';
    key += text;
    if (const auto found = known_.find(key); found != known_.end()) {
        report_.warnings[found->second].count += times;
        return;
    }
    if (report_.warnings.size() >= most_warnings) {
        report_.warnings_left_out += 1;
        return;
    }
    known_.emplace(std::move(key), report_.warnings.size());
    report_.warnings.push_back({std::string(place.file), place.line, times, std::string(text), std::string(plural)});
}

}  // namespace obj
}  // namespace raster
