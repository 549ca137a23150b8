// png_reader.cpp: chunks, libdeflate and the five filters of PNG (https://www.w3.org/TR/png/).
#include <raster/image/png_reader.h>

#include <libdeflate.h>

#include <array>
#include <bit>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <new>
#include <string_view>
#include <vector>

#include <raster/image/bytes.h>
#include <raster/image/malloc_block.h>
#include <raster/image/pages.h>

namespace raster {
namespace {

using Byte = std::uint8_t;

/// What the header says (PNG, 11.2.1), and where the compressed samples are.
struct Contents {
    std::uint32_t width = 0, height = 0;
    int bits = 0, channels = 0;
    File data;                      ///< the only IDAT chunk, or `joined`
    std::vector<std::byte> joined;  ///< several IDAT chunks in one piece
};

constexpr std::size_t signature = 8, around_data = 12, first_chunk_end = signature + around_data + 13;

bool read_header(File file, const ImageLimits& limits, Contents& contents) {
    constexpr std::array<std::byte, 8> magic = {std::byte(0x89), std::byte('P'), std::byte('N'), std::byte('G'),
                                                std::byte('\r'), std::byte('\n'), std::byte(0x1a), std::byte('\n')};
    if (file.size() < first_chunk_end || std::memcmp(file.data(), magic.data(), magic.size()) != 0) return false;
    if (big_endian_at(file, 8) != 13 || std::memcmp(file.data() + 12, "IHDR", 4) != 0) return false;
    contents.width = big_endian_at(file, 16);
    contents.height = big_endian_at(file, 20);
    contents.bits = int(file[24]);
    switch (int(file[25])) {
        case 0: contents.channels = 1; break;
        case 4: contents.channels = 2; break;
        case 2: contents.channels = 3; break;
        case 6: contents.channels = 4; break;
        default: return false;
    }
    const bool plain = file[26] == std::byte(0) && file[27] == std::byte(0) && file[28] == std::byte(0);
    return plain && (contents.bits == 8 || contents.bits == 16) &&
           size_problem(contents.width, contents.height, limits).empty();
}

/// Finds the samples. Only chunks that change nothing may stand beside them.
bool read_chunks(File file, Contents& contents) {
    std::vector<File> pieces;
    std::size_t total = 0;
    for (std::size_t start = signature;;) {
        if (file.size() - start < around_data) return false;
        const std::size_t length = big_endian_at(file, start);
        if (length > file.size() - start - around_data) return false;
        const std::string_view type(reinterpret_cast<const char*>(file.data()) + start + 4, 4);
        const bool critical = (type[0] & 0x20) == 0;
        if (type == "tRNS") return false;
        if (critical &&
            libdeflate_crc32(0, file.data() + start + 4, length + 4) != big_endian_at(file, start + 8 + length))
            return false;
        if (type == "IDAT") {
            pieces.push_back(file.subspan(start + 8, length));
            total += length;
        } else if (type == "IEND") {
            break;
        } else if (critical && start != signature) {
            return false;
        }
        start += length + around_data;
    }
    if (pieces.size() == 1) {
        contents.data = pieces[0];
        return true;
    }
    contents.joined.reserve(total);
    for (const File piece : pieces) contents.joined.insert(contents.joined.end(), piece.begin(), piece.end());
    contents.data = contents.joined;
    return true;
}

/// False unless there are exactly `size` bytes with a right checksum.
bool inflate(File data, Byte* out, std::size_t size) {
    const std::unique_ptr<libdeflate_decompressor, void (*)(libdeflate_decompressor*)> decompressor(
        libdeflate_alloc_decompressor(), libdeflate_free_decompressor);
    if (!decompressor) throw std::bad_alloc();
    return libdeflate_zlib_decompress(decompressor.get(), data.data(), data.size(), out, size, nullptr) ==
           LIBDEFLATE_SUCCESS;
}

// The bytes of a pixel, widened so that their sums fit: 8 at most, the rest is 0.
using Wide = std::int16_t __attribute__((vector_size(16)));

using Narrow = Byte __attribute__((vector_size(8)));

// Through a register: a vector read back right after its bytes were written one by one makes the processor wait.
template <int step>
Wide load_pixel(const Byte* from) {
    std::uint64_t bytes = 0;
    if constexpr (step == 3 || step == 6) {
        std::uint32_t low = 0;
        std::uint16_t high = 0;
        std::memcpy(&low, from, step - 2);
        std::memcpy(&high, from + step - 2, 2);
        bytes = std::uint64_t(high) << (8 * (step - 2)) | low;
    } else {
        std::memcpy(&bytes, from, step);
    }
    return __builtin_convertvector(std::bit_cast<Narrow>(bytes), Wide);
}

template <int step>
void store_pixel(Byte* to, Wide pixel) {
    const auto bytes = std::bit_cast<std::uint64_t>(__builtin_convertvector(pixel, Narrow));
    std::memcpy(to, &bytes, step);
}

/// The neighbour of left, above and above-left that is nearest to left + above - above-left (PNG, 9.4).
Wide paeth(Wide left, Wide above, Wide corner) {
    const auto absolute = [](Wide x) { return x < 0 ? -x : x; };
    const Wide from_left = absolute(above - corner), from_above = absolute(left - corner);
    const Wide from_corner = absolute(left + above - 2 * corner);
    const Wide nearer = from_above < from_left ? above : left;
    const Wide distance = from_above < from_left ? from_above : from_left;
    return from_corner < distance ? corner : nearer;
}

/// A row of the filters Average, 3, or Paeth, 4, undone from left to right (PNG, 9.2).
template <int step, int filter>
struct Predicted {
    Wide left{}, corner{};
    Wide next(Wide in, Wide above) {
        left = (in + (filter == 4 ? paeth(left, above, corner) : (left + above) >> 1)) & 0xff;
        corner = above;
        return left;
    }
};

using Chunk = Byte __attribute__((vector_size(32)));

// step is the bytes of a pixel: a constant, so that the compiler keeps the pixel to the left in registers. `out` may be
// `in` or lie before it.
template <int step>
bool undo_filter(int filter, const Byte* in, const Byte* above, Byte* out, std::size_t size) {
    std::array<Byte, step> left{};
    std::size_t i = 0;
    switch (filter) {
        case 0: std::memmove(out, in, size); return true;
        case 1:
            for (; i < size; i += step)
                for (int c = 0; c < step; ++c) out[i + c] = left[c] = Byte(in[i + c] + left[c]);
            return true;
        case 2:
            for (Chunk here, up; i + sizeof here <= size; i += sizeof here) {
                std::memcpy(&here, in + i, sizeof here);
                std::memcpy(&up, above + i, sizeof up);
                here += up;
                std::memcpy(out + i, &here, sizeof here);
            }
            for (; i < size; ++i) out[i] = Byte(in[i] + above[i]);
            return true;
        case 3:
            for (; i < size; i += step)
                for (int c = 0; c < step; ++c)
                    out[i + c] = left[c] = Byte(in[i + c] + ((left[c] + above[i + c]) >> 1));
            return true;
        case 4:
            for (Predicted<step, 4> row; i < size; i += step)
                store_pixel<step>(out + i, row.next(load_pixel<step>(in + i), load_pixel<step>(above + i)));
            return true;
        default: return false;
    }
}

/// Two rows of one filter, 3 or 4, the second a pixel behind the first: each pixel waits for the one to its left, so
/// that two rows take little longer than one. `out_2` must not lie in `in_1`.
template <int step, int filter>
void undo_two(const Byte* in_1, const Byte* in_2, const Byte* above, Byte* out_1, Byte* out_2, std::size_t size) {
    Predicted<step, filter> first, second;
    Wide previous = first.next(load_pixel<step>(in_1), load_pixel<step>(above));
    store_pixel<step>(out_1, previous);
    for (std::size_t i = step; i < size; i += step) {
        const Wide pixel = first.next(load_pixel<step>(in_1 + i), load_pixel<step>(above + i));
        store_pixel<step>(out_2 + i - step, second.next(load_pixel<step>(in_2 + i - step), previous));
        store_pixel<step>(out_1 + i, pixel);
        previous = pixel;
    }
    store_pixel<step>(out_2 + size - step, second.next(load_pixel<step>(in_2 + size - step), previous));
}

/// Undoes the filters of all rows; `row(y)` is where row y goes.
template <int step, class Row>
bool undo_filters(const Byte* in, std::size_t row_bytes, std::uint32_t height, const Row& row) {
    const std::vector<Byte> zeros(row_bytes);
    const Byte* above = zeros.data();
    std::vector<Byte> first(row_bytes);
    for (std::uint32_t y = 0; y < height; ++y, in += 1 + row_bytes) {
        Byte* out = row(y);
        const Byte* const next = in + 1 + row_bytes;
        if (y + 1 < height && in[0] == next[0] && (in[0] == 3 || in[0] == 4)) {
            // A copy, since the second row goes where the first one's bytes end.
            std::memcpy(first.data(), in + 1, row_bytes);
            Byte* const below = row(++y);
            (in[0] == 3 ? undo_two<step, 3> : undo_two<step, 4>)(first.data(), next + 1, above, out, below, row_bytes);
            in = next;
            above = below;
            continue;
        }
        if (!undo_filter<step>(in[0], in + 1, above, out, row_bytes)) return false;
        above = out;
    }
    return true;
}

template <class Row>
bool undo_filters(int step, const Byte* in, std::size_t row_bytes, std::uint32_t height, const Row& row) {
    switch (step) {
        case 1: return undo_filters<1>(in, row_bytes, height, row);
        case 2: return undo_filters<2>(in, row_bytes, height, row);
        case 3: return undo_filters<3>(in, row_bytes, height, row);
        case 4: return undo_filters<4>(in, row_bytes, height, row);
        case 6: return undo_filters<6>(in, row_bytes, height, row);
        default: return undo_filters<8>(in, row_bytes, height, row);
    }
}

}  // namespace

std::optional<std::variant<Image8, Image16>> read_common_png(File file, const ImageLimits& limits) try {
    Contents contents;
    if (!read_header(file, limits, contents) || !read_chunks(file, contents)) return std::nullopt;
    const int step = contents.channels * contents.bits / 8;
    const std::size_t row_bytes = std::size_t(contents.width) * std::size_t(step);
    const std::size_t size = (1 + row_bytes) * contents.height;
    // Deflate packs 1032 to 1 at best: memory is taken only for what can be there.
    if (size / 1032 > contents.data.size()) return std::nullopt;
    const int width = int(contents.width), height = int(contents.height);
    if (contents.bits == 8) {
        // In place: a row's bytes are needed no more once they are read, and their filter's byte makes room.
        Image8 image;
        image.width = width, image.height = height, image.channels = contents.channels;
        resize_whole(image.samples, size);
        if (!inflate(contents.data, image.samples.data(), size)) return std::nullopt;
        const auto row = [&](std::uint32_t y) { return image.samples.data() + y * row_bytes; };
        if (!undo_filters(step, image.samples.data(), row_bytes, contents.height, row)) return std::nullopt;
        image.samples.resize(row_bytes * contents.height);
        return image;
    }
    const MallocBlock<Byte> filtered(static_cast<Byte*>(std::malloc(size)));
    if (!filtered) return std::nullopt;
    if (!inflate(contents.data, filtered.get(), size)) return std::nullopt;
    // In place too. Then big-endian pairs become numbers.
    const auto row = [&](std::uint32_t y) { return filtered.get() + y * (1 + row_bytes) + 1; };
    if (!undo_filters(step, filtered.get(), row_bytes, contents.height, row)) return std::nullopt;
    Image16 image(width, height, contents.channels);
    std::uint16_t* out = image.samples.data();
    for (std::uint32_t y = 0; y < contents.height; ++y) {
        const Byte* in = row(y);
        for (std::size_t i = 0; i < row_bytes; i += 2) *out++ = std::uint16_t(in[i] << 8 | in[i + 1]);
    }
    return image;
} catch (const std::bad_alloc&) {
    return std::nullopt;
}

}  // namespace raster
