// obj_tokens.cpp: numbers that do not depend on the locale, and indices with a range.
#include <raster/scene/obj_tokens.h>

#include <algorithm>
#include <bit>
#include <cfloat>
#include <charconv>
#include <cstdint>
#include <limits>
#include <system_error>

#include <raster/scene/obj_lines.h>

namespace raster::obj {
namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }

bool is_line_end(char c) { return c == '\n' || c == '\r'; }

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

CornerWord::Index parse_index(std::string_view part, std::int32_t& index) {
    if (part.empty()) return CornerWord::Index::missing;
    if (part.front() == '+' && !part.starts_with("+-")) part.remove_prefix(1);
    std::int32_t value = 0;
    const auto [end, error] = std::from_chars(part.data(), part.data() + part.size(), value);
    const bool is_integer = error == std::errc() && end == part.data() + part.size();
    if (!is_integer || value == 0 || value == std::numeric_limits<std::int32_t>::min()) return CornerWord::Index::bad;
    index = value;
    return CornerWord::Index::good;
}

/// Reads [sign] digits [. digits] up to a blank or an end, as most files have their numbers. Null if what stands there
/// is another number, or none; else the end.
///
/// With at most 15 digits both the digits as a whole number and the power of ten are exact in double, and the quotient
/// is the nearest double (Clinger, "How to Read Floating Point Numbers Accurately", 1990). Its nearest float is the
/// number's own, unless the double lies half way between two floats: the number itself may lie to either side.
const char* read_plain_number(const char* at, const char* end, float& value) {
    static constexpr double powers_of_ten[] = {1e0, 1e1, 1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                               1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15};
    if (FLT_EVAL_METHOD != 0) return nullptr;  // doubles are not doubles
    const bool is_negative = at != end && *at == '-';
    if (is_negative || (at != end && *at == '+')) ++at;
    std::uint64_t digits = 0;
    const char* const first = at;
    for (; at != end && is_digit(*at); ++at) digits = 10 * digits + std::uint64_t(*at - '0');
    std::ptrdiff_t count = at - first, decimals = 0;
    if (at != end && *at == '.') {
        const char* const point = at++;
        for (; at != end && is_digit(*at); ++at) digits = 10 * digits + std::uint64_t(*at - '0');
        decimals = at - point - 1;
        count += decimals;
    }
    if (count == 0 || count > 15 || (at != end && !is_blank(*at) && !is_line_end(*at))) return nullptr;
    const double quotient = double(digits) / powers_of_ten[decimals];
    constexpr std::uint64_t below_float = (std::uint64_t(1) << 29) - 1, half_way = std::uint64_t(1) << 28;
    if ((std::bit_cast<std::uint64_t>(quotient) & below_float) == half_way) return nullptr;
    value = is_negative ? -float(quotient) : float(quotient);
    return at;
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
    const char* at = words.data();
    const char* const end = at + words.size();
    for (;;) {
        while (at != end && is_blank(*at)) ++at;
        if (at == end) return numbers;
        float value = 0;
        if (const char* const plain_end = read_plain_number(at, end, value)) {
            at = plain_end;
        } else {
            const char* const start = at;
            while (at != end && !is_blank(*at)) ++at;
            const std::string_view word(start, std::size_t(at - start));
            value = parse_number(word);
            // Infinity minus itself is NaN, and so is NaN: only what is finite gives 0.
            if (!(value - value == 0) && numbers.first_bad.empty()) numbers.first_bad = word;
        }
        if (numbers.count < 8) numbers.value[numbers.count] = value;
        ++numbers.count;
    }
}

const char* read_plain_numbers(const char* at, const char* end, Numbers& numbers) {
    for (;;) {
        while (at != end && is_blank(*at)) ++at;
        if (at == end || is_line_end(*at)) return at;
        float value = 0;
        at = read_plain_number(at, end, value);
        if (!at) return nullptr;
        if (numbers.count < 8) numbers.value[numbers.count] = value;
        ++numbers.count;
    }
}

const char* read_plain_corners(const char* at, const char* end, std::vector<Corner>& corners) {
    const auto read_index = [&](std::int32_t& index) {
        const bool is_negative = at != end && *at == '-';
        if (is_negative || (at != end && *at == '+')) ++at;
        if (at != end && *at == '0') return false;
        const char* const first = at;
        std::uint32_t value = 0;
        for (; at != end && is_digit(*at); ++at) value = 10 * value + std::uint32_t(*at - '0');
        index = is_negative ? -std::int32_t(value) : std::int32_t(value);
        return at != first && at - first <= 9;
    };
    do {
        Corner corner{0, 0, 0};
        if (!read_index(corner.position)) return nullptr;
        if (at != end && *at == '/') {
            ++at;
            const bool has_uv = at != end && *at != '/';
            if (has_uv && !read_index(corner.uv)) return nullptr;
            if (at != end && *at == '/') {
                ++at;
                if (!read_index(corner.normal)) return nullptr;
            } else if (!has_uv) {
                return nullptr;
            }
        }
        if (at != end && !is_blank(*at) && !is_line_end(*at)) return nullptr;
        corners.push_back(corner);
        while (at != end && is_blank(*at)) ++at;
    } while (at != end && !is_line_end(*at));
    return at;
}

CornerWord parse_corner(std::string_view word) {
    CornerWord corner;
    for (int i = 0; i < 3; ++i) {
        const std::size_t slash = std::min(word.find('/'), word.size());
        corner.part[i] = word.substr(0, slash);
        corner.state[i] = parse_index(corner.part[i], corner.index[i]);
        if (slash == word.size()) {
            corner.well_formed = !corner.part[0].empty();
            return corner;
        }
        word.remove_prefix(slash + 1);
    }
    return corner;
}

std::string_view without_comment(std::string_view text) {
    for (std::size_t i = text.find('#', 1); i < text.size(); i = text.find('#', i + 1))
        if (is_blank(text[i - 1])) return trimmed(text.substr(0, i));
    return text;
}

}  // namespace raster::obj
