// write.cpp: extension to encoder.
#include <raster/image/write.h>

#include <filesystem>
#include <new>

#include <raster/image/file.h>
#include <raster/image/limits.h>
#include <raster/image/png.h>
#include <raster/image/pnm.h>

namespace raster {
namespace {

namespace fs = std::filesystem;

template <class T>
Image<T> with_grey_repeated(const Image<T>& grey) {
    Image<T> rgb(grey.width, grey.height, 3);
    for (std::size_t pixel = 0; pixel < rgb.samples.size() / 3; ++pixel)
        for (std::size_t c = 0; c < 3; ++c)
            rgb.samples[3 * pixel + c] = grey.samples[pixel * std::size_t(grey.channels)];
    return rgb;
}

template <class T>
Result<Bytes> encode(const std::string& path, OutputFormat format, const Image<T>& image) {
    const bool is_grey = image.channels < 3;
    if (format == OutputFormat::pfm)
        return Error{ErrorKind::usage, path + ": a PFM holds floats; this picture has whole numbers"};
    if (format == OutputFormat::pgm && !is_grey)
        return Error{ErrorKind::usage, path + ": a PGM holds grey; this picture has colours"};
    if (format == OutputFormat::png) {
        if constexpr (sizeof(T) == 1) return encode_png_fast(image);
        return encode_png(image);
    }
    if (format == OutputFormat::pgm || !is_grey) return encode_pnm(image);
    try {
        return encode_pnm(with_grey_repeated(image));
    } catch (const std::bad_alloc&) {
        return Error{ErrorKind::input_output, path + ": not enough memory to encode the picture"};
    }
}

template <class T>
Status write_whole_numbers(const std::string& path, const Image<T>& image) {
    if (const Status status = check_image(image); !status) return status;
    const Result<OutputFormat> format = output_format(path, OutputFormat::png);
    if (!format) return format.error();
    const Result<Bytes> bytes = encode(path, *format, image);
    return bytes ? write_file(path, *bytes) : bytes.error();
}

}  // namespace

Result<OutputFormat> output_format(const std::string& path, OutputFormat otherwise) {
    std::string extension = fs::path(path).extension().string();
    for (char& c : extension) c = c >= 'A' && c <= 'Z' ? char(c - 'A' + 'a') : c;
    if (extension == ".png") return OutputFormat::png;
    if (extension == ".ppm") return OutputFormat::ppm;
    if (extension == ".pgm") return OutputFormat::pgm;
    if (extension == ".pfm") return OutputFormat::pfm;
    std::error_code ignored;
    const fs::file_status target = fs::status(path, ignored);
    const bool is_device = fs::exists(target) && !fs::is_regular_file(target) && !fs::is_directory(target);
    if (path == "-" || (extension.empty() && is_device)) return otherwise;
    return Error{ErrorKind::usage, path + ": the extension must be .png, .ppm, .pgm or .pfm"};
}

Status write_image(const std::string& path, const Image8& image) { return write_whole_numbers(path, image); }
Status write_image(const std::string& path, const Image16& image) { return write_whole_numbers(path, image); }

Status write_image(const std::string& path, const PackedImage& image) {
    if (const Status status = check_image(image); !status) return status;
    const Result<OutputFormat> format = output_format(path, OutputFormat::png);
    if (!format) return format.error();
    try {
        const bool with_alpha = image.has_alpha && *format == OutputFormat::png;
        return write_image(path, unpacked({image.width, image.height, image.pixels, with_alpha}));
    } catch (const std::bad_alloc&) {
        return Error{ErrorKind::input_output, path + ": not enough memory to encode the picture"};
    }
}

Status write_image(const std::string& path, const ImageF& image) {
    const Result<OutputFormat> format = output_format(path, OutputFormat::pfm);
    if (!format) return format.error();
    if (*format != OutputFormat::pfm)
        return Error{ErrorKind::usage, path + ": floats are written as .pfm; convert the picture for others"};
    const Result<Bytes> bytes = encode_pfm(image);
    return bytes ? write_file(path, *bytes) : bytes.error();
}

}  // namespace raster
