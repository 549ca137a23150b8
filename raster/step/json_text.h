// json_text.h: JSON with brackets that close themselves, and matrices: what the stepper page is filled with.
#pragma once

#include <vector>

#include <raster/trace/json.h>

namespace raster::step {

namespace detail {
struct HoldsText {
    std::string text_;
};
}  // namespace detail

class JsonText : private detail::HoldsText, public JsonWriter {
public:
    JsonText() : JsonWriter(text_) {}

    const std::string& text() const { return text_; }

    /// { ... } or [ ... ] around what `inside` writes.
    template <class Inside>
    void object(const Inside& inside) {
        open('{');
        inside();
        close('}');
    }
    template <class Inside>
    void array(const Inside& inside) {
        open('[');
        inside();
        close(']');
    }
    template <class Inside>
    void object(std::string_view name, const Inside& inside) {
        key(name);
        object(inside);
    }
    template <class Inside>
    void array(std::string_view name, const Inside& inside) {
        key(name);
        array(inside);
    }

    using JsonWriter::value;
    void value(const std::string& s) { value(std::string_view(s)); }
    void value(const glm::ivec2& v) {
        array([&] { value(v.x), value(v.y); });
    }
    /// Rows from the top.
    template <int N>
    void value(const glm::mat<N, N, float>& m) {
        array([&] {
            for (int row = 0; row < N; ++row)
                array([&] {
                    for (int column = 0; column < N; ++column) value(m[column][row]);
                });
        });
    }
    template <class T>
    void value(const std::vector<T>& values) {
        array([&] {
            for (const T& v : values) value(v);
        });
    }
    template <class T, std::size_t N>
    void value(const std::array<T, N>& values) {
        array([&] {
            for (const T& v : values) value(v);
        });
    }
    template <class T>
    void member(std::string_view name, const T& v) {
        key(name);
        value(v);
    }
};

}  // namespace raster::step
