// json_tree.cpp: the events of nlohmann's parser, and how far it has read at each, become a tree with places.
#include "json_tree.h"

#include <algorithm>
#include <iterator>

#include <nlohmann/json.hpp>

#include "parse.h"

namespace raster::tool {
namespace {

constexpr std::size_t max_depth = 32;

/// Reads bytes and leaves a note of how many.
class CountingIterator {
public:
    using iterator_category = std::input_iterator_tag;
    using value_type = char;
    using difference_type = std::ptrdiff_t;
    using pointer = const char*;
    using reference = const char&;

    CountingIterator(const char* at, std::size_t* count) : at_(at), count_(count) {}
    reference operator*() const { return *at_; }
    CountingIterator& operator++() {
        ++at_;
        ++*count_;
        return *this;
    }
    CountingIterator operator++(int) {
        CountingIterator old = *this;
        ++*this;
        return old;
    }
    friend bool operator==(const CountingIterator& a, const CountingIterator& b) { return a.at_ == b.at_; }
    friend bool operator!=(const CountingIterator& a, const CountingIterator& b) { return a.at_ != b.at_; }

private:
    const char* at_;
    std::size_t* count_;
};

/// Builds the tree. The parser has read at most one byte beyond a value, and that is no byte of the next one.
class Builder : public nlohmann::json_sax<nlohmann::json> {
public:
    Builder(JsonDocument& document, const std::size_t& read) : document_(document), read_(read) {}

    bool null() override { return add({}); }
    bool boolean(bool value) override {
        JsonNode node;
        node.kind = JsonNode::Kind::boolean;
        node.boolean = value;
        return add(std::move(node));
    }
    bool number_integer(number_integer_t value) override { return add_number(double(value)); }
    bool number_unsigned(number_unsigned_t value) override { return add_number(double(value)); }
    bool number_float(number_float_t value, const string_t&) override { return add_number(value); }
    bool string(string_t& value) override {
        JsonNode node;
        node.kind = JsonNode::Kind::text;
        node.text = std::move(value);
        return add(std::move(node));
    }
    bool binary(binary_t&) override { return false; }
    bool start_object(std::size_t) override { return open(JsonNode::Kind::object); }
    bool start_array(std::size_t) override { return open(JsonNode::Kind::array); }
    bool end_object() override { return close(); }
    bool end_array() override { return close(); }
    bool key(string_t& name) override {
        JsonNode& object = *open_.back();
        const std::size_t place = next_place();
        if (std::ranges::find(object.keys, name) != object.keys.end()) {
            problem = document_.error_at(place, in_quotes(name) + " is given twice");
            return false;
        }
        object.keys.push_back(name);
        object.places.push_back(place);
        return true;
    }
    bool parse_error(std::size_t, const std::string&, const nlohmann::detail::exception&) override {
        const std::size_t place = next_place();
        const std::string_view rest = std::string_view(document_.text).substr(place);
        const std::string_view word = rest.substr(0, std::max<std::size_t>(rest.find_first_of(" \t\r\n,:]}"), 1));
        problem = document_.error_at(place, rest.empty() ? "this is no JSON: the file ends too early"
                                                         : "this is no JSON: " + in_quotes(word) +
                                                               " is not expected here");
        return false;
    }

    Error problem;

private:
    std::size_t next_place() {
        std::size_t place = last_;
        const std::string& text = document_.text;
        while (place < text.size() && std::string_view(" \t\r\n,:").find(text[place]) != text.npos) ++place;
        last_ = read_;
        return place;
    }
    JsonNode* put(JsonNode node) {
        node.place = next_place();
        if (open_.empty()) {
            document_.root = std::move(node);
            return &document_.root;
        }
        open_.back()->items.push_back(std::move(node));
        return &open_.back()->items.back();
    }
    bool add(JsonNode node) {
        put(std::move(node));
        return true;
    }
    bool add_number(double value) {
        JsonNode node;
        node.kind = JsonNode::Kind::number;
        node.number = value;
        return add(std::move(node));
    }
    bool open(JsonNode::Kind kind) {
        JsonNode node;
        node.kind = kind;
        JsonNode* const added = put(std::move(node));
        // What is open stays where it is: its parent's list grows only after it is closed.
        open_.push_back(added);
        if (open_.size() <= max_depth) return true;
        problem = document_.error_at(*added, "nested too deeply");
        return false;
    }
    bool close() {
        open_.pop_back();
        last_ = read_;
        return true;
    }

    JsonDocument& document_;
    const std::size_t& read_;
    std::size_t last_ = 0;  ///< where the token before ended, or one byte later
    std::vector<JsonNode*> open_;
};

}  // namespace

const JsonNode* JsonNode::find(std::string_view key) const {
    for (std::size_t i = 0; i < keys.size(); ++i)
        if (keys[i] == key) return &items[i];
    return nullptr;
}

/// Words of the file may be in a message; control characters must not reach a terminal.
static std::string printable(const std::string& text) {
    constexpr char hex[] = "0123456789abcdef";
    std::string out;
    for (const char c : text) {
        const auto byte = static_cast<unsigned char>(c);
        if (byte < 0x20 || byte == 0x7f) {
            out += {'\\', 'x', hex[byte >> 4], hex[byte & 15]};
        } else {
            out += c;
        }
    }
    return out;
}

Error JsonDocument::error_at(std::size_t place, const std::string& what) const {
    const std::string_view before = std::string_view(text).substr(0, place);
    const auto line = 1 + std::ranges::count(before, '\n');
    const std::size_t line_start = before.rfind('\n') + 1;  // npos + 1 is 0
    return {ErrorKind::bad_input, path + ":" + std::to_string(line) + ":" +
                                      std::to_string(before.size() - line_start + 1) + ": " +
                                      printable(what)};
}

Result<JsonDocument> parse_json(std::string path, std::string text) {
    JsonDocument document{std::move(path), std::move(text), {}};
    std::size_t read = 0;
    Builder builder(document, read);
    const char* const begin = document.text.data();
    const bool done = nlohmann::json::sax_parse(CountingIterator(begin, &read),
                                                CountingIterator(begin + document.text.size(), &read), &builder);
    if (!done) return builder.problem;
    return document;
}

}  // namespace raster::tool
