// emscripten.h: what the library of Debian 12's emscripten 3.1.6 lacks, as far as this program needs it.
#pragma once

#include <atomic>
#include <charconv>
#include <cstdio>
#include <cstdlib>
#include <cstring>

namespace std {

template <class To, class From>
inline To bit_cast(const From& from) {
    To to;
    memcpy(&to, &from, sizeof to);
    return to;
}

inline to_chars_result to_chars(char* first, char* last, double value) {
    return {first + snprintf(first, size_t(last - first), "%.9g", value), errc()};
}
inline to_chars_result to_chars(char* first, char* last, float value) { return to_chars(first, last, double(value)); }

/// For decimal numbers alone.
inline from_chars_result from_chars(const char* first, const char* last, float& value) {
    char text[64] = "";
    memcpy(text, first, size_t(last - first) < sizeof text ? size_t(last - first) : sizeof text - 1);
    char* end = text;
    value = strtof(text, &end);
    return {first + (end - text), end == text ? errc::invalid_argument : errc()};
}

/// One thread draws there.
template <class T>
struct atomic_ref {
    T& value;
    explicit atomic_ref(T& object) : value(object) {}
    T load(memory_order) const { return value; }
    void store(T desired, memory_order) const { value = desired; }
};

}  // namespace std

// Where the library keeps its own parts of std::ranges.
_LIBCPP_BEGIN_NAMESPACE_STD
namespace ranges {
template <class Range, class Test>
inline bool any_of(const Range& range, const Test& test) {
    for (const auto& value : range)
        if (test(value)) return true;
    return false;
}

template <class Range, class Value, class Member>
inline auto find(const Range& range, const Value& value, Member member) {
    auto at = range.begin();
    while (at != range.end() && !((*at).*member == value)) ++at;
    return at;
}
}  // namespace ranges
_LIBCPP_END_NAMESPACE_STD
