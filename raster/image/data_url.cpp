// data_url.cpp: base64, 12 bits at a time, or 24 bytes where the processor has AVX2.
#include <raster/image/data_url.h>

#include <algorithm>
#include <array>
#include <vector>

#if defined(__GNUC__) && defined(__x86_64__)
#define RASTER_AVX2 1
#include <immintrin.h>
#endif

namespace raster {
namespace {

#if RASTER_AVX2
/// Takes 24 bytes at a time while there are 28, which are read. Returns how many it took.
__attribute__((target("avx2"))) std::size_t encode_avx2(const unsigned char* in, std::size_t size, char* out) {
    // Of each three bytes a, b, c: b a c b, so that the bits of each digit lie in one of two 16-bit words.
    const __m256i places = _mm256_setr_epi8(1, 0, 2, 1, 4, 3, 5, 4, 7, 6, 8, 7, 10, 9, 11, 10,  //
                                            1, 0, 2, 1, 4, 3, 5, 4, 7, 6, 8, 7, 10, 9, 11, 10);
    // What a digit is more than its value, by its kind: small letters, ten figures, + and /, capital letters.
    const __m128i offset = _mm_setr_epi8('a' - 26, -4, -4, -4, -4, -4, -4, -4, -4, -4, -4, '+' - 62, '/' - 63, 'A', 0, 0);
    const __m256i offsets = _mm256_set_m128i(offset, offset);
    std::size_t done = 0;
    for (; size - done >= 28; done += 24, out += 32) {
        const __m128i low = _mm_loadu_si128(reinterpret_cast<const __m128i*>(in + done));
        const __m128i high = _mm_loadu_si128(reinterpret_cast<const __m128i*>(in + done + 12));
        const __m256i words = _mm256_shuffle_epi8(_mm256_set_m128i(high, low), places);
        // Products shift each word by an amount of its own: right by 10 and 6, left by 4 and 8.
        const __m256i first_and_third =
            _mm256_mulhi_epu16(_mm256_and_si256(words, _mm256_set1_epi32(0x0fc0fc00)), _mm256_set1_epi32(0x04000040));
        const __m256i second_and_fourth =
            _mm256_mullo_epi16(_mm256_and_si256(words, _mm256_set1_epi32(0x003f03f0)), _mm256_set1_epi32(0x01000010));
        const __m256i values = _mm256_or_si256(first_and_third, second_and_fourth);
        // 0 for 26 to 51, 1 to 10 for figures, 11, 12; and 13 for 0 to 25.
        const __m256i is_capital = _mm256_cmpgt_epi8(_mm256_set1_epi8(26), values);
        const __m256i kinds = _mm256_or_si256(_mm256_subs_epu8(values, _mm256_set1_epi8(51)),
                                              _mm256_and_si256(is_capital, _mm256_set1_epi8(13)));
        const __m256i digits = _mm256_add_epi8(values, _mm256_shuffle_epi8(offsets, kinds));
        _mm256_storeu_si256(reinterpret_cast<__m256i*>(out), digits);
    }
    return done;
}
#endif

}  // namespace

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
#if RASTER_AVX2
    if (__builtin_cpu_supports("avx2")) {
        const std::size_t done = encode_avx2(in, left, out);
        in += done, left -= done, out += done / 3 * 4;
    }
#endif
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
