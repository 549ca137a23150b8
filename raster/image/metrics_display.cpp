// metrics_display.cpp: sRGB decoding by table, blending over a background, edges repeated.
#include <raster/image/metrics_display.h>

#include <algorithm>
#include <limits>
#include <type_traits>

#include <raster/image/metrics_rows.h>
#include <raster/math.h>

namespace raster {
namespace {

float srgb_to_linear(float v) { return v <= 0.04045f ? v / 12.92f : pow((v + 0.055f) / 1.055f, 2.4f); }
float linear_to_srgb(float v) { return v <= 0.0031308f ? v * 12.92f : 1.055f * pow(v, 1 / 2.4f) - 0.055f; }

template <class T>
const float* decoding_table() {
    static constexpr std::size_t size = std::size_t(std::numeric_limits<T>::max()) + 1;
    static const std::vector<float> table = [] {
        std::vector<float> values(size);
        for (std::size_t i = 0; i < size; ++i) values[i] = srgb_to_linear(float(i) / float(size - 1));
        return values;
    }();
    return table.data();
}

/// Asks for a row that will be read after the present one. In tiles, the processor would not guess it.
template <class T>
void fetch_soon([[maybe_unused]] const Image<T>& image, [[maybe_unused]] int x, [[maybe_unused]] int y,
                [[maybe_unused]] int count) {
#if defined(__GNUC__)
    constexpr int rows_ahead = 4, line = 64;
    if (y < 0 || y + rows_ahead >= image.height || count <= 0) return;
    const char* const first = reinterpret_cast<const char*>(image.pixel(x, y + rows_ahead));
    const std::ptrdiff_t bytes = std::ptrdiff_t(count) * image.channels * std::ptrdiff_t(sizeof(T));
    for (std::ptrdiff_t at = 0; at < bytes; at += line) __builtin_prefetch(first + at);
#endif
}

// NaN, which fails by name before it gets here, becomes 0.
float clamp01(float v) { return v > 0.0f ? min(v, 1.0f) : 0.0f; }

}  // namespace

Display::Display(const AnyImage& image, float background) : image_(&image), background_(background) {
    std::visit(
        [&]<class T>(const Image<T>& held) {
            width_ = held.width;
            height_ = held.height;
            if constexpr (!std::is_same_v<T, float>) {
                linear_of_ = decoding_table<T>();
                scale_ = 1.0f / float(std::numeric_limits<T>::max());
            }
        },
        image);
}

template <bool linear>
void Display::row(int x0, int y, int count, float* red, float* green, float* blue) const {
    const auto read = [&]<class T>(const Image<T>& held, auto channels_constant) {
        constexpr int channels = decltype(channels_constant)::value;
        constexpr bool is_float = std::is_same_v<T, float>;
        constexpr bool grey = channels < 3, alpha = channels % 2 == 0;
        const auto encoded = [&](T sample) {
            float value = float(sample) * scale_;
            if constexpr (is_float) value = linear_to_srgb(clamp01(sample));
            return value;
        };
        const auto value_of = [&](T sample) {
            float value = 0;
            if constexpr (is_float && linear) value = clamp01(sample);
            if constexpr (!is_float && linear) value = linear_of_[sample];
            if constexpr (!linear) value = encoded(sample);
            return value;
        };
        const T* samples = held.pixel(0, std::clamp(y, 0, height_ - 1));
        const auto read_one = [&](int i, int x) {
            const T* pixel = samples + std::ptrdiff_t(x) * channels;
            const float opacity = alpha ? clamp01(float(pixel[channels - 1]) * scale_) : 1.0f;
            float* const out[3] = {red + i, green + i, blue + i};
            for (int c = 0; c < 3; ++c) {
                const T sample = pixel[grey ? 0 : c];
                if (!alpha || opacity == 1.0f) {
                    *out[c] = value_of(sample);
                } else {
                    const float blended = background_ + opacity * (encoded(sample) - background_);
                    *out[c] = linear ? srgb_to_linear(blended) : blended;
                }
            }
        };
        const int first = std::clamp(-x0, 0, count), last = std::clamp(width_ - x0, first, count);
        fetch_soon(held, x0 + first, y, last - first);
        for (int i = 0; i < first; ++i) read_one(i, 0);
        for (int i = first; i < last; ++i) read_one(i, x0 + i);
        for (int i = last; i < count; ++i) read_one(i, width_ - 1);
    };
    std::visit(
        [&](const auto& held) {
            switch (held.channels) {
                case 1: return read(held, std::integral_constant<int, 1>{});
                case 2: return read(held, std::integral_constant<int, 2>{});
                case 3: return read(held, std::integral_constant<int, 3>{});
                default: return read(held, std::integral_constant<int, 4>{});
            }
        },
        *image_);
}

void Display::linear_row(int x0, int y, int count, float* red, float* green, float* blue) const {
    row<true>(x0, y, count, red, green, blue);
}

void Display::encoded_row(int x0, int y, int count, float* red, float* green, float* blue) const {
    row<false>(x0, y, count, red, green, blue);
}

const std::uint8_t* Display::bytes_row(int x0, int y, int count) const {
    const auto* bytes = std::get_if<Image8>(image_);
    if (bytes == nullptr || bytes->channels != 3) return nullptr;
    const int first = std::clamp(x0, 0, width_), last = std::clamp(x0 + count, first, width_);
    fetch_soon(*bytes, first, y, last - first);
    return bytes->pixel(0, std::clamp(y, 0, height_ - 1));
}

void Display::luma_row(int x0, int y, int count, float* luma) const {
    if (const auto* bytes = std::get_if<Image8>(image_); bytes != nullptr && bytes->channels == 3) {
        const int first = std::clamp(-x0, 0, count), last = std::clamp(width_ - x0, first, count);
        const std::uint8_t* row = bytes->pixel(0, std::clamp(y, 0, height_ - 1));
        fetch_soon(*bytes, x0 + first, y, last - first);
        luma_of_bytes(row + 3 * std::ptrdiff_t(x0 + first), last - first, luma + first);
        for (int i = 0; i < first; ++i) luma_of_bytes(row, 1, luma + i);
        for (int i = last; i < count; ++i) luma_of_bytes(row + 3 * std::ptrdiff_t(width_ - 1), 1, luma + i);
        return;
    }
    constexpr int block = 64;
    float red[block], green[block], blue[block];
    for (int i = 0; i < count; i += block) {
        const int n = std::min(block, count - i);
        encoded_row(x0 + i, y, n, red, green, blue);
        for (int k = 0; k < n; ++k) luma[i + k] = 0.299f * red[k] + 0.587f * green[k] + 0.114f * blue[k];
    }
}

const float* linear_of_bytes() { return decoding_table<std::uint8_t>(); }

bool has_transparency(const AnyImage& image) {
    return std::visit(
        []<class T>(const Image<T>& held) {
            if (held.channels % 2 != 0) return false;
            const T opaque = std::is_same_v<T, float> ? T(1) : std::numeric_limits<T>::max();
            for (std::size_t i = std::size_t(held.channels) - 1; i < held.samples.size();
                 i += std::size_t(held.channels))
                if (held.samples[i] < opaque) return true;
            return false;
        },
        image);
}

}  // namespace raster
