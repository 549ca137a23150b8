// parse.cpp: strict readers on top of std::from_chars, which knows no locale and says where it stopped.
#include "parse.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <numeric>

#include <raster/image/limits.h>

namespace raster::tool {
namespace {

Error bad_value(std::string_view text, const std::string& what) {
    return {ErrorKind::usage, in_quotes(text) + " " + what};
}

/// `count` numbers between commas.
Result<std::vector<float>> parse_numbers(std::string_view text) {
    std::vector<float> numbers;
    for (const std::string_view piece : split(text, ',')) {
        const Result<float> number = parse_number(piece);
        if (!number) return number.error();
        numbers.push_back(*number);
    }
    return numbers;
}

int hex_digit(char c) {
    if (c >= '0' && c <= '9') return c - '0';
    if (c >= 'a' && c <= 'f') return c - 'a' + 10;
    if (c >= 'A' && c <= 'F') return c - 'A' + 10;
    return -1;
}

/// #RGB, #RRGGBB, #RRGGBBAA as numbers from 0 to 1; nothing for anything else.
std::vector<float> parse_hex_color(std::string_view text) {
    if (text.empty() || text[0] != '#') return {};
    text.remove_prefix(1);
    if (text.size() != 3 && text.size() != 6 && text.size() != 8) return {};
    const std::size_t digits = text.size() == 3 ? 1 : 2;
    std::vector<float> channels;
    for (std::size_t i = 0; i < text.size(); i += digits) {
        const int high = hex_digit(text[i]), low = hex_digit(text[i + digits - 1]);
        if (high < 0 || low < 0) return {};
        channels.push_back(float(16 * high + low) / 255.0f);
    }
    return channels;
}

}  // namespace

std::vector<std::string_view> split(std::string_view text, char separator) {
    std::vector<std::string_view> pieces;
    for (;;) {
        const std::size_t end = text.find(separator);
        pieces.push_back(text.substr(0, end));
        if (end == std::string_view::npos) return pieces;
        text.remove_prefix(end + 1);
    }
}

std::string in_quotes(std::string_view text) {
    constexpr std::size_t longest = 60;
    constexpr char hex[] = "0123456789abcdef";
    std::string out = "'";
    for (const char c : text.substr(0, longest)) {
        const auto byte = static_cast<unsigned char>(c);
        if (byte < 0x20 || byte == 0x7f) {
            out += {'\\', 'x', hex[byte >> 4], hex[byte & 15]};
        } else {
            out += c;
        }
    }
    return out + (text.size() > longest ? "...'" : "'");
}

Result<float> parse_number(std::string_view text) {
    std::string_view digits = text;
    if (digits.starts_with('+') && digits.size() > 1 && digits[1] != '-') digits.remove_prefix(1);
    float number = 0;
    const auto [end, code] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
    if (code == std::errc::result_out_of_range) return bad_value(text, "is beyond the range of a float");
    if (code != std::errc() || end != digits.data() + digits.size()) return bad_value(text, "is no number");
    if (!std::isfinite(number)) return bad_value(text, "is no finite number");
    return number;
}

Result<float> parse_number_within(std::string_view text, float low, float high) {
    Result<float> number = parse_number(text);
    if (number && !(*number >= low && *number <= high))
        return bad_value(text, "is not from " + to_text(low) + " to " + to_text(high));
    return number;
}

Result<int> parse_count(std::string_view text, int low, int high) {
    long long number = 0;
    const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), number);
    const std::string range = "from " + std::to_string(low) + " to " + std::to_string(high);
    if (end != text.data() + text.size() || code == std::errc::invalid_argument)
        return bad_value(text, "is no whole number " + range);
    if (code != std::errc() || number < low || number > high) return bad_value(text, "is not " + range);
    return int(number);
}

Result<glm::vec3> parse_vector(std::string_view text) {
    const Result<std::vector<float>> n = parse_numbers(text);
    if (!n || n->size() != 3) return bad_value(text, "is not X,Y,Z: three finite numbers between commas");
    return glm::vec3((*n)[0], (*n)[1], (*n)[2]);
}

Result<glm::vec3> parse_direction(std::string_view text) {
    std::string_view axis = text;
    const float sign = axis.starts_with('-') ? -1.0f : 1.0f;
    if (axis.starts_with('-') || axis.starts_with('+')) axis.remove_prefix(1);
    if (axis == "X" || axis == "x") return glm::vec3(sign, 0, 0);
    if (axis == "Y" || axis == "y") return glm::vec3(0, sign, 0);
    if (axis == "Z" || axis == "z") return glm::vec3(0, 0, sign);
    const Result<glm::vec3> v = parse_vector(text);
    if (!v) return bad_value(text, "is no direction: give +X, -X, +Y, -Y, +Z, -Z or three numbers X,Y,Z");
    if (*v == glm::vec3(0.0f)) return bad_value(text, "is no direction");
    return v;
}

Result<glm::vec3> parse_color(std::string_view text) {
    std::vector<float> channels = parse_hex_color(text);
    if (channels.empty()) {
        if (const Result<std::vector<float>> numbers = parse_numbers(text)) channels = *numbers;
    }
    if (channels.size() == 1) channels.assign(3, channels[0]);
    if (channels.size() != 3 || std::ranges::any_of(channels, [](float c) { return c < 0; }))
        return bad_value(text, "is no colour: give R,G,B of 0 and up, one number for a grey, or #RRGGBB");
    return glm::vec3(channels[0], channels[1], channels[2]);
}

