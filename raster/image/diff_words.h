// diff_words.h: numbers of comparisons as text, the same on every machine and in every locale.
#pragma once

#include <string>

namespace raster {

/// The shortest text that reads back as this float or small whole number: "3", "0.0123", "inf".
std::string exact_number(double value);

/// With so many digits after the point, rounded to nearest: "1.81".
std::string fixed_number(double value, int digits);

/// A FLIP value: three decimals, and for what would then be 0.000 as many as show one digit, so that only 0 is 0.
std::string flip_number(double value);

/// The least value that flip_number shows and that is not below `value`.
double rounded_up_flip(double value);

/// SSIM with four decimals, rounded down: only 1 is 1.0000.
std::string ssim_number(double value);

/// A number that is four digits at least, for means: "0.00002143", "1.811".
std::string significant_number(double value);

/// In dB with two decimals; "inf" for equal pictures.
std::string psnr_number(double value);

/// 12345678 as "12,345,678".
std::string grouped(long long value);

}  // namespace raster
