// diff_flip_test.cpp: FLIP against a second implementation, straight from the paper: direct 2D filters in double.
#include <raster/image/flip.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <optional>
#include <utility>

#if !defined(RASTER_NO_THREADS)
#include <tbb/task_arena.h>
#endif

#include <gtest/gtest.h>

#include <raster/image/diff.h>
#include <raster/image/diff_picture.h>
#include <raster/testing/matchers.h>

#include "random.h"

namespace {

using raster::AnyImage;
using raster::DifferingCells;
using raster::flip_map;
using raster::Image16;
using raster::Image8;
using raster::ImageF;
using raster::mean_of;
using raster::testing::Random;

// ------------------------------------------------------------- the paper, with the C library's mathematics

using Color = std::array<double, 3>;
using Plane = std::vector<double>;

constexpr double pi = 3.14159265358979324;
constexpr Color white = {0.950428545, 1.000000000, 1.088900371};

Color xyz_from_linear(const Color& c) {
    return {(10135552.0 * c[0] + 8788810.0 * c[1] + 4435075.0 * c[2]) / 24577794.0,
            (2613072.0 * c[0] + 8788810.0 * c[1] + 887015.0 * c[2]) / 12288897.0,
            (1425312.0 * c[0] + 8788810.0 * c[1] + 70074185.0 * c[2]) / 73733382.0};
}

Color linear_from_xyz(const Color& xyz) {
    // Cramer's rule.
    const Color r = xyz_from_linear({1, 0, 0}), g = xyz_from_linear({0, 1, 0}), b = xyz_from_linear({0, 0, 1});
    const auto determinant = [](const Color& u, const Color& v, const Color& w) {
        return u[0] * (v[1] * w[2] - v[2] * w[1]) - u[1] * (v[0] * w[2] - v[2] * w[0]) +
               u[2] * (v[0] * w[1] - v[1] * w[0]);
    };
    const double all = determinant(r, g, b);
    return {determinant(xyz, g, b) / all, determinant(r, xyz, b) / all, determinant(r, g, xyz) / all};
}

Color ycxcz_from_linear(const Color& c) {
    Color t = xyz_from_linear(c);
    for (int i = 0; i < 3; ++i) t[i] /= white[i];
    return {116 * t[1] - 16, 500 * (t[0] - t[1]), 200 * (t[1] - t[2])};
}

Color linear_from_ycxcz(const Color& c) {
    const double y = (c[0] + 16) / 116, x = y + c[1] / 500, z = y - c[2] / 200;
    return linear_from_xyz({x * white[0], y * white[1], z * white[2]});
}

Color hunt_lab_from_linear(const Color& c) {
    Color t = xyz_from_linear(c);
    for (int i = 0; i < 3; ++i) {
        t[i] /= white[i];
        const double delta = 6.0 / 29;
        t[i] = t[i] > delta * delta * delta ? std::cbrt(t[i]) : t[i] / (3 * delta * delta) + 4.0 / 29;
    }
    const double l = 116 * t[1] - 16;
    return {l, 0.01 * l * 500 * (t[0] - t[1]), 0.01 * l * 200 * (t[1] - t[2])};
}

double hyab(const Color& p, const Color& q) { return std::abs(p[0] - q[0]) + std::hypot(p[1] - q[1], p[2] - q[2]); }

struct Planes {
    int width, height;
    std::array<Plane, 3> plane;
};

struct Kernel {
    int radius;
    Plane weights;
    double at(int x, int y) const { return weights[std::size_t((y + radius) * (2 * radius + 1) + x + radius)]; }
};

Kernel make_kernel(int radius, const std::function<double(int, int)>& weight) {
    Kernel kernel{radius, {}};
    for (int y = -radius; y <= radius; ++y)
        for (int x = -radius; x <= radius; ++x) kernel.weights.push_back(weight(x, y));
    return kernel;
}

Kernel sensitivity(double ppd, double a1, double b1, double a2, double b2) {
    const int radius = int(std::ceil(3 * std::sqrt(0.04 / (2 * pi * pi)) * ppd));
    Kernel kernel = make_kernel(radius, [&](int x, int y) {
        const double r2 = (x * x + y * y) / (ppd * ppd);
        return a1 * std::sqrt(pi / b1) * std::exp(-pi * pi * r2 / b1) +
               a2 * std::sqrt(pi / b2) * std::exp(-pi * pi * r2 / b2);
    });
    double sum = 0;
    for (const double w : kernel.weights) sum += w;
    for (double& w : kernel.weights) w /= sum;
    return kernel;
}

Kernel feature(double ppd, bool point, bool along_y) {
    const double deviation = 0.5 * 0.082 * ppd;
    Kernel kernel = make_kernel(int(std::ceil(3 * deviation)), [&](int x, int y) {
        const double t = along_y ? y : x, g = std::exp(-(x * x + y * y) / (2 * deviation * deviation));
        return point ? (t * t / (deviation * deviation) - 1) * g : -t * g;
    });
    double above = 0, below = 0;
    for (const double w : kernel.weights) (w > 0 ? above : below) += std::abs(w);
    for (double& w : kernel.weights) w /= w > 0 ? above : below;
    return kernel;
}

Plane filter(const Plane& in, int width, int height, const Kernel& kernel) {
    Plane out;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            double sum = 0;
            for (int v = -kernel.radius; v <= kernel.radius; ++v)
                for (int u = -kernel.radius; u <= kernel.radius; ++u) {
                    const int column = std::clamp(x + u, 0, width - 1), row = std::clamp(y + v, 0, height - 1);
                    sum += kernel.at(u, v) * in[std::size_t(row * width + column)];
                }
            out.push_back(sum);
        }
    return out;
}

