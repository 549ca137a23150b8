// diff_prepare.cpp: makes two pictures comparable: one type, one set of channels, ignored pixels out of the way.
#include <raster/image/diff_steps.h>

#include <algorithm>
#include <type_traits>

namespace raster::diff_steps {
namespace {

template <class T>
constexpr int bits_of = std::is_same_v<T, float> ? 32 : 8 * int(sizeof(T));

/// Largest value: opaque in an alpha channel.
template <class T>
constexpr T full = std::is_same_v<T, float> ? T(1) : std::numeric_limits<T>::max();

template <class From, class To>
Image<To> convert(const Image<From>& in, int channels) {
    const auto widen = [](From v) {
        if constexpr (std::is_same_v<From, To>) return v;
        else return To(v * 257);  // only 8 to 16 bits happens
    };
    Image<To> out(in.width, in.height, channels);
    const std::size_t pixels = std::size_t(in.width) * std::size_t(in.height);
    const bool grey_in = in.channels < 3, alpha_in = in.channels % 2 == 0, alpha_out = channels % 2 == 0;
    const int colors_out = channels < 3 ? 1 : 3;
    for (std::size_t i = 0; i < pixels; ++i) {
        const From* from = in.samples.data() + i * std::size_t(in.channels);
        To* to = out.samples.data() + i * std::size_t(channels);
        for (int c = 0; c < colors_out; ++c) to[c] = widen(from[grey_in ? 0 : c]);
        if (alpha_out) to[colors_out] = alpha_in ? widen(from[in.channels - 1]) : full<To>;
    }
    return out;
}

template <class From>
AnyImage convert_bits(const Image<From>& in, int bits, int channels) {
    if (bits_of<From> == bits) return convert<From, From>(in, channels);
    if constexpr (std::is_same_v<From, std::uint8_t>) return convert<From, std::uint16_t>(in, channels);
    return in;
}

}  // namespace

Shape shape_of(const AnyImage& image) {
    return std::visit(
        []<class T>(const Image<T>& held) { return Shape{held.width, held.height, held.channels, bits_of<T>}; }, image);
}

Result<Image8> pixels_that_count(const Shape& shape, const DiffOptions& options) {
    const Image8& mask = options.mask;
    if (mask.empty() && options.ignored.empty()) return Image8{};
    if (!mask.empty() && (mask.width != shape.width || mask.height != shape.height))
        return Error{ErrorKind::usage, "diff: the mask is " + std::to_string(mask.width) + "x" +
                                           std::to_string(mask.height) + ", the pictures are " + shape.size()};
    Image8 counts(shape.width, shape.height, 1, 1);
    for (int y = 0; y < mask.height; ++y)
        for (int x = 0; x < mask.width; ++x) {
            const std::uint8_t* pixel = mask.pixel(x, y);
            const int brightest = mask.channels < 3 ? pixel[0] : std::max({pixel[0], pixel[1], pixel[2]});
            const bool opaque = mask.channels % 2 != 0 || pixel[mask.channels - 1] >= 128;
            *counts.pixel(x, y) = std::uint8_t(opaque && brightest >= 128);
        }
    for (const PixelRect& rect : options.ignored) {
        // In 64 bits, since x + width may be anything.
        const auto end = [](int start, int length, int limit) {
            return int(std::clamp<std::int64_t>(std::int64_t(start) + length, 0, limit));
        };
        const int x0 = std::clamp(rect.x, 0, shape.width), x1 = end(rect.x, rect.width, shape.width);
        for (int y = std::clamp(rect.y, 0, shape.height); y < end(rect.y, rect.height, shape.height); ++y)
            if (x0 < x1) std::fill(counts.pixel(x0, y), counts.pixel(x0, y) + (x1 - x0), std::uint8_t(0));
    }
    const auto counted = std::count(counts.samples.begin(), counts.samples.end(), 1);
    if (counted == 0) return Error{ErrorKind::usage, "diff: mask and ignored rectangles leave no pixel to compare"};
    if (std::size_t(counted) == counts.samples.size()) return Image8{};
    return counts;
}

std::string nan_report(const AnyImage& image, const Image8& compared, const std::string& which) {
    const auto* floats = std::get_if<ImageF>(&image);
    if (floats == nullptr) return "";
    std::int64_t count = 0;
    std::size_t first = 0;
    for (std::size_t i = 0; i < floats->samples.size(); ++i) {
        if (floats->samples[i] == floats->samples[i]) continue;
        const std::size_t pixel = i / std::size_t(floats->channels);
        if (!compared.empty() && compared.samples[pixel] == 0) continue;
        if (count++ == 0) first = pixel;
    }
    if (count == 0) return "";
    const std::size_t width = std::size_t(floats->width);
    return "the " + which + " picture has " + std::to_string(count) + " NaN, first at (" +
           std::to_string(first % width) + "," + std::to_string(first / width) + ")";
}

AnyImage adapted(const AnyImage& image, int bits, int channels) {
    return std::visit([&](const auto& held) { return convert_bits(held, bits, channels); }, image);
}

AnyImage with_ignored_equal(const AnyImage& expected, AnyImage actual, const Image8& compared) {
    std::visit(
        [&]<class T>(Image<T>& held) {
            const auto& other = std::get<Image<T>>(expected);
            const std::size_t channels = std::size_t(held.channels);
            for (std::size_t i = 0; i < compared.samples.size(); ++i)
                if (compared.samples[i] == 0)
                    std::copy_n(other.samples.begin() + std::ptrdiff_t(i * channels), channels,
                                held.samples.begin() + std::ptrdiff_t(i * channels));
        },
        actual);
    return actual;
}

PlainMetrics plain(const AnyImage& expected, const AnyImage& actual, std::int64_t compared, std::vector<float> zeros) {
    return std::visit(
        [&]<class T>(const Image<T>& held) {
            return plain_metrics(held, std::get<Image<T>>(actual), compared, std::move(zeros));
        },
        expected);
}

}  // namespace raster::diff_steps
