// math_test.cpp: the stated errors of raster/math.h against long double, special values, lanes equal to
// scalars.
#include <raster/lanes_glm.h>
#include <raster/math.h>

#include <cmath>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "random.h"

namespace raster {
namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();
constexpr float nan = std::numeric_limits<float>::quiet_NaN();
constexpr float smallest = std::numeric_limits<float>::min();
constexpr float largest = std::numeric_limits<float>::max();

/// n values from low to high, evenly spaced by value.
std::vector<float> linear(double low, double high, int n) {
    std::vector<float> r;
    for (int i = 0; i <= n; ++i) r.push_back(float(low + (high - low) * i / n));
    return r;
}

/// About n values from low to high (both positive), evenly spaced by representation: as many in each binade.
std::vector<float> by_representation(float low, float high, int n) {
    const std::int64_t a = as_int(low), b = as_int(high);
    std::vector<float> r;
    for (std::int64_t i = 0; i <= n; ++i) r.push_back(as_float(std::int32_t(a + (b - a) * i / n)));
    return r;
}

template <class Ours, class Exact>
double worst_relative(const std::vector<float>& xs, Ours ours, Exact exact) {
    double worst = 0;
    for (float x : xs) {
        const long double t = exact(static_cast<long double>(x));
        const double e = double(t == 0 ? std::fabs(ours(x)) : std::fabs((ours(x) - t) / t));
        if (!(e <= worst)) worst = e;
    }
    return worst;
}

template <class Ours, class Exact>
double worst_absolute(const std::vector<float>& xs, Ours ours, Exact exact) {
    double worst = 0;
    for (float x : xs) {
        const double e = double(std::fabs(ours(x) - exact(static_cast<long double>(x))));
        if (!(e <= worst)) worst = e;
    }
    return worst;
}

TEST(Math, Exp2KeepsItsStatedError) {
    const auto exact = [](long double x) { return exp2l(x); };
    EXPECT_LE(worst_relative(linear(-126, 127.9999, 500000), exp2<float>, exact), 1.2e-7);
    EXPECT_LE(worst_relative(linear(-1, 1, 500000), exp2<float>, exact), 1.2e-7);
}

TEST(Math, Exp2OfWholeNumbersIsExact) {
    for (int i = -126; i <= 127; ++i) EXPECT_EQ(raster::exp2(float(i)), std::ldexp(1.0f, i)) << i;
}

TEST(Math, Exp2UnderflowsToZeroAndOverflowsToInfinity) {
    EXPECT_EQ(raster::exp2(std::nextafter(-126.0f, -127.0f)), 0.0f);
    EXPECT_EQ(raster::exp2(-127.0f), 0.0f);
    EXPECT_EQ(raster::exp2(-1e30f), 0.0f);
    EXPECT_EQ(raster::exp2(-infinity), 0.0f);
    EXPECT_LT(raster::exp2(std::nextafter(128.0f, 0.0f)), infinity);
    EXPECT_EQ(raster::exp2(128.0f), infinity);
    EXPECT_EQ(raster::exp2(1e30f), infinity);
    EXPECT_EQ(raster::exp2(infinity), infinity);
    EXPECT_TRUE(std::isnan(raster::exp2(nan)));
}

TEST(Math, Log2KeepsItsStatedError) {
    const auto exact = [](long double x) { return log2l(x); };
    EXPECT_LE(worst_relative(by_representation(smallest, largest, 1000000), log2<float>, exact), 2.3e-7);
    EXPECT_LE(worst_relative(by_representation(0.5f, 2.0f, 500000), log2<float>, exact), 2.3e-7);
}

TEST(Math, Log2OfPowersOfTwoIsExact) {
    for (int i = -126; i <= 127; ++i) EXPECT_EQ(raster::log2(std::ldexp(1.0f, i)), float(i)) << i;
}

TEST(Math, Log2OutsideItsDomainGivesInfinitiesAndNaN) {
    EXPECT_EQ(raster::log2(0.0f), -infinity);
    EXPECT_EQ(raster::log2(-0.0f), -infinity);
    EXPECT_EQ(raster::log2(std::numeric_limits<float>::denorm_min()), -infinity);
    EXPECT_EQ(raster::log2(infinity), infinity);
    EXPECT_TRUE(std::isnan(raster::log2(-1.0f)));
    EXPECT_TRUE(std::isnan(raster::log2(-infinity)));
    EXPECT_TRUE(std::isnan(raster::log2(nan)));
}

TEST(Math, PowKeepsItsStatedError) {
    testing::Random random(2);
    double worst_of_visible = 0, worst = 0, worst_over_bound = 0;
    for (int i = 0; i < 1000000; ++i) {
        const float x = random.uniform(0.0f, 1.0f);
        const float y = i % 2 ? random.uniform(0.0f, 10000.0f) : raster::exp2(random.uniform(-2.0f, 13.0f));
        const long double t = powl(x, y);
        if (t < 1e-36L) continue;
        const double e = double(std::fabs((raster::pow(x, y) - t) / t));
        if (t > 1 / 512.0L) worst_of_visible = std::fmax(worst_of_visible, e);
        worst = std::fmax(worst, e);
        worst_over_bound = std::fmax(worst_over_bound, e / (1.6e-7 + 1.8e-7 * double(std::fabs(log2l(t)))));
    }
    EXPECT_LE(worst_of_visible, 2e-6);
    EXPECT_LE(worst, 2e-5);
    EXPECT_LE(worst_over_bound, 1.0);
}

TEST(Math, PowOfBasesAboveOneAndNegativeExponentsKeepsTheSameError) {
    testing::Random random(3);
    for (int i = 0; i < 200000; ++i) {
        const float x = random.uniform(0.01f, 100.0f), y = random.uniform(-15.0f, 15.0f);
        const long double t = powl(x, y);
        const double bound = 1.6e-7 + 1.8e-7 * double(std::fabs(log2l(t)));
        ASSERT_LE(double(std::fabs((raster::pow(x, y) - t) / t)), bound) << x << " to the " << y;
    }
}

TEST(Math, PowHasTheValuesLightingRestsOn) {
    EXPECT_EQ(raster::pow(0.0f, 0.0f), 1.0f);
    EXPECT_EQ(raster::pow(nan, 0.0f), 1.0f);
    for (float y : {1e-30f, 0.1f, 1.0f, 32.0f, 10000.0f, 1e30f}) {
        EXPECT_EQ(raster::pow(0.0f, y), 0.0f) << y;
        EXPECT_EQ(raster::pow(1e-40f, y), 0.0f) << y;
        EXPECT_EQ(raster::pow(1.0f, y), 1.0f) << y;
    }
    EXPECT_EQ(raster::pow(0.0f, -1.0f), infinity);
    EXPECT_TRUE(std::isnan(raster::pow(-0.5f, 2.0f)));
    EXPECT_EQ(raster::pow(2.0f, 10.0f), 1024.0f);
    EXPECT_EQ(raster::pow(2.0f, 10), 1024.0f) << "an exponent of another type converts";
}

TEST(Math, PowersOfASharedWholeExponentKeepTheirStatedError) {
    testing::Random random(4);
    for (int exponent = 1; exponent <= 256; ++exponent)
        for (int i = 0; i < 2000; ++i) {
            const float x = random.uniform(0.0f, 1.0f);
            const long double exact = powl(x, exponent);
            if (exact < smallest) continue;
            const float ours = raster::pow_shared(x, float(exponent));
            ASSERT_LE(double(std::fabs((ours - exact) / exact)), exponent * 6e-8) << x << " to the " << exponent;
        }
}

TEST(Math, PowersOfASharedExponentAreMultipliedOutWhereItIsWholeAndElsePows) {
    EXPECT_EQ(raster::pow_shared(3.0f, 5.0f), 243.0f);
    EXPECT_EQ(raster::pow_shared(-2.0f, 3.0f), -8.0f) << "multiplied out, a negative base has powers too";
    EXPECT_EQ(raster::pow_shared(0.7f, 1.0f), 0.7f);
    EXPECT_EQ(raster::pow_shared(2.0f, 100.0f), std::ldexp(1.0f, 100));
    for (const float exponent : {0.0f, 0.5f, 2.4f, 96.078431f, 257.0f, 1e30f, -1.0f})
        for (const float x : {0.0f, 0.3f, 1.0f, 1.5f})
            EXPECT_EQ(as_int(raster::pow_shared(x, exponent)), as_int(raster::pow(x, exponent)))
                << x << " " << exponent;
    EXPECT_TRUE(std::isnan(raster::pow_shared(0.5f, nan)));
}

TEST(Math, PowOfAUnitBaseIsNeverNaNNeverAboveOneAndNeverFalls) {
    for (float y : {0.5f, 1.0f, 2.0f, 5.0f, 32.0f, 50.0f, 200.0f, 1000.0f, 10000.0f}) {
        float previous = 0;
        for (std::int32_t bits = 0; bits <= as_int(1.0f); bits += 1009) {
            const float v = raster::pow(as_float(bits), y);
            ASSERT_TRUE(v >= previous && v <= 1.0f) << as_float(bits) << " to the " << y << " is " << v;
            previous = v;
        }
    }
}

TEST(Math, ExpKeepsItsStatedError) {
    for (float x : linear(-87, 88, 300000)) {
        const long double t = expl(x);
        ASSERT_LE(double(std::fabs((raster::exp(x) - t) / t)), (2 + std::fabs(x)) * 8e-8) << x;
    }
    EXPECT_EQ(raster::exp(-1000.0f), 0.0f);
    EXPECT_EQ(raster::exp(0.0f), 1.0f);
}

TEST(Math, SinAndCosKeepTheirStatedError) {
    for (const auto& xs : {linear(-4, 4, 300000), linear(-8192, 8192, 600000)}) {
        EXPECT_LE(worst_absolute(xs, sin<float>, [](long double x) { return sinl(x); }), 8e-8);
        EXPECT_LE(worst_absolute(xs, cos<float>, [](long double x) { return cosl(x); }), 8e-8);
    }
}

TEST(Math, SinAndCosOfZeroAreExactAndOfInfinityNaN) {
    EXPECT_EQ(raster::sin(0.0f), 0.0f);
    EXPECT_EQ(raster::cos(0.0f), 1.0f);
    for (float x : {infinity, -infinity, nan}) {
        EXPECT_TRUE(std::isnan(raster::sin(x)));
        EXPECT_TRUE(std::isnan(raster::cos(x)));
        EXPECT_TRUE(std::isnan(raster::tan(x)));
    }
    EXPECT_EQ(raster::sin(1e9f), raster::sin(8192.0f)) << "clamped, as documented";
}

TEST(Math, TanKeepsItsStatedError) {
    const long double pi = acosl(-1.0L);
    double worst = 0;
    for (float x : linear(-8192, 8192, 500000)) {
        const long double d = atanl(raster::tan(x)) - x;
        worst = std::fmax(worst, double(std::fabs(d - pi * roundl(d / pi))));
    }
    EXPECT_LE(worst, 1.2e-7);
    const auto exact = [](long double x) { return tanl(x); };
    EXPECT_LE(worst_relative(linear(-1.5, 1.5, 300000), tan<float>, exact), 2.2e-7);
}

TEST(Math, Atan2AndAcosKeepTheirStatedError) {
    testing::Random random(4);
    for (int i = 0; i < 300000; ++i) {
        const float scale = raster::exp2(random.uniform(-30.0f, 30.0f));
        const float x = random.uniform(-1.0f, 1.0f) * scale, y = random.uniform(-1.0f, 1.0f);
        ASSERT_NEAR(raster::atan2(y, x), double(atan2l(y, x)), 3e-7) << y << " " << x;
    }
    const auto exact = [](long double x) { return acosl(x); };
    EXPECT_LE(worst_absolute(linear(-1, 1, 500000), acos<float>, exact), 3.1e-7);
    EXPECT_EQ(raster::atan2(0.0f, 0.0f), 0.0f);
    EXPECT_EQ(raster::acos(1.0f), 0.0f);
    EXPECT_EQ(raster::acos(1.5f), 0.0f);
    EXPECT_FLOAT_EQ(raster::acos(-2.0f), 3.14159265f);
}

TEST(Math, DegreesAreExactAtRightAnglesAndCloseElsewhere) {
    for (int k = -8; k <= 8; ++k) {
        const auto [s, c] = sin_cos_degrees(90.0 * k);
        const int sines[] = {0, 1, 0, -1}, cosines[] = {1, 0, -1, 0};
        EXPECT_EQ(s, sines[k & 3]) << 90 * k;
        EXPECT_EQ(c, cosines[k & 3]) << 90 * k;
    }
    const long double radians = acosl(-1.0L) / 180;
    for (int i = -200000; i <= 200000; ++i) {
        const double d = i * 5.0 + i * 1e-5;
        const auto [s, c] = sin_cos_degrees(d);
        const long double exact = remainderl(d, 360) * radians;
        ASSERT_LE(double(std::fabs(s - sinl(exact))), 2e-16) << d;
        ASSERT_LE(double(std::fabs(c - cosl(exact))), 2e-16) << d;
    }
    EXPECT_NEAR(tan_degrees(45), 1.0, 3e-16);
    EXPECT_NEAR(tan_degrees(22.5), double(tanl(22.5L * radians)), 1e-16);
}

// ----------------------------------------------------------------------------------------- lanes and scalars

/// Ordinary, huge, tiny, special and random bit patterns: dead lanes hold anything.
std::vector<float> anything() {
    std::vector<float> r = {0.0f,     -0.0f,   1.0f,     -1.0f,  infinity, -infinity, nan, smallest,
                            -smallest, largest, -largest, 1e-40f, -1e-40f,  0.5f,      2e9f, -2e9f};
    testing::Random random(5);
    for (int i = 0; i < 4000; ++i) r.push_back(as_float(std::int32_t(random.bits())));
    for (int i = 0; i < 4000; ++i) r.push_back(random.uniform(-130.0f, 130.0f));
    for (int i = 0; i < 4000; ++i) r.push_back(random.uniform(0.0f, 1.0f));
    while (r.size() % 8) r.push_back(0.25f);
    return r;
}

template <int N, class Function>
void expect_lanes_equal_scalar(const char* name, Function function) {
    const std::vector<float> xs = anything(), ys(xs.rbegin(), xs.rend());
    for (std::size_t i = 0; i < xs.size(); i += N) {
        float out[N];
        store(out, function(load<FloatPack<N>>(&xs[i]), load<FloatPack<N>>(&ys[i])));
        for (int k = 0; k < N; ++k) {
            const float scalar = function(xs[i + k], ys[i + k]);
            // The bits of a NaN are the processor's; that it is one is ours.
            const bool same = as_int(scalar) == as_int(out[k]) || (std::isnan(scalar) && std::isnan(out[k]));
            ASSERT_TRUE(same) << name << "(" << xs[i + k] << ", " << ys[i + k] << ") = " << scalar << " but "
                              << out[k] << " in " << N << " lanes";
        }
    }
}

template <int N>
void expect_all_lanes_equal_scalar() {
    expect_lanes_equal_scalar<N>("exp2", [](auto x, auto) { return raster::exp2(x); });
    expect_lanes_equal_scalar<N>("log2", [](auto x, auto) { return raster::log2(x); });
    expect_lanes_equal_scalar<N>("pow", [](auto x, auto y) { return raster::pow(x, y); });
    expect_lanes_equal_scalar<N>("pow_shared 2.4", [](auto x, auto) { return raster::pow_shared(x, 2.4f); });
    expect_lanes_equal_scalar<N>("pow_shared 37", [](auto x, auto) { return raster::pow_shared(x, 37.0f); });
    expect_lanes_equal_scalar<N>("exp", [](auto x, auto) { return raster::exp(x); });
    expect_lanes_equal_scalar<N>("sin", [](auto x, auto) { return raster::sin(x); });
    expect_lanes_equal_scalar<N>("cos", [](auto x, auto) { return raster::cos(x); });
    expect_lanes_equal_scalar<N>("tan", [](auto x, auto) { return raster::tan(x); });
    expect_lanes_equal_scalar<N>("acos", [](auto x, auto) { return raster::acos(x); });
    expect_lanes_equal_scalar<N>("atan2", [](auto x, auto y) { return raster::atan2(x, y); });
}

TEST(Math, FourLanesGiveTheScalarsBits) { expect_all_lanes_equal_scalar<4>(); }
TEST(Math, EightLanesGiveTheScalarsBits) { expect_all_lanes_equal_scalar<8>(); }

TEST(Math, TheBitsAreTheSameOnEveryMachine) {
    std::uint64_t hash = 14695981039346656037u;  // FNV-1a
    const auto add = [&](float x) {
        if (std::isnan(x)) x = nan;
        hash = (hash ^ std::uint32_t(as_int(x))) * 1099511628211u;
    };
    const std::vector<float> xs = anything();
    for (std::size_t i = 0; i < xs.size(); ++i) {
        const float x = xs[i], y = xs[xs.size() - 1 - i];
        for (float v : {raster::exp2(x), raster::log2(x), raster::pow(x, y), raster::exp(x)}) add(v);
        add(raster::pow_shared(x, 37.0f));
        for (float v : {raster::sin(x), raster::cos(x), raster::tan(x)}) add(v);
        for (float v : {raster::acos(x), raster::atan2(x, y)}) add(v);
        if (std::fabs(x) < 1e6f) {
            const auto [s, c] = sin_cos_degrees(x);
            add(float(s));
            add(float(c));
        }
    }
    EXPECT_EQ(hash, 2820860329816367890u);
}

// -------------------------------------------------------------------------------------------- GLM over packs

using F8 = FloatPack<8>;

/// A shader's arithmetic with uniforms, once as scalars and once in lanes.
template <class F>
vec<3, F> some_shading(const vec<3, F>& n, const vec<3, F>& l, const glm::mat3& m, const glm::mat4& m4) {
    const glm::vec3 uniform(0.3f, -0.2f, 0.9f);
    vec<3, F> r = m * n + vec<3, F>(m4 * vec<4, F>(l, F(1.0f)));
    r = raster::mix(r, n, 0.25f) + raster::min(n, l) * raster::max(n, uniform) * raster::dot(n, uniform);
    r = raster::clamp(r, -0.5f, 0.75f);
    return raster::select(raster::dot(n, l) > 0.1f, r, uniform) + raster::pow(raster::max(n, F(0.0f)), 2.2f);
}

TEST(LanesGlm, VectorsAndMatricesOverLanesGiveTheScalarsBits) {
    testing::Random random(6);
    const auto any = [&] { return random.uniform(-1.0f, 1.0f); };
    for (int round = 0; round < 100; ++round) {
        glm::mat3 m;
        glm::mat4 m4;
        for (int i = 0; i < 9; ++i) m[i / 3][i % 3] = any();
        for (int i = 0; i < 16; ++i) m4[i / 4][i % 4] = any();
        float n[3][8], l[3][8];
        for (int i = 0; i < 24; ++i) n[i / 8][i % 8] = any();
        for (int i = 0; i < 24; ++i) l[i / 8][i % 8] = any();
        const vec<3, F8> lanes_n(load<F8>(n[0]), load<F8>(n[1]), load<F8>(n[2]));
        const vec<3, F8> lanes_l(load<F8>(l[0]), load<F8>(l[1]), load<F8>(l[2]));
        const vec<3, F8> out = some_shading<F8>(lanes_n, lanes_l, m, m4);
        for (int k = 0; k < 8; ++k) {
            const glm::vec3 scalar_n(n[0][k], n[1][k], n[2][k]), scalar_l(l[0][k], l[1][k], l[2][k]);
            const glm::vec3 scalar = some_shading<float>(scalar_n, scalar_l, m, m4);
            for (int c = 0; c < 3; ++c) ASSERT_EQ(as_int(scalar[c]), as_int(lane(out[c], k))) << c << k;
        }
    }
}

}  // namespace
}  // namespace raster
