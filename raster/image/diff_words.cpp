// diff_words.cpp: numbers as text by std::to_chars, which knows no locale.
#include <raster/image/diff_words.h>

#include <array>
#include <charconv>
#include <cmath>

namespace raster {
namespace {

template <class... Format>
std::string written(double value, Format... format) {
    if (std::isnan(value)) return "nan";
    if (std::isinf(value)) return value < 0 ? "-inf" : "inf";
    std::array<char, 400> buffer;
    const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, format...);
    return std::string(buffer.data(), end.ptr);
}

/// Digits after the point that a FLIP value is shown with.
int flip_digits(double value) {
    int digits = 3;
    for (double unit = 0.0005; value > 0 && value < unit && digits < 9; unit /= 10) ++digits;
    return digits;
}

}  // namespace

std::string exact_number(double value) {
    if (std::isinf(value) || std::isnan(value) || double(float(value)) != value) return written(value);
    // What came from a float needs a float's digits only.
    std::array<char, 64> buffer;
    const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), float(value));
    return std::string(buffer.data(), end.ptr);
}

std::string fixed_number(double value, int digits) { return written(value, std::chars_format::fixed, digits); }

std::string flip_number(double value) { return fixed_number(value, flip_digits(value)); }

double rounded_up_flip(double value) {
    if (value <= 0) return 0;
    double scale = 1;
    for (int i = flip_digits(value); i > 0; --i) scale *= 10;
    const double up = std::ceil(value * scale) / scale;
    return up < value ? (std::ceil(value * scale) + 1) / scale : up;
}

std::string ssim_number(double value) { return fixed_number(std::floor(value * 1e4) / 1e4, 4); }

std::string significant_number(double value) {
    if (value == 0 || std::isinf(value) || std::isnan(value)) return written(value);
    int digits = 3;
    for (double unit = 1; value < unit && digits < 12; unit /= 10) ++digits;
    for (double unit = 10; value >= unit && digits > 0; unit *= 10) --digits;
    return fixed_number(value, digits);
}

std::string psnr_number(double value) { return fixed_number(value, 2); }

std::string grouped(long long value) {
    const std::string digits = std::to_string(value);
    std::string words;
    for (std::size_t i = 0; i < digits.size(); ++i) {
        if (i > 0 && (digits.size() - i) % 3 == 0 && digits[i - 1] != '-') words += ',';
        words += digits[i];
    }
    return words;
}

}  // namespace raster