/// `image` has three channels of linear light.
Planes ycxcz(const Planes& image) {
    Planes out = image;
    for (std::size_t i = 0; i < image.plane[0].size(); ++i) {
        const Color c = ycxcz_from_linear({image.plane[0][i], image.plane[1][i], image.plane[2][i]});
        for (std::size_t k = 0; k < 3; ++k) out.plane[k][i] = c[k];
    }
    return out;
}

struct Seen {
    std::vector<Color> colors;
    Plane edges, points;
};

Seen see(const Planes& image, double ppd) {
    const Planes opponent = ycxcz(image);
    const int w = image.width, h = image.height;
    const Plane y = filter(opponent.plane[0], w, h, sensitivity(ppd, 1, 0.0047, 0, 1e-5));
    const Plane cx = filter(opponent.plane[1], w, h, sensitivity(ppd, 1, 0.0053, 0, 1e-5));
    const Plane cz = filter(opponent.plane[2], w, h, sensitivity(ppd, 34.1, 0.04, 13.5, 0.025));
    Plane lightness = opponent.plane[0];
    for (double& v : lightness) v = (v + 16) / 116;
    std::array<Plane, 4> features;
    for (int i = 0; i < 4; ++i) features[std::size_t(i)] = filter(lightness, w, h, feature(ppd, i >= 2, i % 2 == 1));
    Seen seen;
    for (std::size_t i = 0; i < y.size(); ++i) {
        Color linear = linear_from_ycxcz({y[i], cx[i], cz[i]});
        for (double& v : linear) v = std::clamp(v, 0.0, 1.0);
        seen.colors.push_back(hunt_lab_from_linear(linear));
        seen.edges.push_back(std::hypot(features[0][i], features[1][i]));
        seen.points.push_back(std::hypot(features[2][i], features[3][i]));
    }
    return seen;
}

Plane flip_by_the_paper(const Planes& reference, const Planes& test, double ppd) {
    const Seen r = see(reference, ppd), t = see(test, ppd);
    const double largest = std::pow(hyab(hunt_lab_from_linear({0, 1, 0}), hunt_lab_from_linear({0, 0, 1})), 0.7);
    Plane errors;
    for (std::size_t i = 0; i < r.colors.size(); ++i) {
        const double power = std::pow(hyab(r.colors[i], t.colors[i]), 0.7), knee = 0.4 * largest;
        const double color = power < knee ? 0.95 / knee * power : 0.95 + (power - knee) / (largest - knee) * 0.05;
        const double feature = std::max(std::abs(r.edges[i] - t.edges[i]), std::abs(r.points[i] - t.points[i]));
        errors.push_back(std::pow(color, 1 - std::sqrt(feature / std::sqrt(2.0))));
    }
    return errors;
}

double linear_from_srgb(double v) { return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4); }

