// pnm.cpp: a header in words and numbers, then the samples.
#include <raster/image/pnm.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstring>
#include <new>

namespace raster {
namespace {

Error no_memory(const std::string& name) {
    return {ErrorKind::input_output, name + ": not enough memory for the picture"};
}

// The formats keep 1 or 3 channels; grey and alpha becomes grey, RGBA becomes RGB.
int kept_channels(int channels) { return channels < 3 ? 1 : 3; }

/// The header's text, then room for the samples.
template <class T>
struct Encoder {
    Bytes bytes;
    std::byte* samples;

    Encoder(const Image<T>& image, const std::string& magic, const std::string& last_line) {
        const std::string size = std::to_string(image.width) + " " + std::to_string(image.height);
        const std::string header = magic + "\n" + size + "\n" + last_line + "\n";
        const std::size_t count = std::size_t(image.width) * std::size_t(image.height) *
                                  std::size_t(kept_channels(image.channels));
        bytes.resize(header.size() + count * sizeof(T));
        std::memcpy(bytes.data(), header.data(), header.size());
        samples = bytes.data() + header.size();
    }
};

template <class T>
Result<Bytes> encode_whole_numbers(const Image<T>& image, const char* maxval) {
    if (const Status status = check_image(image); !status) return status.error();
    try {
        const int kept = kept_channels(image.channels);
        Encoder<T> out(image, kept == 1 ? "P5" : "P6", maxval);
        for (std::size_t pixel = 0; pixel < image.samples.size(); pixel += std::size_t(image.channels)) {
            for (int c = 0; c < kept; ++c) {
                const T sample = image.samples[pixel + std::size_t(c)];
                if constexpr (sizeof(T) == 2) *out.samples++ = std::byte(sample >> 8);
                *out.samples++ = std::byte(sample & 0xff);
            }
        }
        return std::move(out.bytes);
    } catch (const std::bad_alloc&) {
        return no_memory("PNM");
    }
}

/// Reads a header word by word: white space parts them, and # starts a comment to the end of the line.
class HeaderReader {
public:
    explicit HeaderReader(std::span<const std::byte> file) : file_(file) {}

