// obj_tokens.cpp: numbers that do not depend on the locale, and indices with a range.
#include <raster/scene/obj_tokens.h>

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <limits>
#include <system_error>

#include <raster/scene/obj_lines.h>

namespace raster::obj {
namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// Whether a number beyond the range of double is a large one. Its decimal exponent tells: that of its first
/// digit that is not 0, and the exponent it is written with.
bool is_large(std::string_view number) {
    const std::size_t e = std::min(number.find_first_of("eE"), number.size());
    const std::string_view mantissa = number.substr(0, e);
    const auto point = std::int64_t(std::min(mantissa.find('.'), mantissa.size()));
    const auto first = std::int64_t(std::min(mantissa.find_first_of("123456789"), mantissa.size()));
    bool is_negative = false;
    std::int64_t exponent = 0;
    for (const char c : number.substr(e)) {
        if (c == '-') is_negative = true;
        if (is_digit(c)) exponent = std::min<std::int64_t>(10 * exponent + (c - '0'), 1'000'000'000'000);
    }
    return (is_negative ? -exponent : exponent) + (point - first) > 0;
}

CornerWord::Index check_index(std::string_view part) {
    if (part.empty()) return CornerWord::Index::missing;
    if (part.front() == '+') part.remove_prefix(1);
    std::int32_t value = 0;
    const auto [end, error] = std::from_chars(part.data(), part.data() + part.size(), value);
    const bool is_integer = error == std::errc() && end == part.data() + part.size();
    return is_integer && value != 0 && value != std::numeric_limits<std::int32_t>::min() ? CornerWord::Index::good
                                                                                         : CornerWord::Index::bad;
}

}  // namespace

float parse_number(std::string_view word) {
    constexpr float nan = std::numeric_limits<float>::quiet_NaN();
    constexpr float infinity = std::numeric_limits<float>::infinity();
    const bool is_negative = word.starts_with('-');
    if (is_negative || word.starts_with('+')) word.remove_prefix(1);
    if (word.empty() || !(is_digit(word.front()) || word.front() == '.')) return nan;

    float value = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (end != word.data() + word.size() || error == std::errc::invalid_argument) return nan;
    if (error != std::errc()) value = is_large(word) ? infinity : 0.0f;
    return is_negative ? -value : value;
}

Numbers parse_numbers(std::string_view words) {
    Numbers numbers;
    for (std::string_view word = next_word(words); !word.empty(); word = next_word(words)) {
        const float value = parse_number(word);
        // Infinity minus itself is NaN, and so is NaN: only what is finite gives 0.
        if (!(value - value == 0) && numbers.first_bad.empty()) numbers.first_bad = word;
        if (numbers.count < 8) numbers.value[numbers.count] = value;
        ++numbers.count;
    }
    return numbers;
}

CornerWord parse_corner(std::string_view word) {
    CornerWord corner;
    for (int i = 0; i < 3; ++i) {
        const std::size_t slash = std::min(word.find('/'), word.size());
        corner.part[i] = word.substr(0, slash);
        corner.state[i] = check_index(corner.part[i]);
        if (slash == word.size()) {
            corner.well_formed = !corner.part[0].empty();
            return corner;
        }
        word.remove_prefix(slash + 1);
    }
    return corner;
}

std::string_view without_comment(std::string_view text) {
    for (std::size_t i = 1; i < text.size(); ++i)
        if (text[i] == '#' && is_blank(text[i - 1])) return trimmed(text.substr(0, i));
    return text;
}

}  // namespace raster::obj