Planes linear(const Image8& image) {
    Planes planes{image.width, image.height, {}};
    for (int i = 0; i < image.width * image.height; ++i)
        for (std::size_t k = 0; k < 3; ++k)
            planes.plane[k].push_back(linear_from_srgb(image.samples[std::size_t(3 * i) + k] / 255.0));
    return planes;
}

// ------------------------------------------------------------------------------------------------ pictures

Image8 constant(int width, int height, std::array<int, 3> color) {
    Image8 image(width, height, 3);
    for (std::size_t i = 0; i < image.samples.size(); ++i) image.samples[i] = std::uint8_t(color[i % 3]);
    return image;
}

/// Rectangles and single pixels of any colour.
Image8 scribble(Random& random, Image8 image, int count) {
    for (int n = 0; n < count; ++n) {
        const int x0 = random.integer(0, image.width - 1), y0 = random.integer(0, image.height - 1);
        const int x1 = std::min(x0 + random.integer(1, 12), image.width),
                  y1 = std::min(y0 + random.integer(1, 9), image.height);
        const std::array<int, 3> color = {random.integer(0, 255), random.integer(0, 255), random.integer(0, 255)};
        for (int y = y0; y < y1; ++y)
            for (int x = x0; x < x1; ++x)
                for (int c = 0; c < 3; ++c) image.pixel(x, y)[c] = std::uint8_t(color[std::size_t(c)]);
    }
    return image;
}

DifferingCells cells_of(const AnyImage& a, const AnyImage& b) {
    return std::visit(
        [&]<class T>(const raster::Image<T>& held) {
            return DifferingCells(raster::plain_metrics(held, std::get<raster::Image<T>>(b), 1).deltas);
        },
        a);
}

ImageF map_of(const AnyImage& a, const AnyImage& b, float ppd = raster::default_pixels_per_degree) {
    return flip_map(a, b, cells_of(a, b), ppd);
}

void expect_as_in_the_paper(const Image8& a, const Image8& b, float ppd) {
    const ImageF map = map_of(a, b, ppd);
    const Plane expected = flip_by_the_paper(linear(a), linear(b), double(ppd));
    double mean = 0, worst = 0;
    for (std::size_t i = 0; i < expected.size(); ++i) {
        mean += expected[i] / double(expected.size());
        worst = std::max(worst, std::abs(expected[i] - double(map.samples[i])));
    }
    EXPECT_NEAR(mean_of(map), mean, 1e-5);
    EXPECT_LT(worst, 2e-4);
}

// -------------------------------------------------------------------------------------------------- the tests

TEST(Flip, IsWhatThePaperSaysAtEveryPixel) {
    Random random(20);
    for (const auto& [width, height] : {std::pair(40, 30), {70, 5}, {1, 1}, {3, 50}, {33, 33}}) {
        const Image8 a = scribble(random, constant(width, height, {90, 120, 200}), 12);
        expect_as_in_the_paper(a, scribble(random, a, 4), raster::default_pixels_per_degree);
    }
}

TEST(Flip, IsWhatThePaperSaysAtOtherDistances) {
    Random random(21);
    const Image8 a = scribble(random, constant(30, 24, {10, 20, 30}), 9), b = scribble(random, a, 3);
    for (const float ppd : {8.0f, 20.0f, 40.5f, 110.0f}) expect_as_in_the_paper(a, b, ppd);
}

TEST(Flip, TilesMeetWithoutASeam) {
    Random random(22);
    // Tiles are 256 x 128; the differences lie where four of them meet. What the last rows and columns see ends 10
    // pixels before them, so that a part of the picture is enough for the slow way.
    const Image8 a = scribble(random, constant(275, 140, {128, 128, 128}), 200);
    Image8 b = a;
    for (int y = 124; y < 132; ++y)
        for (int x = 250; x < 262; ++x) b.pixel(x, y)[1] ^= 0x70;
    constexpr int left = 230, top = 105, margin = 10;
    const auto corner = [](const Image8& image) {
        Image8 part(image.width - left, image.height - top, 3);
        for (int y = 0; y < part.height; ++y) std::copy_n(image.pixel(left, top + y), 3 * part.width, part.pixel(0, y));
        return part;
    };
    const ImageF map = map_of(a, b);
    const Plane expected =
        flip_by_the_paper(linear(corner(a)), linear(corner(b)), double(raster::default_pixels_per_degree));
    for (int y = margin; y < 140 - top; ++y)
        for (int x = margin; x < 275 - left; ++x)
            EXPECT_NEAR(*map.pixel(left + x, top + y), expected[std::size_t(y * (275 - left) + x)], 2e-4);
}

