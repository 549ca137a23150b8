// data_url.cpp: base64, 12 bits at a time.
#include <raster/image/data_url.h>

#include <algorithm>
#include <array>
#include <vector>

namespace raster {

void base64(std::span<const std::byte> bytes, std::string& text) {
    static constexpr char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    static const std::vector<std::array<char, 2>> pairs = [] {
        std::vector<std::array<char, 2>> table;
        for (int i = 0; i < 4096; ++i) table.push_back({digits[i >> 6], digits[i & 63]});
        return table;
    }();
    text.resize((bytes.size() + 2) / 3 * 4);
    char* out = text.data();
    const auto* in = reinterpret_cast<const unsigned char*>(bytes.data());
    std::size_t left = bytes.size();
    for (; left >= 3; left -= 3, in += 3, out += 4) {
        const unsigned bits = unsigned(in[0]) << 16 | unsigned(in[1]) << 8 | in[2];
        std::copy_n(pairs[bits >> 12].data(), 2, out);
        std::copy_n(pairs[bits & 4095].data(), 2, out + 2);
    }
    if (left > 0) {
        const unsigned bits = unsigned(in[0]) << 16 | (left == 2 ? unsigned(in[1]) << 8 : 0);
        std::copy_n(pairs[bits >> 12].data(), 2, out);
        out[2] = left == 2 ? digits[bits >> 6 & 63] : '=';
        out[3] = '=';
    }
}

std::string base64(std::span<const std::byte> bytes) {
    std::string text;
    base64(bytes, text);
    return text;
}

std::string data_url(const char* type, const Bytes& bytes) {
    return std::string("data:") + type + ";base64," + base64(bytes);
}

}  // namespace raster
