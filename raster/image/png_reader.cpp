// png_reader.cpp: chunks of PNG and libdeflate (https://www.w3.org/TR/png/).
#include <raster/image/png_reader.h>

#include <libdeflate.h>

#include <array>
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
#include <raster/image/png_filters.h>

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
    back_with_pages(contents.joined.data(), total);
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
        Byte* const bytes = image.samples.data();
        if (!undo_png_filters(step, bytes, row_bytes, contents.height, bytes, row_bytes)) return std::nullopt;
        image.samples.resize(row_bytes * contents.height);
        return image;
    }
    const MallocBlock<Byte> filtered(static_cast<Byte*>(std::malloc(size)));
    if (!filtered) return std::nullopt;
    if (!inflate(contents.data, filtered.get(), size)) return std::nullopt;
    // In place too. Then big-endian pairs become numbers.
    Byte* const rows = filtered.get() + 1;
    if (!undo_png_filters(step, filtered.get(), row_bytes, contents.height, rows, 1 + row_bytes)) return std::nullopt;
    Image16 image(width, height, contents.channels);
    std::uint16_t* out = image.samples.data();
    for (std::uint32_t y = 0; y < contents.height; ++y) {
        const Byte* in = rows + y * (1 + row_bytes);
        for (std::size_t i = 0; i < row_bytes; i += 2) *out++ = std::uint16_t(in[i] << 8 | in[i + 1]);
    }
    return image;
} catch (const std::bad_alloc&) {
    return std::nullopt;
}

}  // namespace raster