    std::string word() {
        skip_white_space();
        std::string word;
        constexpr std::size_t longest = 32;
        while (position_ < file_.size() && !is_white(at()) && word.size() < longest) word += take();
        return word;
    }
    /// A whole number of at most 9 digits, or -1.
    int number() {
        const std::string digits = word();
        if (digits.empty() || digits.size() > 9) return -1;
        int value = 0;
        for (const char digit : digits) {
            if (digit < '0' || digit > '9') return -1;
            value = 10 * value + (digit - '0');
        }
        return value;
    }
    /// What follows the single white space after the header.
    std::span<const std::byte> samples() const {
        return file_.subspan(std::min(position_ + 1, file_.size()));
    }

private:
    static bool is_white(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }
    char at() const { return char(file_[position_]); }
    char take() { return char(file_[position_++]); }
    void skip_white_space() {
        while (position_ < file_.size() && (is_white(at()) || at() == '#')) {
            if (take() == '#')
                while (position_ < file_.size() && at() != '\n' && at() != '\r') ++position_;
        }
    }
    std::span<const std::byte> file_;
    std::size_t position_ = 0;
};

std::size_t sample_count(int width, int height, int channels) {
    return std::size_t(width) * std::size_t(height) * std::size_t(channels);
}

struct PnmHeader {
    int width, height, channels, maxval;
    std::size_t bytes_a_sample() const { return maxval < 256 ? 1 : 2; }
};

template <class T>
Result<std::variant<Image8, Image16>> read_samples(std::span<const std::byte> data, const PnmHeader& header,
                                                   const std::string& name) {
    constexpr std::int64_t largest = sizeof(T) == 1 ? 255 : 65535;
    const int maxval = header.maxval;
    Image<T> image(header.width, header.height, header.channels);
    const auto* in = reinterpret_cast<const unsigned char*>(data.data());
    int most = 0;
    for (T& sample : image.samples) {
        int value = *in++;
        if constexpr (sizeof(T) == 2) value = 256 * value + *in++;
        most = std::max(most, value);
        sample = T((value * largest + maxval / 2) / maxval);
    }
    if (most > maxval)
        return Error{ErrorKind::bad_input, name + ": a sample is " + std::to_string(most) +
                                               ", the header says at most " + std::to_string(maxval)};
    return std::variant<Image8, Image16>(std::move(image));
}

// A line of digits, sign, point and exponent. Read by hand, since strtod obeys the locale.
bool is_number_not_zero(const std::string& text) {
    bool digit = false, not_zero = false;
    for (const char c : text.substr(0, text.find_first_of("eE"))) {
        digit |= c >= '0' && c <= '9';
        not_zero |= c >= '1' && c <= '9';
    }
    return digit && not_zero && text.find_first_not_of("0123456789.eE+-") == std::string::npos;
}

}  // namespace

Result<Bytes> encode_pnm(const Image8& image) { return encode_whole_numbers(image, "255"); }
Result<Bytes> encode_pnm(const Image16& image) { return encode_whole_numbers(image, "65535"); }

Result<Bytes> encode_pfm(const ImageF& image) {
    if (const Status status = check_image(image); !status) return status.error();
    try {
        const int kept = kept_channels(image.channels);
        Encoder<float> out(image, kept == 1 ? "Pf" : "PF", "-1.0");  // a negative scale is little-endian
        for (int y = image.height - 1; y >= 0; --y) {                // the bottom row comes first
            for (int x = 0; x < image.width; ++x) {
                for (int c = 0; c < kept; ++c) {
                    const auto bits = std::bit_cast<std::uint32_t>(image.pixel(x, y)[c]);
                    for (int shift = 0; shift < 32; shift += 8) *out.samples++ = std::byte(bits >> shift);
                }
            }
        }
        return std::move(out.bytes);
    } catch (const std::bad_alloc&) {
        return no_memory("PFM");
    }
}

Result<std::variant<Image8, Image16>> decode_pnm(std::span<const std::byte> file, const std::string& name,
                                                 const ImageLimits& limits) {
    const auto bad = [&](const std::string& why) { return Error{ErrorKind::bad_input, name + ": " + why}; };
    HeaderReader reader(file);
    const std::string magic = reader.word();
    if (magic != "P5" && magic != "P6") return bad("not a PGM (P5) or PPM (P6) file");
    PnmHeader header{};
    header.channels = magic == "P5" ? 1 : 3;
    header.width = reader.number();
    header.height = reader.number();
    header.maxval = reader.number();
    if (header.width < 0 || header.height < 0 || header.maxval < 1 || header.maxval > 65535)
        return bad("the header is not a width, a height and a largest value of 1 to 65535");
    const std::string problem = size_problem(header.width, header.height, limits);
    if (!problem.empty()) return bad(problem);
    const std::span<const std::byte> samples = reader.samples();
    const std::size_t count = sample_count(header.width, header.height, header.channels);
    if (samples.size() < count * header.bytes_a_sample()) return bad("truncated: the samples end early");
    try {
        return header.bytes_a_sample() == 1 ? read_samples<std::uint8_t>(samples, header, name)
                                            : read_samples<std::uint16_t>(samples, header, name);
    } catch (const std::bad_alloc&) {
        return no_memory(name);
    }
}

Result<ImageF> decode_pfm(std::span<const std::byte> file, const std::string& name,
                          const ImageLimits& limits) {
    const auto bad = [&](const std::string& why) { return Error{ErrorKind::bad_input, name + ": " + why}; };
    HeaderReader header(file);
    const std::string magic = header.word();
    if (magic != "Pf" && magic != "PF") return bad("not a PFM (Pf or PF) file");
    const int channels = magic == "Pf" ? 1 : 3;
    const int width = header.number(), height = header.number();
    const std::string scale = header.word();
    if (width < 0 || height < 0 || !is_number_not_zero(scale))
        return bad("the header is not a width, a height and a scale other than zero");
    const std::string problem = size_problem(width, height, limits);
    if (!problem.empty()) return bad(problem);
    const std::span<const std::byte> samples = header.samples();
    if (samples.size() < sample_count(width, height, channels) * sizeof(float))
        return bad("truncated: the samples end early");
    const bool little_endian = scale[0] == '-';
    try {
        ImageF image(width, height, channels);
        const auto* in = reinterpret_cast<const unsigned char*>(samples.data());
        for (int y = height - 1; y >= 0; --y) {  // the bottom row comes first
            float* row = image.pixel(0, y);
            for (int i = 0; i < width * channels; ++i, in += 4) {
                std::uint32_t bits = 0;
                for (int b = 0; b < 4; ++b) bits = bits << 8 | in[little_endian ? 3 - b : b];
                row[i] = std::bit_cast<float>(bits);
            }
        }
        return image;
    } catch (const std::bad_alloc&) {
        return no_memory(name);
    }
}

}  // namespace raster
