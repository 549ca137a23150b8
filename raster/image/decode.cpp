// decode.cpp: tells formats apart, hands them to their readers, and converts between sample types.
#include <raster/image/decode.h>

#include <algorithm>
#include <cstring>
#include <new>
#include <string_view>
#include <type_traits>

#include <raster/image/bytes.h>
#include <raster/image/file.h>
#include <raster/image/png_reader.h>
#include <raster/image/pnm.h>
#include <raster/image/stb_reader.h>

namespace raster {
namespace {

bool contains_at(File file, std::size_t position, std::string_view text) {
    return position <= file.size() && text.size() <= file.size() - position &&
           std::memcmp(file.data() + position, text.data(), text.size()) == 0;
}

bool is_tga(File file, const std::string& name) {
    std::string ending = name.size() < 4 ? "" : name.substr(name.size() - 4);
    for (char& c : ending) c = c >= 'A' && c <= 'Z' ? char(c - 'A' + 'a') : c;
    constexpr std::string_view footer("TRUEVISION-XFILE.\0", 18);
    if (ending == ".tga") return true;
    return file.size() > footer.size() && contains_at(file, file.size() - footer.size(), footer);
}

template <class... Types>
Result<AnyImage> widen(Result<std::variant<Types...>> image) {
    if (!image) return image.error();
    return std::visit([](auto& held) { return AnyImage(std::move(held)); }, *image);
}

std::uint8_t convert(std::uint16_t v, std::uint8_t) { return std::uint8_t((v * 255u + 32767u) / 65535u); }
std::uint16_t convert(std::uint8_t v, std::uint16_t) { return std::uint16_t(v * 257); }
float convert(std::uint8_t v, float) { return float(v) / 255.0f; }
float convert(std::uint16_t v, float) { return float(v) / 65535.0f; }

template <class To>
Result<Image<To>> as(Result<AnyImage> image, const std::string& name) {
    if (!image) return image.error();
    try {
        return std::visit(
            [&]<class From>(Image<From>& held) -> Result<Image<To>> {
                if constexpr (std::is_same_v<From, To>) {
                    return std::move(held);
                } else if constexpr (std::is_same_v<From, float>) {
                    return Error{ErrorKind::bad_input, name + ": holds floats, not whole numbers"};
                } else {
                    Image<To> converted(held.width, held.height, held.channels);
                    std::transform(held.samples.begin(), held.samples.end(), converted.samples.begin(),
                                   [](From v) { return convert(v, To{}); });
                    return converted;
                }
            },
            *image);
    } catch (const std::bad_alloc&) {
        return Error{ErrorKind::input_output, name + ": not enough memory for the picture"};
    }
}

}  // namespace

Result<AnyImage> decode_image(File file, const std::string& name, const ImageLimits& limits) {
    const auto stb = [&](StbFormat format) { return widen(read_with_stb(file, name, format, limits)); };
    const auto starts = [&](std::string_view magic) { return contains_at(file, 0, magic); };
    if (starts("\x89PNG\r\n\x1a\n")) {
        auto common = read_common_png(file, limits);
        return common ? widen(Result(std::move(*common))) : stb(StbFormat::png);
    }
    if (starts("\xff\xd8\xff")) return stb(StbFormat::jpeg);
    if (starts("BM")) return stb(StbFormat::bmp);
    if (starts("P5") || starts("P6")) return widen(decode_pnm(file, name, limits));
    if (starts("Pf") || starts("PF")) {
        Result<ImageF> image = decode_pfm(file, name, limits);
        return image ? Result<AnyImage>(std::move(*image)) : image.error();
    }
    if (is_tga(file, name)) return stb(StbFormat::tga);
    const char* what = file.empty() ? ": empty" : ": not a PNG, JPEG, BMP, TGA, PGM, PPM or PFM picture";
    return Error{ErrorKind::bad_input, name + what};
}

Result<Image8> decode_image8(File file, const std::string& name, const ImageLimits& limits) {
    return as<std::uint8_t>(decode_image(file, name, limits), name);
}
Result<Image16> decode_image16(File file, const std::string& name, const ImageLimits& limits) {
    return as<std::uint16_t>(decode_image(file, name, limits), name);
}
Result<ImageF> decode_image_float(File file, const std::string& name, const ImageLimits& limits) {
    return as<float>(decode_image(file, name, limits), name);
}

Result<AnyImage> load_image(const std::string& path, const ImageLimits& limits) {
    // No more than a picture of so many pixels may need, where size_t has 32 bits too.
    const std::uint64_t most = 16 * std::uint64_t(limits.max_pixels) + (1 << 20);
    const Result<Bytes> file = read_file(path, std::size_t(std::min<std::uint64_t>(most, SIZE_MAX)));
    return file ? decode_image(*file, path, limits) : file.error();
}
Result<Image8> load_image8(const std::string& path, const ImageLimits& limits) {
    return as<std::uint8_t>(load_image(path, limits), path);
}
Result<Image16> load_image16(const std::string& path, const ImageLimits& limits) {
    return as<std::uint16_t>(load_image(path, limits), path);
}
Result<ImageF> load_image_float(const std::string& path, const ImageLimits& limits) {
    return as<float>(load_image(path, limits), path);
}

}  // namespace raster
