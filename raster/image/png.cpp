// png.cpp: stb_image_write, with libdeflate or pack_runs behind its hook; and what it does not write.
#include <raster/image/png.h>

#include <libdeflate.h>

#include <array>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <new>
#include <span>
#include <utility>

#include <raster/image/limits.h>
#include <raster/image/malloc_block.h>
#include <raster/image/png_runs.h>
#include <raster/lanes_storage.h>
#include <raster/tiles/parallel.h>

namespace raster {
namespace {

// Measured on ten pictures of 1920x1080, from renders of models to a photograph: filter Up at level 1 takes
// 23 to 33 ms of one core for RGBA (renders as RGB: 17 to 20) and 17 to 2500 kB, stb alone 90 to 290 ms and
// 85 to 3600 kB. Level 2 saves up to 6 % of the bytes, but takes twice the time where there is noise; the
// best filter for each row takes 15 ms more and saves 1 to 6 %.
constexpr int deflate_level = 1;
constexpr int filter_up = 2;

/// Of the picture that this thread is about to have stb write the fast way.
struct FastRows {
    std::size_t row_bytes;
    int pixel_bytes;
};
thread_local const FastRows* fast_rows = nullptr;

/// pack_runs, for stb.
unsigned char* compress_fast(std::span<const unsigned char> rows, FastRows fast, int* compressed_size) try {
    const Bytes packed = pack_runs(rows, fast.row_bytes, fast.pixel_bytes);
    auto* const block = static_cast<unsigned char*>(std::malloc(packed.size()));
    if (block) std::memcpy(block, packed.data(), packed.size());
    *compressed_size = int(packed.size());
    return block;
} catch (const std::bad_alloc&) {  // stb could not free its memory if it passed through
    return nullptr;
}

/// `size` bytes as a zlib stream (RFC 1950), or nullptr when memory is short. Has the form stb expects.
unsigned char* zlib_compress(unsigned char* data, int size, int* compressed_size, int /*stb's level*/) {
    // Taken before the packer waits for other threads: in the meantime this one may be given another picture to write.
    if (const FastRows* const fast = std::exchange(fast_rows, nullptr))
        return compress_fast({data, std::size_t(size)}, *fast, compressed_size);
    const std::unique_ptr<libdeflate_compressor, void (*)(libdeflate_compressor*)> compressor(
        libdeflate_alloc_compressor(deflate_level), libdeflate_free_compressor);
    if (!compressor) return nullptr;
    const std::size_t bound = libdeflate_zlib_compress_bound(compressor.get(), std::size_t(size));
    MallocBlock<unsigned char> block(static_cast<unsigned char*>(std::malloc(bound)));
    if (!block) return nullptr;
    const std::size_t used =
        libdeflate_zlib_compress(compressor.get(), data, std::size_t(size), block.get(), bound);
    *compressed_size = int(used);
    return used > 0 ? block.release() : nullptr;
}

}  // namespace
}  // namespace raster

// Static: a program that brings an stb of its own must still link.
#define STB_IMAGE_WRITE_STATIC
#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STBI_WRITE_NO_STDIO
#define STBIW_ZLIB_COMPRESS raster::zlib_compress
#define STBIW_CRC32(data, size) libdeflate_crc32(0, data, std::size_t(size))
#include <stb/stb_image_write.h>

namespace raster {
namespace {

Error no_memory() { return {ErrorKind::input_output, "PNG: not enough memory to encode the picture"}; }

/// Lays out the file: signature, then chunks of length, type, data and checksum (PNG, section 5).
class PngFile {
public:
    /// Of about so many bytes in all chunks.
    explicit PngFile(std::size_t bytes) {
        bytes_.reserve(bytes + 100);
        append("\x89PNG\r\n\x1a\n", 8);
    }

