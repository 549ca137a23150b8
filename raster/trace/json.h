// json.h: JSON written straight into a string. Floats are as short as they can be to be read back the same.
#pragma once

#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>

#include <glm/glm.hpp>

namespace raster {

/// Appends one JSON value to a string: open, members, close. What is no number becomes one of the strings "NaN",
/// "Infinity", "-Infinity", since JSON has no such numbers.
class JsonWriter {
public:
    explicit JsonWriter(std::string& out) : out_(out) {}

    void open(char bracket) {
        separate();
        out_ += bracket;
        first_ = true;
    }
    void close(char bracket) {
        out_ += bracket;
        first_ = false;
    }
    void key(std::string_view name) {
        separate();
        text(name);
        out_ += ':';
        first_ = true;
    }

    template <class T>
    requires std::is_arithmetic_v<T>
    void value(T number) {
        separate();
        if constexpr (std::is_same_v<T, bool>) {
            out_ += number ? "true" : "false";
        } else {
            if constexpr (std::is_floating_point_v<T>) {
                if (!std::isfinite(number)) {
                    out_ += std::isnan(number) ? "\"NaN\"" : number > 0 ? "\"Infinity\"" : "\"-Infinity\"";
                    return;
                }
            }
            char digits[32];
            out_.append(digits, std::to_chars(digits, digits + sizeof digits, number).ptr);
        }
    }
    void null() {
        separate();
        out_ += "null";
    }
    void value(std::string_view words) {
        separate();
        text(words);
    }
    /// A value that is JSON already.
    void raw(std::string_view json) {
        separate();
        out_ += json;
    }
    void value(const char* words) { value(std::string_view(words)); }
    template <int N>
    void value(const glm::vec<N, float>& v) {
        open('[');
        for (int i = 0; i < N; ++i) value(v[i]);
        close(']');
    }
    template <class T, std::size_t N>
    void value(std::span<const T, N> values) {
        open('[');
        for (const T& v : values) value(v);
        close(']');
    }
    template <class T, std::size_t N>
    void value(const std::array<T, N>& values) {
        value(std::span<const T>(values));
    }

    template <class T>
    void member(std::string_view name, const T& v) {
        key(name);
        value(v);
    }

private:
    void separate() {
        if (!first_) out_ += ',';
        first_ = false;
    }
    void text(std::string_view words) {
        out_ += '"';
        for (const char c : words) {
            if (c == '"' || c == '\\') {
                (out_ += '\\') += c;
            } else if (static_cast<unsigned char>(c) < 0x20) {
                constexpr char digits[] = "0123456789abcdef";
                out_ += "\\u00";
                (out_ += digits[c >> 4]) += digits[c & 15];
            } else {
                out_ += c;
            }
        }
        out_ += '"';
    }

    std::string& out_;
    bool first_ = true;
};

}  // namespace raster