Result<glm::vec4> parse_background(std::string_view text) {
    if (text == "transparent") return glm::vec4(0.0f);
    std::vector<float> channels = parse_hex_color(text);
    if (channels.empty()) {
        if (const Result<std::vector<float>> numbers = parse_numbers(text)) channels = *numbers;
    }
    if (channels.size() == 1) channels.assign(3, channels[0]);
    if (channels.size() == 3) channels.push_back(1.0f);
    const auto beyond = [](float c) { return c < 0 || c > 1; };
    if (channels.size() != 4 || std::ranges::any_of(channels, beyond))
        return bad_value(text,
                         "is no background: give R,G,B or R,G,B,A from 0 to 1, #RRGGBB, #RRGGBBAA, or transparent");
    return glm::vec4(channels[0], channels[1], channels[2], channels[3]);
}

Result<Size> parse_size(std::string_view text) {
    const std::size_t cross = text.find('x');
    std::array<std::int64_t, 2> sides{};
    const std::array<std::string_view, 2> pieces = {text.substr(0, cross),
                                                    cross == std::string_view::npos ? "" : text.substr(cross + 1)};
    for (std::size_t i = 0; i < 2; ++i) {
        const char* end = pieces[i].data() + pieces[i].size();
        const auto [stop, code] = std::from_chars(pieces[i].data(), end, sides[i]);
        if (stop != end || code == std::errc::invalid_argument)
            return bad_value(text, "is no size: give WIDTHxHEIGHT in pixels, such as 800x600");
        if (code != std::errc()) sides[i] = INT32_MAX;  // more digits than fit: too large whatever they are
        sides[i] = std::clamp<std::int64_t>(sides[i], INT32_MIN, INT32_MAX);
    }
    const std::string problem = size_problem(sides[0], sides[1]);
    if (!problem.empty()) return Error{ErrorKind::usage, problem};
    return Size{int(sides[0]), int(sides[1])};
}

Result<PixelRect> parse_rect(std::string_view text) {
    std::vector<int> numbers;
    for (const std::string_view piece : split(text, ',')) {
        const Result<int> number = parse_count(piece, std::numeric_limits<int>::min(), std::numeric_limits<int>::max());
        if (number) numbers.push_back(*number);
    }
    if (numbers.size() != 4 || split(text, ',').size() != 4 || numbers[2] < 1 || numbers[3] < 1)
        return bad_value(text, "is no rectangle; expected X,Y,WIDTH,HEIGHT in pixels, as 10,20,64,32");
    return PixelRect{numbers[0], numbers[1], numbers[2], numbers[3]};
}

Result<glm::ivec2> parse_pixel(std::string_view text) {
    const std::vector<std::string_view> pieces = split(text, ',');
    glm::ivec2 pixel;
    for (int i = 0; i < 2 && pieces.size() == 2; ++i) {
        const Result<int> number = parse_count(pieces[std::size_t(i)], 0, ImageLimits{}.max_side - 1);
        if (!number) break;
        pixel[i] = *number;
        if (i == 1) return pixel;
    }
    return bad_value(text, "is no pixel; expected X,Y from 0, as 120,88");
}

std::string to_text(const Size& size) { return std::to_string(size.width) + "x" + std::to_string(size.height); }

Result<Spec> parse_spec(std::string_view text) {
    Spec spec;
    bool first = true;
    for (const std::string_view piece : split(text, ':')) {
        const std::size_t equals = piece.find('=');
        if (equals == std::string_view::npos && first) {
            spec.name = piece;
        } else if (equals == std::string_view::npos || equals == 0 || equals + 1 == piece.size()) {
            return bad_value(text, "has " + in_quotes(piece) + " where KEY=VALUE is expected");
        } else {
            const std::string key(piece.substr(0, equals));
            const auto given = [&](const auto& value) { return value.first == key; };
            if (std::ranges::any_of(spec.values, given)) return bad_value(text, "has " + in_quotes(key) + " twice");
            spec.values.emplace_back(key, piece.substr(equals + 1));
        }
        first = false;
    }
    return spec;
}

std::string to_text(float number) {
    std::array<char, 32> room;
    return std::string(room.data(), std::to_chars(room.data(), room.data() + room.size(), number).ptr);
}

std::string to_text(const glm::vec3& v) { return to_text(v.x) + "," + to_text(v.y) + "," + to_text(v.z); }

std::string nearest(std::string_view text, const std::vector<std::string>& candidates) {
    // Levenshtein's distance, one row at a time.
    const auto distance = [&](std::string_view other) {
        std::vector<std::size_t> row(other.size() + 1);
        std::iota(row.begin(), row.end(), std::size_t(0));
        for (std::size_t i = 0; i < text.size(); ++i) {
            std::size_t diagonal = row[0];
            row[0] = i + 1;
            for (std::size_t j = 0; j < other.size(); ++j) {
                const std::size_t substituted = diagonal + (text[i] == other[j] ? 0 : 1);
                diagonal = row[j + 1];
                row[j + 1] = std::min({substituted, row[j] + 1, row[j + 1] + 1});
            }
        }
        return row.back();
    };
    std::string best;
    std::size_t best_distance = std::min<std::size_t>(text.size() / 3 + 1, 4);
    if (text.size() > 64) return best;
    for (const std::string& candidate : candidates) {
        // What was begun right is near too: --cam for --camera-position.
        const bool begun = text.size() >= 5 && candidate.starts_with(text);
        const std::size_t d = begun ? 1 : distance(candidate);
        if (d < best_distance || (d == best_distance && best.empty())) {
            best = candidate;
            best_distance = d;
        }
    }
    return best;
}

std::string did_you_mean(std::string_view text, const std::vector<std::string>& candidates) {
    const std::string best = nearest(text, candidates);
    return best.empty() ? "" : "; did you mean " + best + "?";
}

}  // namespace raster::tool