    void chunk(const char* type, const void* data, std::size_t size) {
        append_u32(std::uint32_t(size));
        const std::size_t start = bytes_.size();
        append(type, 4);
        append(data, size);
        append_u32(libdeflate_crc32(0, bytes_.data() + start, bytes_.size() - start));
    }
    Bytes take() { return std::move(bytes_); }

private:
    void append(const void* data, std::size_t size) {
        const auto* first = static_cast<const std::byte*>(data);
        bytes_.insert(bytes_.end(), first, first + size);
    }
    void append_u32(std::uint32_t value) {
        const std::array<std::uint8_t, 4> big_endian = {std::uint8_t(value >> 24), std::uint8_t(value >> 16),
                                                        std::uint8_t(value >> 8), std::uint8_t(value)};
        append(big_endian.data(), 4);
    }
    Bytes bytes_;
};

constexpr std::uint8_t color_types[] = {0, 4, 2, 6};  // grey, grey and alpha, RGB, RGBA
constexpr std::uint8_t indexed_color_type = 3;

std::array<std::uint8_t, 13> image_header(int width, int height, int bit_depth, std::uint8_t color_type) {
    const auto byte = [](int value, int shift) { return std::uint8_t(value >> shift); };
    return {byte(width, 24),  byte(width, 16),  byte(width, 8),  byte(width, 0),
            byte(height, 24), byte(height, 16), byte(height, 8), byte(height, 0),
            std::uint8_t(bit_depth), color_type,
            0, 0, 0};  // deflate, adaptive filters, not interlaced
}

/// Rows of big-endian samples, each byte less the one above it, each row led by its filter's number.
std::vector<unsigned char> filter_rows(const Image16& image) {
    const std::size_t row_samples = std::size_t(image.width) * std::size_t(image.channels);
    std::vector<unsigned char> filtered((1 + 2 * row_samples) * std::size_t(image.height));
    const std::vector<std::uint16_t> zeros(row_samples);
    const std::uint16_t* above = zeros.data();
    unsigned char* out = filtered.data();
    for (int y = 0; y < image.height; ++y) {
        const std::uint16_t* row = image.pixel(0, y);
        *out++ = filter_up;
        for (std::size_t i = 0; i < row_samples; ++i) {
            *out++ = static_cast<unsigned char>((row[i] >> 8) - (above[i] >> 8));
            *out++ = static_cast<unsigned char>(row[i] - above[i]);
        }
        above = row;
    }
    return filtered;
}

}  // namespace

Result<Bytes> encode_png(const Image8& image) {
    if (const Status status = check_image(image); !status) return status.error();
    static const bool configured = [] {
        stbi_write_force_png_filter = filter_up;
        return true;
    }();
    (void)configured;

    struct Output {
        Bytes bytes;
        bool complete = false;
    } output;
    const auto receive = [](void* context, void* data, int size) {
        auto& out = *static_cast<Output*>(context);
        const auto* first = static_cast<const std::byte*>(data);
        try {
            out.bytes.assign(first, first + size);
            out.complete = true;
        } catch (const std::bad_alloc&) {  // stb could not free its memory if it passed through
        }
    };
    const int packed_rows = 0;
    stbi_write_png_to_func(receive, &output, image.width, image.height, image.channels, image.samples.data(),
                           packed_rows);
    if (!output.complete) return no_memory();
    return std::move(output.bytes);
}

Result<Bytes> encode_png(const Image16& image) {
    if (const Status status = check_image(image); !status) return status.error();
    try {
        std::vector<unsigned char> filtered = filter_rows(image);
        int size = 0;
        const MallocBlock<unsigned char> compressed(zlib_compress(filtered.data(), int(filtered.size()), &size, 0));
        if (!compressed) return no_memory();
        const auto header = image_header(image.width, image.height, 16, color_types[image.channels - 1]);
        PngFile file{std::size_t(size)};
        file.chunk("IHDR", header.data(), header.size());
        file.chunk("IDAT", compressed.get(), std::size_t(size));
        file.chunk("IEND", nullptr, 0);
        return file.take();
    } catch (const std::bad_alloc&) {
        return no_memory();
    }
}

Status check_image(const PackedImage& image) {
    std::string problem = size_problem(image.width, image.height);
    if (problem.empty() && image.pixels.size() != std::size_t(image.width) * std::size_t(image.height))
        problem = "the number of pixels is not width * height";
    if (!problem.empty()) return Error{ErrorKind::usage, "image: " + problem};
    return Done{};
}

Image8 unpacked(const PackedImage& image) {
    Image8 result(image.width, image.height, image.has_alpha ? 4 : 3);
    tiles::parallel_for(std::size_t(image.height), [&](std::size_t y) {
        const std::uint32_t* pixel = image.pixels.data() + y * std::size_t(image.width);
        const std::uint32_t* const last = pixel + image.width - 1;
        std::uint8_t* to = result.pixel(0, int(y));
        // What is written behind a pixel is overwritten by the next ones.
#if defined(__SSSE3__) && RASTER_VECTOR_EXTENSIONS  // has one instruction for this
        using Pixels = std::uint8_t __attribute__((vector_size(16)));
        for (; result.channels == 3 && last - pixel > 4; pixel += 4, to += 12) {
            Pixels four;
            std::memcpy(&four, pixel, sizeof four);
            four = __builtin_shufflevector(four, four, 0, 1, 2, 4, 5, 6, 8, 9, 10, 12, 13, 14, 3, 7, 11, 15);
            std::memcpy(to, &four, sizeof four);
        }
#endif
        for (; pixel != last; ++pixel, to += result.channels) {
            const std::uint8_t bytes[] = {std::uint8_t(*pixel), std::uint8_t(*pixel >> 8), std::uint8_t(*pixel >> 16),
                                          std::uint8_t(*pixel >> 24)};
            std::memcpy(to, bytes, 4);
        }
        for (int c = 0; c < result.channels; ++c) to[c] = std::uint8_t(*last >> (8 * c));
    });
    return result;
}

Result<Bytes> encode_png_fast(const Image8& image) {
    const FastRows rows{1 + std::size_t(image.width) * std::size_t(image.channels), image.channels};
    struct Reset {
        ~Reset() { fast_rows = nullptr; }
    } at_the_end;
    fast_rows = &rows;
    return encode_png(image);
}

Result<Bytes> encode_png(const IndexedImage& image) {
    if (const Status status = check_image(image.indices); !status) return status.error();
    try {
        // Numbers of colours have no slope to predict: no filters.
        const Bytes packed = pack_runs(image.indices);
        const auto header = image_header(image.indices.width, image.indices.height, 8, indexed_color_type);
        PngFile file{packed.size() + 3 * image.palette.size()};
        file.chunk("IHDR", header.data(), header.size());
        file.chunk("PLTE", image.palette.data(), 3 * image.palette.size());
        file.chunk("IDAT", packed.data(), packed.size());
        file.chunk("IEND", nullptr, 0);
        return file.take();
    } catch (const std::bad_alloc&) {
        return no_memory();
    }
}

Status write_png(const std::string& path, const Image8& image) {
    const Result<Bytes> bytes = encode_png(image);
    return bytes ? write_file(path, *bytes) : Status(bytes.error());
}

Status write_png(const std::string& path, const Image16& image) {
    const Result<Bytes> bytes = encode_png(image);
    return bytes ? write_file(path, *bytes) : Status(bytes.error());
}

}  // namespace raster
