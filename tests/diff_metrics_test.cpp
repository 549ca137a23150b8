// diff_metrics_test.cpp: the plain figures in closed form and against sums in another order; SSIM against its formula.
#include <raster/image/metrics.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "random.h"

namespace {

using raster::AnyImage;
using raster::DifferingCells;
using raster::Image;
using raster::Image16;
using raster::Image8;
using raster::ImageF;
using raster::mean_ssim;
using raster::plain_metrics;
using raster::PlainMetrics;
using raster::testing::Random;

constexpr float infinity = std::numeric_limits<float>::infinity();

template <class T>
PlainMetrics metrics_of(const Image<T>& a, const Image<T>& b) {
    return plain_metrics(a, b, std::int64_t(a.width) * a.height);
}

Image8 noise(Random& random, int width, int height, int channels) {
    Image8 image(width, height, channels);
    for (auto& sample : image.samples) sample = std::uint8_t(random.integer(0, 255));
    return image;
}

TEST(PlainMetrics, OneSampleOffByThreeOfTwelve) {
    Image8 a(2, 2, 3, 100), b = a;
    b.pixel(1, 0)[2] = 103;
    const PlainMetrics m = metrics_of(a, b);
    EXPECT_EQ(m.differing, 1);
    EXPECT_EQ(m.max, 3);
    EXPECT_EQ(m.max_x, 1);
    EXPECT_EQ(m.max_y, 0);
    EXPECT_DOUBLE_EQ(m.mean, 3.0 / 12);
    EXPECT_DOUBLE_EQ(m.rms, std::sqrt(9.0 / 12));
    EXPECT_NEAR(m.psnr, 10 * std::log10(255.0 * 255 * 12 / 9), 1e-4);
}

TEST(PlainMetrics, EqualPicturesDifferInNothing) {
    const Image16 a(5, 4, 2, 7);
    const PlainMetrics m = metrics_of(a, a);
    EXPECT_EQ(m.differing, 0);
    EXPECT_EQ(m.max + m.mean + m.rms, 0);
    EXPECT_EQ(m.psnr, std::numeric_limits<double>::infinity());
    EXPECT_TRUE(m.deltas.empty());
}

TEST(PlainMetrics, AreWhatSumsInReadingOrderGive) {
    Random random(1);
    for (int channels = 1; channels <= 4; ++channels) {
        const Image8 a = noise(random, 37, 23, channels);
        Image8 b = a;
        for (int i = 0; i < 200; ++i)
            b.samples[std::size_t(random.integer(0, int(b.samples.size()) - 1))] ^=
                std::uint8_t(random.integer(0, 255));
        const PlainMetrics m = metrics_of(a, b);
        double sum = 0, squares = 0, largest = 0;
        int differing = 0;
        for (int y = 0; y < a.height; ++y)
            for (int x = 0; x < a.width; ++x) {
                double pixel = 0;
                for (int c = 0; c < channels; ++c) {
                    const double d = std::abs(double(a.pixel(x, y)[c]) - double(b.pixel(x, y)[c]));
                    sum += d, squares += d * d, pixel = std::max(pixel, d);
                }
                differing += pixel > 0;
                largest = std::max(largest, pixel);
                EXPECT_EQ(*m.deltas.pixel(x, y), float(pixel));
            }
        EXPECT_EQ(m.differing, differing);
        EXPECT_EQ(m.max, largest);
        EXPECT_DOUBLE_EQ(m.mean, sum / double(a.samples.size()));
        EXPECT_DOUBLE_EQ(m.rms, std::sqrt(squares / double(a.samples.size())));
    }
}

TEST(PlainMetrics, TheLargestSixteenBitDifferenceDoesNotOverflow) {
    const PlainMetrics m = metrics_of(Image16(300, 300, 4, 0), Image16(300, 300, 4, 65535));
    EXPECT_EQ(m.max, 65535);
    EXPECT_EQ(m.mean, 65535);
    EXPECT_EQ(m.rms, 65535);
    EXPECT_NEAR(m.psnr, 0, 1e-5);
}

TEST(PlainMetrics, InfinityEqualsItselfAndMinusZeroIsZero) {
    ImageF a(2, 1, 1), b(2, 1, 1);
    a.samples = {infinity, 0.0f}, b.samples = {infinity, -0.0f};
    EXPECT_EQ(metrics_of(a, b).differing, 0);
    b.samples[0] = -infinity;
    const PlainMetrics m = metrics_of(a, b);
    EXPECT_EQ(m.differing, 1);
    EXPECT_EQ(m.max, std::numeric_limits<double>::infinity());
}

TEST(PlainMetrics, TheSmallestFloatDifferenceIsOne) {
    ImageF a(1, 1, 1), b(1, 1, 1);
    b.samples[0] = std::numeric_limits<float>::denorm_min();
    EXPECT_EQ(metrics_of(a, b).differing, 1);
}

TEST(DifferingCells, AreFoundWherePixelsDiffer) {
    ImageF deltas(100, 70, 1);
    *deltas.pixel(99, 69) = 1;
    const DifferingCells cells(deltas);
    EXPECT_FALSE(cells.any_in(0, 0, 64, 64));
    EXPECT_TRUE(cells.any_in(98, 68, 200, 200));
    EXPECT_TRUE(cells.any_in(-50, -50, 101, 71));
    EXPECT_FALSE(cells.any_in(-50, -50, 96, 64));
}

TEST(MeanOf, CountsOnlyWhatIsCompared) {
    ImageF map(2, 2, 1);
    map.samples = {1, 2, 3, 6};
    EXPECT_EQ(raster::mean_of(map), 3);
    Image8 compared(2, 2, 1);
    compared.samples = {0, 1, 0, 1};
    EXPECT_EQ(raster::mean_of(map, compared), 4);
}

// ---------------------------------------------------------------------------------------------------- SSIM

double luma(const Image8& image, int x, int y) {
    const std::uint8_t* p = image.pixel(std::clamp(x, 0, image.width - 1), std::clamp(y, 0, image.height - 1));
    return (0.299 * p[0] + 0.587 * p[1] + 0.114 * p[2]);
}

/// Straight from the paper: each window by itself, values 0 to 255.
double ssim_by_the_paper(const Image8& a, const Image8& b) {
    double weights[11][11], total = 0;
    for (int v = 0; v < 11; ++v)
        for (int u = 0; u < 11; ++u)
            total += weights[v][u] = std::exp(-((u - 5) * (u - 5) + (v - 5) * (v - 5)) / (2 * 1.5 * 1.5));
    const int x0 = a.width < 11 ? 0 : 5, x1 = a.width < 11 ? a.width : a.width - 5;
    const int y0 = a.height < 11 ? 0 : 5, y1 = a.height < 11 ? a.height : a.height - 5;
    double sum = 0;
    for (int y = y0; y < y1; ++y)
        for (int x = x0; x < x1; ++x) {
            double ma = 0, mb = 0, aa = 0, bb = 0, ab = 0;
            for (int v = 0; v < 11; ++v)
                for (int u = 0; u < 11; ++u) {
                    const double w = weights[v][u] / total, p = luma(a, x + u - 5, y + v - 5),
                                 q = luma(b, x + u - 5, y + v - 5);
                    ma += w * p, mb += w * q, aa += w * p * p, bb += w * q * q, ab += w * p * q;
                }
            const double c1 = 0.01 * 255 * 0.01 * 255, c2 = 0.03 * 255 * 0.03 * 255;
            sum += (2 * ma * mb + c1) * (2 * (ab - ma * mb) + c2) /
                   ((ma * ma + mb * mb + c1) * (aa - ma * ma + bb - mb * mb + c2));
        }
    return sum / ((x1 - x0) * (y1 - y0));
}

double ssim_of(const Image8& a, const Image8& b) {
    return mean_ssim(a, b, DifferingCells(metrics_of(a, b).deltas));
}

TEST(PlainMetrics, MemoryThatFitsIsUsedAndOtherIsNot) {
    Image8 a(30, 20, 3, 7), b = a;
    b.pixel(4, 5)[1] = 9;
    const ImageF deltas = raster::plain_metrics(a, b, 600).deltas;
    for (const std::size_t size : {0u, 599u, 600u, 601u}) {
        std::vector<float> zeros(size);
        const float* const memory = zeros.data();
        const auto metrics = raster::plain_metrics(a, b, 600, std::move(zeros));
        EXPECT_EQ(metrics.deltas, deltas) << size;
        EXPECT_EQ(metrics.deltas.samples.data() == memory, size == 600) << size;
    }
}

TEST(Ssim, IsWhatThePaperSays) {
    Random random(2);
    for (const auto& [width, height] : {std::pair(30, 25), {11, 11}, {300, 90}, {7, 40}, {1, 1}}) {
        const Image8 a = noise(random, width, height, 3);
        Image8 b = a;
        for (int i = 0; i < width * height / 4; ++i)
            b.samples[std::size_t(random.integer(0, int(b.samples.size()) - 1))] = std::uint8_t(random.integer(0, 255));
        b.samples[0] = std::uint8_t(a.samples[0] ^ 0x80);
        EXPECT_NEAR(ssim_of(a, b), ssim_by_the_paper(a, b), 2e-5) << width << "x" << height;
    }
}

TEST(Ssim, OfTwoConstantsIsLuminanceAlone) {
    const double p = 100, q = 140, c1 = 0.01 * 255 * 0.01 * 255;
    EXPECT_NEAR(ssim_of(Image8(20, 20, 3, 100), Image8(20, 20, 3, 140)), (2 * p * q + c1) / (p * p + q * q + c1), 1e-5);
}

TEST(Ssim, OfANegativeIsBelowZero) {
    Random random(3);
    const Image8 a = noise(random, 40, 40, 3);
    Image8 b = a;
    for (auto& sample : b.samples) sample = std::uint8_t(255 - sample);
    EXPECT_LT(ssim_of(a, b), -0.5);
}

}  // namespace
