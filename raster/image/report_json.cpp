// report_json.cpp: escaping, and a reader by recursive descent.
#include <raster/image/report_json.h>

#include <cmath>
#include <cstdint>

#include <raster/image/diff_words.h>

namespace raster {
namespace {

constexpr std::string_view replacement = "\xef\xbf\xbd";

/// The length of the UTF-8 sequence at the start, or 0 if there is none (RFC 3629; surrogates are let pass).
std::size_t sequence_length(std::string_view text) {
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    const std::size_t lengths[] = {1, 0, 2, 3, 4, 0};
    const std::size_t length =
        lengths[(byte(0) >= 0x80) + (byte(0) >= 0xc2) + (byte(0) >= 0xe0) + (byte(0) >= 0xf0) + (byte(0) >= 0xf5)];
    if (length == 0 || length > text.size()) return 0;
    for (std::size_t i = 1; i < length; ++i)
        if ((byte(i) & 0xc0) != 0x80) return 0;
    return length;
}

void append_utf8(std::string& out, std::uint32_t code) {
    if (code < 0x80) {
        out += char(code);
    } else if (code < 0x800) {
        out += char(0xc0 | code >> 6);
        out += char(0x80 | (code & 0x3f));
    } else if (code < 0x10000) {
        out += char(0xe0 | code >> 12);
        out += char(0x80 | (code >> 6 & 0x3f));
        out += char(0x80 | (code & 0x3f));
    } else {
        out += char(0xf0 | code >> 18);
        out += char(0x80 | (code >> 12 & 0x3f));
        out += char(0x80 | (code >> 6 & 0x3f));
        out += char(0x80 | (code & 0x3f));
    }
}

class Reader {
public:
    explicit Reader(std::string_view text) : text_(text) {}

    bool read_document(JsonValue& value) { return read(value, 0) && (skip_space(), text_.empty()); }

private:
    static constexpr int deepest = 64;

    void skip_space() {
        while (!text_.empty() && std::string_view(" \t\r\n").find(text_[0]) != std::string_view::npos)
            text_.remove_prefix(1);
    }
    bool take(char c) {
        skip_space();
        if (text_.empty() || text_[0] != c) return false;
        text_.remove_prefix(1);
        return true;
    }

    bool read(JsonValue& value, int depth) {
        skip_space();
        if (text_.empty() || depth > deepest) return false;
        if (text_[0] == '"') {
            value.kind = JsonValue::Kind::text;
            return read_string(value.text);
        }
        if (take('[')) {
            value.kind = JsonValue::Kind::array;
            if (take(']')) return true;
            do {
                if (!read(value.items.emplace_back(), depth + 1)) return false;
            } while (take(','));
            return take(']');
        }
        if (take('{')) {
            value.kind = JsonValue::Kind::object;
            if (take('}')) return true;
            do {
                std::string name;
                skip_space();
                if (!read_string(name) || !take(':') || !read(value.members[name], depth + 1)) return false;
            } while (take(','));
            return take('}');
        }
        const std::size_t end = text_.find_first_not_of("+-.0123456789abcdefghijklmnopqrstuvwxyzE");
        value.text = std::string(text_.substr(0, end));
        text_.remove_prefix(value.text.size());
        value.kind = value.text == "null" ? JsonValue::Kind::null : JsonValue::Kind::literal;
        return !value.text.empty();
    }

    bool read_hex(std::uint32_t& code) {
        if (text_.size() < 4) return false;
        code = 0;
        for (int i = 0; i < 4; ++i) {
            const std::size_t digit = std::string_view("0123456789abcdef").find(char(text_[0] | 0x20));
            if (digit == std::string_view::npos) return false;
            code = code << 4 | std::uint32_t(digit);
            text_.remove_prefix(1);
        }
        return true;
    }

    bool read_escape(std::string& out) {
        if (text_.empty()) return false;
        const char c = text_[0];
        text_.remove_prefix(1);
        if (c != 'u') {
            constexpr std::string_view names = "\"\\/bfnrt", values = "\"\\/\b\f\n\r\t";
            const std::size_t i = names.find(c);
            if (i != std::string_view::npos) out += values[i];
            return i != std::string_view::npos;
        }
        std::uint32_t code = 0, low = 0;
        if (!read_hex(code)) return false;
        if (code >= 0xd800 && code < 0xdc00) {
            if (!text_.starts_with("\\u")) return false;
            text_.remove_prefix(2);
            if (!read_hex(low) || low < 0xdc00 || low > 0xdfff) return false;
            code = 0x10000 + ((code - 0xd800) << 10) + (low - 0xdc00);
        }
        append_utf8(out, code);
        return true;
    }

    bool read_string(std::string& out) {
        if (text_.empty() || text_[0] != '"') return false;
        text_.remove_prefix(1);
        while (!text_.empty()) {
            const char c = text_[0];
            text_.remove_prefix(1);
            if (c == '"') return true;
            if (static_cast<unsigned char>(c) < 0x20) return false;
            if (c != '\\') {
                out += c;
            } else if (!read_escape(out)) {
                return false;
            }
        }
        return false;
    }

    std::string_view text_;
};

}  // namespace

std::string json_string(std::string_view text) {
    constexpr std::string_view hex = "0123456789abcdef";
    std::string out = "\"";
    while (!text.empty()) {
        const std::size_t length = sequence_length(text);
        const auto c = static_cast<unsigned char>(text[0]);
        if (length == 0) {
            out += replacement;
        } else if (c == '"' || c == '\\') {
            out += '\\';
            out += char(c);
        } else if (c < 0x20 || c == '<' || c == 0x7f) {
            out += "\\u00";
            out += hex[c >> 4];
            out += hex[c & 15];
        } else {
            out += text.substr(0, length);
        }
        text.remove_prefix(length == 0 ? 1 : length);
    }
    return out + '"';
}

std::string json_number(double value) { return std::isfinite(value) ? exact_number(value) : "null"; }

JsonObject& JsonObject::add(std::string_view name, const std::string& json) {
    if (!members_.empty()) members_ += ',';
    members_ += json_string(name);
    members_ += ':';
    members_ += json;
    return *this;
}

std::string json_array(const std::vector<std::string>& values) {
    std::string out = "[";
    for (const std::string& value : values) {
        if (out.size() > 1) out += ',';
        out += value;
    }
    return out + ']';
}

std::string JsonValue::member_text(std::string_view name) const {
    const auto found = members.find(name);
    return found != members.end() && found->second.kind != Kind::null ? found->second.text : "";
}

std::optional<JsonValue> parse_json(std::string_view document) {
    JsonValue value;
    if (!Reader(document).read_document(value)) return std::nullopt;
    return value;
}

}  // namespace raster
