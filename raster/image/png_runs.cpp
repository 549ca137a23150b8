// png_runs.cpp: deflate blocks (RFC 1951) of runs, several bands of rows at once.
//
// libdeflate looks for matches of every kind, on one thread. In noise there are none, and where colours are few or
// change slowly, repetitions of the last pixel are most of what there is: this takes half of the time of its fastest
// level on one thread, and runs on all.
#include <raster/image/png_runs.h>

#include <libdeflate.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <memory>
#include <span>
#include <vector>

#include <raster/tiles/parallel.h>

namespace raster {
namespace {

// A token is a literal, 0 to 255, or a run of 3 to 258 bytes: from 256 on those that repeat the last byte, from 512 on
// those that repeat the last pixel.
using Token = std::uint16_t;
constexpr int shortest_run = 3, longest_run = 258, byte_run_token = 256, pixel_run_token = 512, kinds = 768;
constexpr std::size_t slack = 8;  // bytes that can be touched behind a row
constexpr int end_of_block = 256, symbols = 286, most_code_bits = 15;

/// The symbol of each length, and its extra bits (RFC 1951, 3.2.5).
struct LengthCode {
    int symbol, extra_bits, extra;
};
LengthCode length_code(int length) {
    if (length == longest_run) return {285, 0, 0};
    const int from = length - shortest_run;
    int bits = 0;
    while (from >> bits >= 8) ++bits;
    return {257 + 4 * bits + (from >> bits), bits, from & ((1 << bits) - 1)};
}

/// How many of the next eight bytes are the same.
int same_bytes(const std::uint8_t* a, const std::uint8_t* b) {
    std::uint64_t first, second;
    std::memcpy(&first, a, 8), std::memcpy(&second, b, 8);
    const std::uint64_t difference = first ^ second;
    if constexpr (std::endian::native == std::endian::little) return std::countr_zero(difference) / 8;
    return std::countl_zero(difference) / 8;
}

bool same_32(const std::uint8_t* a, const std::uint8_t* b) {
    std::uint64_t first[4], second[4], difference = 0;
    std::memcpy(first, a, 32), std::memcpy(second, b, 32);
    for (int i = 0; i < 4; ++i) difference |= first[i] ^ second[i];
    return difference == 0;
}

using RunBytes = std::uint8_t __attribute__((vector_size(16)));
using RunTokens = Token __attribute__((vector_size(32)));
using RunMask = signed char __attribute__((vector_size(16)));
constexpr int chunk = int(sizeof(RunBytes));

/// In `starts`, not 0 where four bytes are those that lie `distance` before them.
void find_repeats(const std::uint8_t* at, int distance, RunMask& starts) {
    starts = ~RunMask{};
    for (int k = 0; k < 4; ++k) {
        RunBytes here, before;
        std::memcpy(&here, at + k, sizeof here);
        std::memcpy(&before, at + k - distance, sizeof before);
        starts &= here == before;
    }
}

/// How many bytes, of a chunk, come before a run of four or more starts. `pixel` bytes before the chunk can be read and
/// three behind it.
int bytes_before_run(const std::uint8_t* row, int pixel) {
    RunMask of_bytes, of_pixels;
    find_repeats(row, 1, of_bytes);
    if (pixel > 1) {
        find_repeats(row, pixel, of_pixels);
        of_bytes |= of_pixels;
    }
    const auto words = std::bit_cast<std::array<std::uint64_t, 2>>(of_bytes);
    if constexpr (std::endian::native == std::endian::little)
        return words[0] != 0 ? std::countr_zero(words[0]) / 8 : 8 + std::countr_zero(words[1]) / 8;
    return words[0] != 0 ? std::countl_zero(words[0]) / 8 : 8 + std::countl_zero(words[1]) / 8;
}

/// Writes a row's tokens, at most one for each byte and one more. Returns their end. Eight bytes beyond the row can be
/// read. `pixel` is the bytes of one.
Token* find_tokens(std::uint8_t filter, const std::uint8_t* row, int width, int pixel, Token* tokens) {
    constexpr int least = 4;  // three literals are often shorter than a run
    *tokens++ = filter;
    int x = 0;
    while (x < std::min(pixel, width)) *tokens++ = row[x++];
    while (x < width) {
        // Noise, of which there can be much, many bytes at once.
        for (int literals = chunk; literals == chunk && x + chunk + 3 <= width; x += literals, tokens += literals) {
            RunBytes bytes;
            std::memcpy(&bytes, row + x, sizeof bytes);
            const RunTokens wide = __builtin_convertvector(bytes, RunTokens);
            std::memcpy(tokens, &wide, sizeof wide);
            literals = bytes_before_run(row + x, pixel);
        }
        const int bytes = same_bytes(row + x, row + x - 1), pixels = same_bytes(row + x, row + x - pixel);
        int run = std::max(bytes, pixels);
        if (run < least) {
            // Nor does a run start in the bytes up to the first that differs.
            for (const int end = std::min(x + std::min(bytes, pixels) + 1, width); x < end;) *tokens++ = row[x++];
            continue;
        }
        const int distance = pixels > bytes ? pixel : 1;
        const int first_token = pixels > bytes ? pixel_run_token : byte_run_token;
        if (run == 8) {
            for (; x + run + 32 <= width && same_32(row + x + run, row + x + run - distance);) run += 32;
            for (int more = 8; more == 8 && x + run < width; run += more)
                more = same_bytes(row + x + run, row + x + run - distance);
        }
        run = std::min(run, width - x);
        x += run;
        for (; run >= shortest_run; run -= std::min(run, longest_run))
            *tokens++ = Token(first_token + std::min(run, longest_run) - shortest_run);
        x -= run;
        for (; run > 0; --run) *tokens++ = row[x++];
    }
    return tokens;
}

/// The bits of each symbol's Huffman code, 0 for what does not occur (Huffman 1952).
std::array<std::uint8_t, symbols> code_lengths(std::array<std::uint32_t, symbols> counts) {
    for (;;) {
        struct Node {
            std::uint32_t count;
            int parent;
        };
        std::vector<int> leaves;
        for (int s = 0; s < symbols; ++s)
            if (counts[std::size_t(s)] > 0) leaves.push_back(s);
        std::stable_sort(leaves.begin(), leaves.end(),
                         [&](int a, int b) { return counts[std::size_t(a)] < counts[std::size_t(b)]; });
        // Leaves by their counts, then inner nodes, which come about by theirs: the next smallest leads one of both.
        const std::size_t leaf_count = leaves.size(), node_count = 2 * leaf_count - 1;
        std::vector<Node> nodes(node_count);
        for (std::size_t i = 0; i < leaf_count; ++i) nodes[i].count = counts[std::size_t(leaves[i])];
        std::size_t leaf = 0, inner = leaf_count;
        for (std::size_t made = leaf_count; made < node_count; ++made)
            for (int child = 0; child < 2; ++child) {
                const bool take_leaf = leaf < leaf_count && (inner == made || nodes[leaf].count <= nodes[inner].count);
                Node& least = nodes[take_leaf ? leaf++ : inner++];
                least.parent = int(made);
                nodes[made].count += least.count;
            }
        std::vector<int> depths(node_count);
        int deepest = 0;
        for (std::size_t i = node_count - 1; i-- > 0;)
            deepest = std::max(deepest, depths[i] = depths[std::size_t(nodes[i].parent)] + 1);
        if (deepest <= most_code_bits) {
            std::array<std::uint8_t, symbols> lengths{};
            for (std::size_t i = 0; i < leaf_count; ++i) lengths[std::size_t(leaves[i])] = std::uint8_t(depths[i]);
            return lengths;
        }
        for (std::uint32_t& count : counts) count = (count + 1) / 2;  // flatter
    }
}

/// Bits as deflate has them: the first is the lowest of the first byte.
class BitWriter {
public:
    explicit BitWriter(std::byte* out) : start_(out), out_(out) {}
    /// At most 57 bits since the last flush.
    void add(std::uint64_t bits, int count) { buffer_ |= bits << filled_, filled_ += count; }
    /// Eight bytes have to have room.
    void flush() {
        for (int i = 0; i < 8; ++i) out_[i] = std::byte(buffer_ >> (8 * i));
        out_ += filled_ >> 3, buffer_ >>= filled_ & ~7, filled_ &= 7;
    }
    void to_whole_byte() { filled_ = (filled_ + 7) & ~7; }
    std::size_t size() const { return std::size_t(out_ - start_); }

private:
    std::byte *start_, *out_;
    std::uint64_t buffer_ = 0;
    int filled_ = 0;
};

/// What stands for each token.
struct Code {
    std::uint32_t bits = 0;
    int count = 0;
};

/// Huffman codes in the order that RFC 1951, 3.2.2 gives them, with their first bit lowest.
std::array<Code, symbols> codes_of(const std::array<std::uint8_t, symbols>& lengths) {
    std::array<Code, symbols> codes;
    std::uint32_t next = 0;
    for (int length = 1; length <= most_code_bits; ++length, next <<= 1)
        for (std::size_t s = 0; s < symbols; ++s) {
            if (lengths[s] != length) continue;
            codes[s].count = length;
            for (int bit = 0; bit < length; ++bit) codes[s].bits |= (next >> bit & 1) << (length - 1 - bit);
            ++next;
        }
    return codes;
}

/// The literal or length symbol of a token, and the length's extra bits.
LengthCode symbol_of(int token) {
    if (token < byte_run_token) return {token, 0, 0};
    return length_code(token % 256 + shortest_run);
}

/// `at_once` tokens have at most 57 bits.
template <std::size_t at_once>
void write_tokens(std::span<const Token> tokens, const Code* codes, BitWriter& out) {
    BitWriter writer = out;  // in registers
    std::size_t i = 0;
    for (; i + at_once <= tokens.size(); i += at_once) {
        for (std::size_t k = 0; k < at_once; ++k) writer.add(codes[tokens[i + k]].bits, codes[tokens[i + k]].count);
        writer.flush();
    }
    for (; i < tokens.size(); ++i) writer.add(codes[tokens[i]].bits, codes[tokens[i]].count), writer.flush();
    out = writer;
}

/// One block, which is not the last one, and an empty one that ends at a whole byte.
Bytes pack_tokens(std::span<const Token> tokens, int pixel) {
    // Two of each count, since one that was just written is not read at once.
    std::array<std::uint32_t, kinds> uses{}, more_uses{};
    for (std::size_t i = 0; i + 2 <= tokens.size(); i += 2) ++uses[tokens[i]], ++more_uses[tokens[i + 1]];
    if (tokens.size() % 2 != 0) ++uses[tokens.back()];
    std::array<std::uint32_t, symbols> counts{};
    counts[end_of_block] = 1;
    for (int token = 0; token < kinds; ++token) {
        uses[std::size_t(token)] += more_uses[std::size_t(token)];
        counts[std::size_t(symbol_of(token).symbol)] += uses[std::size_t(token)];
    }
    const std::array<std::uint8_t, symbols> lengths = code_lengths(counts);
    const std::array<Code, symbols> of_symbol = codes_of(lengths);
    std::array<Code, kinds> codes;
    for (int token = 0; token < kinds; ++token) {
        const LengthCode length = symbol_of(token);
        const Code& code = of_symbol[std::size_t(length.symbol)];
        codes[std::size_t(token)] = {code.bits | std::uint32_t(length.extra) << code.count,
                                     code.count + length.extra_bits};
        if (token < byte_run_token) continue;
        // Then the distance, in one bit.
        Code& run = codes[std::size_t(token)];
        run.bits |= std::uint32_t(token >= pixel_run_token) << run.count++;
    }

    std::uint64_t bits = 0;
    for (std::size_t token = 0; token < std::size_t(kinds); ++token)
        bits += std::uint64_t(uses[token]) * std::uint64_t(codes[token].count);
    Bytes out(std::size_t(bits / 8) + 256);
    BitWriter writer(out.data());
    // A block with codes of its own: 286 for literals and lengths, `pixel` for distances, of which the first and the
    // last are used, 19 for the lengths of these codes.
    writer.add(0b100, 3), writer.add(286 - 257, 5), writer.add(std::uint64_t(pixel) - 1, 5), writer.add(19 - 4, 4);
    // The lengths 0 to 15 have 4 bits each; of repetitions, which come first, none is used.
    for (int i = 0; i < 19; ++i) writer.add(i < 3 ? 0 : 4, 3), writer.flush();
    const auto add_length = [&](std::uint32_t length) {
        std::uint32_t reversed = 0;
        for (int bit = 0; bit < 4; ++bit) reversed |= (length >> bit & 1) << (3 - bit);
        writer.add(reversed, 4), writer.flush();
    };
    for (const std::uint8_t length : lengths) add_length(length);
    for (int distance = 1; distance <= pixel; ++distance) add_length(distance == 1 || distance == pixel ? 1 : 0);
    int longest = 0;
    for (std::size_t token = 0; token < kinds; ++token)
        if (uses[token] > 0) longest = std::max(longest, codes[token].count);
    const auto write = longest <= 57 / 4 ? write_tokens<4> : longest <= 57 / 3 ? write_tokens<3> : write_tokens<2>;
    write(tokens, codes.data(), writer);
    writer.add(of_symbol[end_of_block].bits, of_symbol[end_of_block].count);
    writer.add(0, 3);  // a block of stored bytes, of which there are none
    writer.to_whole_byte(), writer.flush();
    writer.add(0xffff0000u, 32), writer.flush();
    out.resize(writer.size());
    return out;
}

struct Band {
    Bytes packed;
    std::uint32_t adler = 1;
    std::size_t size = 0;
};

/// The Adler-32 of two pieces, from those of each (RFC 1950, 8.2).
std::uint32_t joined(std::uint32_t first, std::uint32_t second, std::size_t second_size) {
    constexpr std::uint64_t base = 65521;
    const std::uint64_t a = first & 0xffff, b = first >> 16, c = second & 0xffff, d = second >> 16;
    const std::uint64_t low = (a + c + base - 1) % base;
    const std::uint64_t high = (b + d + second_size % base * (a + base - 1)) % base;
    return std::uint32_t(high << 16 | low);
}

}  // namespace

Bytes pack_runs(std::span<const std::uint8_t> rows, std::size_t row_bytes, int pixel_bytes) {
    constexpr std::size_t band_bytes = 1 << 18;
    const std::size_t band_size = std::max<std::size_t>(band_bytes / row_bytes, 1) * row_bytes;
    std::vector<Band> bands((rows.size() + band_size - 1) / band_size);
    tiles::parallel_for(bands.size(), [&](std::size_t i) {
        Band& band = bands[i];
        const auto of_band = rows.subspan(i * band_size, std::min(band_size, rows.size() - i * band_size));
        // As many as there can be; what is not written costs nothing.
        const std::unique_ptr<Token[]> tokens(new Token[of_band.size()]);
        Token* end = tokens.get();
        std::vector<std::uint8_t> row(row_bytes + slack);
        for (std::size_t at = 0; at < of_band.size(); at += row_bytes) {
            std::memcpy(row.data(), of_band.data() + at, row_bytes);
            end = find_tokens(row[0], row.data() + 1, int(row_bytes) - 1, pixel_bytes, end);
        }
        band.adler = libdeflate_adler32(1, of_band.data(), of_band.size());
        band.size = of_band.size();
        band.packed = pack_tokens({tokens.get(), end}, pixel_bytes);
    });
    std::uint32_t adler = 1;
    std::size_t size = 0;
    for (const Band& band : bands) adler = joined(adler, band.adler, band.size), size += band.packed.size();
    Bytes out;
    out.reserve(size + 8);
    const auto append = [&](std::initializer_list<std::uint32_t> bytes) {
        for (const std::uint32_t byte : bytes) out.push_back(std::byte(byte & 0xff));
    };
    append({0x78, 0x01});
    for (const Band& band : bands) out.insert(out.end(), band.packed.begin(), band.packed.end());
    append({0x03, 0x00});  // an empty block, the last one
    append({adler >> 24, adler >> 16, adler >> 8, adler});
    return out;
}

Bytes pack_runs(const Image8& image) {
    const std::size_t bytes = std::size_t(image.width) * std::size_t(image.channels);
    std::vector<std::uint8_t> rows((1 + bytes) * std::size_t(image.height));
    for (int y = 0; y < image.height; ++y)
        std::memcpy(&rows[std::size_t(y) * (1 + bytes) + 1], image.pixel(0, y), bytes);
    return pack_runs(rows, 1 + bytes, image.channels);
}

}  // namespace raster
