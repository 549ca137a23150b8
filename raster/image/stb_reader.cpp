// stb_reader.cpp: the one place that holds stb_image, fed through a source that notices when it runs dry.
#include <raster/image/stb_reader.h>

#include <libdeflate.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <new>
#include <vector>

#include <raster/image/bytes.h>
#include <raster/image/malloc_block.h>

namespace raster {
namespace {

/// The memory stb may take: no block beyond `largest_block`, or a small file could unpack without end.
struct Memory {
    std::size_t largest_block = 0;
    bool refused = false;    ///< stb asked for more
    bool exhausted = false;  ///< the system had no more
};
thread_local Memory memory;

// Zeroed, so that even what stb never writes is the same on every run.
void* stb_reallocate(void* block, std::size_t old_size, std::size_t size) {
    memory.refused |= size > memory.largest_block;
    if (size > memory.largest_block) return nullptr;
    void* grown = block == nullptr ? std::calloc(1, size) : std::realloc(block, size);
    memory.exhausted |= grown == nullptr;
    if (block != nullptr && grown != nullptr && size > old_size)
        std::memset(static_cast<std::byte*>(grown) + old_size, 0, size - old_size);
    return grown;
}
void* stb_allocate(std::size_t size) { return stb_reallocate(nullptr, 0, size); }

struct BrokenInvariant {};

}  // namespace
}  // namespace raster

// Static: a program that brings an stb of its own must still link.
#define STB_IMAGE_STATIC
#define STB_IMAGE_IMPLEMENTATION
#define STBI_NO_STDIO
#define STBI_NO_LINEAR
#define STBI_NO_HDR
#define STBI_ONLY_PNG
#define STBI_ONLY_JPEG
#define STBI_ONLY_BMP
#define STBI_ONLY_TGA
#define STBI_MALLOC(size) raster::stb_allocate(size)
#define STBI_REALLOC_SIZED(block, old_size, size) raster::stb_reallocate(block, old_size, size)
#define STBI_FREE(block) std::free(block)
// An assertion about a file's content must not end the program.
#define STBI_ASSERT(condition) \
    do { \
        if (!(condition)) throw raster::BrokenInvariant{}; \
    } while (false)
#include <stb/stb_image.h>

namespace raster {
namespace {

using Picture = std::variant<Image8, Image16>;

Error bad_input(const std::string& name, const std::string& why) {
    return {ErrorKind::bad_input, name + ": " + why};
}

/// What stb reads from. Memory given to stb directly would not tell us that it read past the end.
class Source {
public:
    explicit Source(File file) : file_(file) {}

    static const stbi_io_callbacks& callbacks() {
        static const stbi_io_callbacks table = {
            [](void* self, char* to, int size) { return static_cast<Source*>(self)->read(to, size); },
            [](void* self, int size) { static_cast<Source*>(self)->skip(size); },
            [](void* self) { return int(static_cast<Source*>(self)->at_end()); }};
        return table;
    }
    bool ran_dry() const { return ran_dry_; }

private:
    int read(char* to, int size) {
        // stb's first read fills its own buffer. Later ones into that buffer ask for as much as it holds, and
        // may get less; one to any other place asks for what it needs.
        if (stb_buffer_ == nullptr) stb_buffer_ = to;
        const int count = int(std::min(file_.size() - position_, std::size_t(size)));
        if (count == 0 || (to != stb_buffer_ && count < size)) ran_dry_ = true;
        std::copy_n(file_.begin() + std::ptrdiff_t(position_), count, reinterpret_cast<std::byte*>(to));
        position_ += std::size_t(count);
        return count;
    }
    // Skipping past the end is no harm, as long as nothing is read there.
    void skip(int size) { position_ += std::min(file_.size() - position_, std::size_t(std::max(size, 0))); }
    bool at_end() const { return position_ == file_.size(); }