TEST(Flip, GreenAgainstBlueIsOneByDefinition) {
    for (const float error : map_of(constant(9, 9, {0, 255, 0}), constant(9, 9, {0, 0, 255})).samples)
        EXPECT_NEAR(error, 1.0f, 1e-5f);
}

TEST(Flip, BlackAgainstWhiteIsLightnessAlone) {
    // Distance 100, past the knee; the largest is the distance from green to blue.
    const double largest = std::pow(hyab(hunt_lab_from_linear({0, 1, 0}), hunt_lab_from_linear({0, 0, 1})), 0.7);
    const double expected = 0.95 + (std::pow(100.0, 0.7) - 0.4 * largest) / (0.6 * largest) * 0.05;
    for (const float error : map_of(constant(5, 7, {0, 0, 0}), constant(5, 7, {255, 255, 255})).samples)
        EXPECT_NEAR(error, expected, 1e-5);
}

TEST(Flip, EqualPicturesHaveNoError) {
    Random random(23);
    const Image8 a = scribble(random, constant(64, 48, {1, 2, 3}), 30);
    for (const float error : map_of(a, a).samples) EXPECT_EQ(error, 0.0f);
}

TEST(Flip, FarFromADifferenceThereIsNone) {
    const Image8 a = constant(600, 40, {100, 100, 100});
    Image8 b = a;
    b.pixel(3, 20)[0] = 255;
    const ImageF map = map_of(a, b);
    EXPECT_GT(*map.pixel(3, 20), 0.05f);
    for (int x = 3 + 11; x < 600; ++x) EXPECT_EQ(*map.pixel(x, 20), 0.0f) << x;
}

TEST(Flip, ExchangingThePicturesChangesNothing) {
    Random random(24);
    const Image8 a = scribble(random, constant(50, 40, {60, 60, 60}), 10), b = scribble(random, a, 5);
    EXPECT_EQ(map_of(a, b), map_of(b, a));
}

TEST(Flip, SixteenBitsThatHoldEightGiveTheSame) {
    Random random(25);
    const Image8 a = scribble(random, constant(31, 17, {60, 60, 60}), 10), b = scribble(random, a, 5);
    const auto widen = [](const Image8& image) {
        Image16 wide(image.width, image.height, 3);
        for (std::size_t i = 0; i < image.samples.size(); ++i) wide.samples[i] = std::uint16_t(image.samples[i] * 257);
        return wide;
    };
    const ImageF eight = map_of(a, b), sixteen = map_of(widen(a), widen(b));
    for (std::size_t i = 0; i < eight.samples.size(); ++i) EXPECT_NEAR(eight.samples[i], sixteen.samples[i], 1e-5f);
}

TEST(Flip, FloatsAreLinearLight) {
    Random random(26);
    const Image8 a = scribble(random, constant(31, 17, {60, 60, 60}), 10), b = scribble(random, a, 5);
    const auto to_float = [](const Image8& image) {
        ImageF light(image.width, image.height, 3);
        for (std::size_t i = 0; i < image.samples.size(); ++i)
            light.samples[i] = float(linear_from_srgb(image.samples[i] / 255.0));
        return light;
    };
    const ImageF eight = map_of(a, b), floats = map_of(to_float(a), to_float(b));
    for (std::size_t i = 0; i < eight.samples.size(); ++i) EXPECT_NEAR(eight.samples[i], floats.samples[i], 1e-4f);
}

