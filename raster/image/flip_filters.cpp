// flip_filters.cpp: Gaussians and their derivatives, sampled and normalised as the FLIP paper says.
#include <raster/image/flip_filters.h>

#include <algorithm>
#include <cmath>

#include <raster/math.h>

namespace raster::flip {
namespace {

constexpr double pi = 3.14159265358979324;

/// exp(-factor * k * k) for k = 0 to radius.
std::vector<double> gaussian(double factor, int radius) {
    std::vector<double> values;
    for (int k = 0; k <= radius; ++k) values.push_back(raster::exp(float(-factor * k * k)));
    return values;
}

double sum_of_both_sides(const std::vector<double>& half) {
    double sum = half[0];
    for (std::size_t k = 1; k < half.size(); ++k) sum += 2 * half[k];
    return sum;
}

/// Weights times `scale`, without an end of which a float sum would show nothing.
std::vector<float> finish(std::vector<double> half, double scale) {
    while (half.size() > 1 && half.back() < half[0] * 0x1p-27) half.pop_back();
    std::vector<float> weights;
    for (const double w : half) weights.push_back(float(w * scale));
    return weights;
}

}  // namespace

Filters::Filters(float pixels_per_degree) {
    const double ppd = double(pixels_per_degree);

    // The sensitivity a sqrt(pi / b) exp(-pi^2 r^2 / b) at r degrees; b as in table 1. All windows have the radius of
    // the widest, three standard deviations.
    constexpr double b_lightness = 0.0047, b_red_green = 0.0053, b_1 = 0.04, b_2 = 0.025, a_1 = 34.1, a_2 = 13.5;
    const int radius = int(std::ceil(3 * std::sqrt(b_1 / (2 * pi * pi)) * ppd));
    const auto sensitivity = [&](double b) { return gaussian(pi * pi / (b * ppd * ppd), radius); };
    const auto normalised = [](const std::vector<double>& half) { return finish(half, 1 / sum_of_both_sides(half)); };
    lightness = normalised(sensitivity(b_lightness));
    red_green = normalised(sensitivity(b_red_green));
    // Of the sum of two products, the whole is normalised: each takes its share, half of it along x and y each.
    const std::vector<double> first = sensitivity(b_1), second = sensitivity(b_2);
    const double sum_1 = sum_of_both_sides(first), sum_2 = sum_of_both_sides(second);
    const double height_1 = a_1 * std::sqrt(pi / b_1), height_2 = a_2 * std::sqrt(pi / b_2);
    const double whole = height_1 * sum_1 * sum_1 + height_2 * sum_2 * sum_2;
    blue_yellow_1 = finish(first, std::sqrt(height_1 / whole));
    blue_yellow_2 = finish(second, std::sqrt(height_2 / whole));
    blue_yellow_2.resize(blue_yellow_1.size());  // the narrower one; they run together

    // The eye's edge detector has its peak and trough 0.082 degrees apart: two standard deviations.
    const double deviation = 0.5 * 0.082 * ppd;
    const int feature_radius = int(std::ceil(3 * deviation));
    const std::vector<double> bell = gaussian(1 / (2 * deviation * deviation), feature_radius);
    for (const double w : bell) smooth.push_back(float(w / sum_of_both_sides(bell)));

    // Of derivatives, what is above zero sums to 1 and what is below to -1.
    std::vector<double> first_derivative, second_derivative;
    double slope_sum = 0, above = 0, below = 0;
    for (std::size_t k = 0; k < bell.size(); ++k) {
        const double x = double(k);
        first_derivative.push_back(x * bell[k]);
        second_derivative.push_back((x * x / (deviation * deviation) - 1) * bell[k]);
        const double both_sides = (k == 0 ? 1 : 2) * second_derivative[k];
        slope_sum += first_derivative[k];
        (both_sides < 0 ? below : above) += std::abs(both_sides);
    }
    for (const double w : first_derivative) slope.push_back(float(w / slope_sum));
    for (const double w : second_derivative) bend.push_back(float(w / (w < 0 ? below : above)));
}

int Filters::radius() const {
    std::size_t longest = 1;
    for (const auto* weights : {&lightness, &red_green, &blue_yellow_1, &blue_yellow_2, &smooth, &slope, &bend})
        longest = std::max(longest, weights->size());
    return int(longest) - 1;
}

}  // namespace raster::flip