    File file_;
    std::size_t position_ = 0;
    const char* stb_buffer_ = nullptr;
    bool ran_dry_ = false;
};

/// What is wrong with the chunks of a PNG file (PNG, section 5), or "". stb checks no checksum.
std::string png_problem(File file) {
    constexpr std::size_t signature = 8, around_data = 12;
    std::size_t start = signature;
    for (;;) {
        if (file.size() - start < around_data) return "truncated";
        const std::size_t length = big_endian_at(file, start);
        if (length > file.size() - start - around_data) return "truncated";
        const std::string type(reinterpret_cast<const char*>(file.data()) + start + 4, 4);
        if (start == signature && (type != "IHDR" || length != 13)) return "the first chunk is not IHDR";
        const bool has_effect = type == "tRNS" || (type[0] & 0x20) == 0;
        const std::uint32_t checksum = libdeflate_crc32(0, file.data() + start + 4, length + 4);
        if (has_effect && checksum != big_endian_at(file, start + 8 + length))
            return "corrupt: the checksum of chunk " + type + " does not match";
        if (type == "IEND") return "";
        start += length + around_data;
    }
}

/// How many pixels a byte of the format can stand for at the very most. PNG: deflate packs 1032 to 1, and 8
/// pixels into a byte; JPEG: 64 pixels take a bit or more; TGA: a run of 128 pixels takes 2 bytes or more.
std::int64_t pixels_a_byte(StbFormat format) {
    switch (format) {
        case StbFormat::png: return 8 * 1032;
        case StbFormat::jpeg: return 8 * 64;
        case StbFormat::tga: return 64;
        case StbFormat::bmp: break;
    }
    return 8;
}

/// How many scans a JPEG file has (ITU T.81, annex B), or what is wrong with its segments: stb writes past
/// its tables when a Huffman table has more than 256 codes. Markers are looked for where stb looks: after a
/// segment of known length, and in a scan's data at 0xff not followed by 0 or a restart marker.
Result<std::int64_t> jpeg_scans(File file, const std::string& name) {
    enum : std::uint32_t { restart_0 = 0xd0, restart_7 = 0xd7, end_of_image = 0xd9, start_of_scan = 0xda,
                           huffman_tables = 0xc4 };
    std::int64_t scans = 0;
    bool in_scan = false;
    for (std::size_t i = 2; i < file.size();) {
        if (byte_at(file, i) != 0xff) {
            ++i;
            continue;
        }
        while (byte_at(file, i) == 0xff) ++i;
        const std::uint32_t marker = byte_at(file, i++);
        if (in_scan && (marker == 0 || (marker >= restart_0 && marker <= restart_7))) continue;
        if (marker == end_of_image) return scans;
        in_scan = marker == start_of_scan;
        scans += in_scan ? 1 : 0;
        const std::size_t end = i + std::max(big_endian_at(file, i) >> 16, std::uint32_t(2));
        if (marker == huffman_tables) {
            for (std::size_t table = i + 2; table < end;) {
                std::size_t codes = 0;
                for (std::size_t length = 1; length <= 16; ++length) codes += byte_at(file, table + length);
                if (codes > 256) return bad_input(name, "corrupt: a Huffman table of more than 256 codes");
                table += 17 + codes;
            }
        }
        i = end;
    }
    return bad_input(name, "truncated");
}

/// stb keeps 256 palette entries on the stack, fills those the file has (of OS/2 files, four less), and looks
/// up any. So files with a palette are handed over with 256 entries, black at the end; others give no bytes.
Result<std::vector<std::byte>> with_whole_palette(File file, const std::string& name) {
    const std::size_t offset = little_endian_at(file, 10), header = little_endian_at(file, 14);
    const bool os2 = header == 12;
    const std::uint32_t bits_a_pixel = little_endian_at(file, os2 ? 24 : 28) & 0xffff;
    const std::size_t palette = 14 + header, entry = os2 ? 3 : 4;
    if (bits_a_pixel >= 16) return std::vector<std::byte>{};
    if (offset < palette + entry || offset > file.size()) return bad_input(name, "corrupt: no palette");

    const std::size_t used = std::min(offset - palette, 256 * entry);
    const std::size_t new_offset = palette + 256 * entry + (os2 ? 12 : 0);  // where stb counts 256 entries
    std::vector<std::byte> whole(new_offset + file.size() - offset);
    std::copy_n(file.begin(), palette + used, whole.begin());
    std::copy(file.begin() + std::ptrdiff_t(offset), file.end(), whole.begin() + std::ptrdiff_t(new_offset));
    for (std::size_t i = 0; i < 4; ++i) whole[10 + i] = std::byte(new_offset >> (8 * i) & 0xff);
    return whole;
}

struct Size {
    std::int64_t width, height;
};

/// Before a call of stb, whose failures do not all set a reason.
void prepare(std::size_t largest_block) {
    memory = {largest_block, false, false};
    stbi__g_failure_reason = nullptr;
}

/// Why the last call of stb failed.
Error failure(const std::string& name, const Source& source) {
    if (memory.exhausted) throw std::bad_alloc();
    if (source.ran_dry()) return bad_input(name, "truncated");
    if (memory.refused) return bad_input(name, "corrupt: unpacks to more than the size in its header");
    const std::string reason = stbi_failure_reason() == nullptr ? "" : stbi_failure_reason();
    const bool is_about_another_format = reason.empty() || reason == "bad png sig" || reason == "no SOI";
    return bad_input(name, "corrupt or unusual" + (is_about_another_format ? "" : " (" + reason + ")"));
}

Result<Size> read_size(File file, const std::string& name) {
    int width = 0, height = 0, channels = 0;
    Source source(file);
    prepare(std::size_t(1) << 20);
    if (stbi_info_from_callbacks(&Source::callbacks(), &source, &width, &height, &channels) == 0)
        return failure(name, source);
    // A BMP of negative height has its top row first.
    return Size{width, std::abs(std::int64_t(height))};
}

template <class T>
Result<Picture> read_pixels(File file, const std::string& name, Size size) {
    int width = 0, height = 0, channels = 0;
    constexpr int as_in_file = 0;
    constexpr auto load = [] {
        if constexpr (sizeof(T) == 1) return stbi_load_from_callbacks;
        else return stbi_load_16_from_callbacks;
    }();
    Source source(file);
    // 8 bytes a pixel at most, twice that while stb doubles a buffer; JPEG pads to blocks.
    prepare(std::max(std::size_t(16 * (size.width + 64) * (size.height + 64)), 2 * file.size()));
    const MallocBlock<T> samples(
        load(&Source::callbacks(), &source, &width, &height, &channels, as_in_file));
    if (samples == nullptr || source.ran_dry()) return failure(name, source);
    if (width != size.width || height != size.height) return bad_input(name, "corrupt: two sizes");
    Image<T> image(width, height, channels);
    std::copy_n(samples.get(), image.samples.size(), image.samples.begin());
    return Picture(std::move(image));
}

}  // namespace

Result<Picture> read_with_stb(File file, const std::string& name, StbFormat format,
                              const ImageLimits& limits) {
    try {
        // stb finds out the format by itself, and takes what is left for TGA.
        if (format == StbFormat::tga && byte_at(file, 1) > 1) return bad_input(name, "not a TGA file");
        const Result<std::int64_t> scans = format == StbFormat::jpeg ? jpeg_scans(file, name) : 0;
        if (!scans) return scans.error();
        const Result<Size> size = read_size(file, name);
        if (!size) return size.error();
        std::string problem = size_problem(size->width, size->height, limits);
        if (!problem.empty()) return bad_input(name, problem);
        const std::int64_t pixels = size->width * size->height;
        if (pixels / pixels_a_byte(format) > std::int64_t(file.size()))
            return bad_input(name, "truncated: too few bytes for its size");

        if (format == StbFormat::png) {
            problem = png_problem(file);
            if (!problem.empty()) return bad_input(name, problem);
            const bool deep = byte_at(file, 24) == 16;
            return deep ? read_pixels<stbi_us>(file, name, *size) : read_pixels<stbi_uc>(file, name, *size);
        }
        if (*scans > 16 * limits.max_pixels / pixels) return bad_input(name, "too many scans for its size");
        if (format == StbFormat::bmp) {
            const Result<std::vector<std::byte>> whole = with_whole_palette(file, name);
            if (!whole) return whole.error();
            if (!whole->empty()) return read_pixels<stbi_uc>(*whole, name, *size);
        }
        return read_pixels<stbi_uc>(file, name, *size);
    } catch (const std::bad_alloc&) {
        return Error{ErrorKind::input_output, name + ": not enough memory for the picture"};
    } catch (const BrokenInvariant&) {
        return bad_input(name, "corrupt");
    }
}

}  // namespace raster