TEST(FlipMean, HasTheBitsOfTheMapsMeanAndItsSteps) {
    Random random(28);
    for (const auto& [width, height] : {std::pair(700, 150), {3, 5}, {193, 70}, {1, 1}, {384, 9}}) {
        const Image8 a = scribble(random, constant(width, height, {60, 60, 60}), 40), b = scribble(random, a, 25);
        if (a == b) continue;
        const ImageF map = map_of(a, b);
        Image8 steps;
        const std::optional<double> mean =
            raster::flip_mean(a, b, cells_of(a, b), raster::default_pixels_per_degree, &steps);
        ASSERT_TRUE(mean);
        EXPECT_EQ(*mean, mean_of(map)) << width;
        ASSERT_EQ(steps.width, width);
        ASSERT_EQ(steps.height, height);
        for (std::size_t i = 0; i < map.samples.size(); ++i) {
            const float up = float(steps.samples[i]) - 31 * map.samples[i];
            EXPECT_TRUE(up > -1e-4f && up < 1.0f) << map.samples[i];
            EXPECT_EQ(steps.samples[i] == 0, map.samples[i] == 0);
        }
    }
}

TEST(FlipMean, GivesUpWhereTheOrderOfTheSumMatters) {
    // Errors of 3e-7 in rows so wide that a part of their sum may need more than 53 bits.
    const ImageF a(4000, 12, 3, 0.001f);
    ImageF b = a;
    for (std::size_t i = 2; i < b.samples.size(); i += 3) b.samples[i] += 0x1p-29f;
    const ImageF map = map_of(a, b);
    ASSERT_LT(map.samples[0], 0x1p-21f);
    ASSERT_GT(map.samples[0], 0.0f);
    EXPECT_FALSE(raster::flip_mean(a, b, cells_of(a, b), raster::default_pixels_per_degree));
}

TEST(FlipMean, LeavesTransparentPicturesToTheMap) {
    Image8 a(20, 20, 2, 100), b(20, 20, 2, 120);
    EXPECT_FALSE(raster::flip_mean(a, b, cells_of(a, b), raster::default_pixels_per_degree));
    for (std::size_t i = 1; i < a.samples.size(); i += 2) a.samples[i] = b.samples[i] = 255;
    EXPECT_EQ(raster::flip_mean(a, b, cells_of(a, b), raster::default_pixels_per_degree), mean_of(map_of(a, b)));
}

TEST(FlipMean, OfADiffIsTheSameHoweverMuchIsKept) {
    Random random(29);
    const Image8 a = scribble(random, constant(300, 90, {60, 60, 60}), 40), b = scribble(random, a, 25);
    for (const bool ignores : {false, true}) {
        raster::DiffOptions options;
        if (ignores) options.ignored = {{0, 0, 150, 90}};
        const auto all = raster::diff_images(a, b, options);
        ASSERT_TRUE(all);
        raster::Diff shown = *all;
        const raster::IndexedImage picture = raster::flip_picture(std::move(shown));
        for (const auto detail : {raster::FlipDetail::none, raster::FlipDetail::steps}) {
            options.flip_detail = detail;
            auto some = raster::diff_images(a, b, options);
            ASSERT_TRUE(some);
            EXPECT_EQ(some->figures->flip, all->figures->flip);
            EXPECT_EQ(some->flip_map.empty(), !ignores);
            EXPECT_EQ(some->flip_steps.empty(), ignores || detail == raster::FlipDetail::none);
            if (detail != raster::FlipDetail::steps) continue;
            const raster::IndexedImage same = raster::flip_picture(std::move(*some));
            EXPECT_EQ(same.indices, picture.indices);
            EXPECT_EQ(same.palette, picture.palette);
        }
    }
}

TEST(Flip, ADifferenceInAlphaAloneIsSeenWhateverTheColour) {
    for (const int grey : {0, 128, 255}) {
        Image8 a(20, 20, 2, std::uint8_t(grey)), b = a;
        for (std::size_t i = 1; i < a.samples.size(); i += 2) a.samples[i] = 255, b.samples[i] = 100;
        EXPECT_GT(mean_of(map_of(a, b)), 0.1) << grey;
    }
}

#if !defined(RASTER_NO_THREADS)
TEST(Flip, IsTheSameForEveryNumberOfThreads) {
    Random random(27);
    const Image8 a = scribble(random, constant(700, 500, {60, 60, 60}), 300), b = scribble(random, a, 50);
    const ImageF all = map_of(a, b);
    for (const int threads : {1, 2, 3}) {
        tbb::task_arena arena(threads);
        EXPECT_EQ(arena.execute([&] { return map_of(a, b); }), all) << threads;
    }
}
#endif

}  // namespace
