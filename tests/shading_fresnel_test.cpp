// Fresnel's equations: limits, the angles with names, and the complex arithmetic that they come from.
#include <complex>

#include <gtest/gtest.h>
#include <raster/shading/fresnel.h>

#include "shading_testing.h"

namespace {

using namespace raster;
using namespace raster::testing;

/// Reflectance by the amplitudes with complex indices, in double.
double by_amplitudes(double c, std::complex<double> n) {
    const std::complex<double> one(1), s2 = 1 - c * c;
    const auto inside = std::sqrt(one - s2 / (n * n));
    const auto rs = (c - n * inside) / (c + n * inside), rp = (n * c - inside) / (n * c + inside);
    return (std::norm(rs) + std::norm(rp)) / 2;
}

float cosine(double degrees) { return float(std::cos(degrees * 3.14159265358979 / 180)); }

TEST(Fresnel, OfADielectricIsWhatTheAmplitudesGive) {
    for (const double n : {1.1, 1.33, 1.5, 2.4}) {
        for (double angle = 0; angle < 90; angle += 2.5) {
            EXPECT_NEAR(fresnel_dielectric(cosine(angle), float(n)), by_amplitudes(cosine(angle), n), 2e-6)
                << n << " " << angle;
        }
    }
}

TEST(Fresnel, OfADielectricIsTheFormulaOfTheTwoAngles) {
    for (double i = 0.02; i < 1.57; i += 0.05) {
        const double t = std::asin(std::sin(i) / 1.5);
        const double expected = 0.5 * std::pow(std::sin(i - t) / std::sin(i + t), 2) *
                                (1 + std::pow(std::cos(i + t) / std::cos(i - t), 2));
        EXPECT_NEAR(fresnel_dielectric(float(std::cos(i)), 1.5f), expected, 3e-6) << i;
    }
}

TEST(Fresnel, OfAConductorIsWhatTheAmplitudesGive) {
    Random random(1);
    for (int i = 0; i < 5000; ++i) {
        const float n = random.uniform(0.04f, 4), k = random.uniform(0, 8), c = random.uniform(0, 1);
        ASSERT_NEAR(fresnel_conductor(c, n, k), by_amplitudes(c, {n, -k}), 5e-5) << n << " " << k << " " << c;
    }
}

TEST(Fresnel, AtNormalIncidenceIsTheSquareOfTheDifferenceOverTheSum) {
    for (const float n : {0.2f, 0.7f, 1.0f, 1.5f, 3.0f}) {
        EXPECT_NEAR(fresnel_dielectric(1.0f, n), (n - 1) * (n - 1) / ((n + 1) * (n + 1)), 1e-6f);
        for (const float k : {0.0f, 2.0f, 6.0f})
            EXPECT_NEAR(fresnel_conductor(1.0f, n, k), ((n - 1) * (n - 1) + k * k) / ((n + 1) * (n + 1) + k * k),
                        1e-6f);
    }
}

TEST(Fresnel, AtGrazingIncidenceIsOne) {
    for (const float n : {0.3f, 1.2f, 1.5f, 2.5f}) {
        EXPECT_NEAR(fresnel_dielectric(0.0f, n), 1, 1e-6);
        for (const float k : {0.0f, 1.0f, 7.0f}) EXPECT_NEAR(fresnel_conductor(0.0f, n, k), 1, 1e-6);
    }
}

TEST(Fresnel, AtBrewstersAngleIsHalfOfThePerpendicularPart) {
    for (const double n : {1.33, 1.5, 2.0}) {
        const double angle = std::atan(n), inside = std::asin(std::sin(angle) / n);
        const double perpendicular = std::pow(std::sin(angle - inside) / std::sin(angle + inside), 2);
        EXPECT_NEAR(fresnel_dielectric(float(std::cos(angle)), float(n)), perpendicular / 2, 1e-6);
    }
}

TEST(Fresnel, FromADenseMediumIsTotalBeyondTheCriticalAngle) {
    const double critical = std::asin(1 / 1.5) * 180 / 3.14159265358979;
    for (double angle = critical + 0.01; angle < 90; angle += 3) {
        EXPECT_EQ(fresnel_dielectric(cosine(angle), 1 / 1.5f), 1.0f) << angle;
        EXPECT_NEAR(fresnel_conductor(cosine(angle), 1 / 1.5f, 0), 1.0f, 1e-6) << angle;
    }
    EXPECT_LT(fresnel_dielectric(cosine(critical - 1), 1 / 1.5f), 0.6f);
    // Seen from the other side a ray is reflected as much.
    for (double angle = 1; angle < critical - 0.5; angle += 5) {
        const double outside = std::asin(std::sin(angle * 3.14159265358979 / 180) * 1.5) * 180 / 3.14159265358979;
        EXPECT_NEAR(fresnel_dielectric(cosine(angle), 1 / 1.5f), fresnel_dielectric(cosine(outside), 1.5f), 1e-5);
    }
}

TEST(Fresnel, WithoutABoundaryIsNothing) {
    for (const float c : {0.1f, 0.7f, 1.0f}) EXPECT_NEAR(fresnel_dielectric(c, 1.0f), 0, 1e-12);
}

TEST(Fresnel, TheFormulaOfTheCoursesIsNearForMetalsAndFarForGlass) {
    double gold = 0, glass = 0;
    for (float c = 0; c <= 1; c += 0.01f) {
        gold = std::max(gold, double(std::abs(fresnel_conductor_approximate(c, 0.16f, 3.60f) -
                                              fresnel_conductor(c, 0.16f, 3.60f))));
        glass =
            std::max(glass, double(std::abs(fresnel_conductor_approximate(c, 1.5f, 0) - fresnel_dielectric(c, 1.5f))));
    }
    EXPECT_LT(gold, 0.01);
    EXPECT_GT(glass, 0.02);
}

TEST(Fresnel, IsWithinZeroAndOneForAnyIndexInLanesAsInTheScalar) {
    Random random(2);
    for (int i = 0; i < 4000; ++i) {
        const float n = random.uniform(0.01f, 5), k = random.integer(0, 1) ? random.uniform(0, 10) : 0;
        float c[8];
        for (float& x : c) x = random.integer(0, 9) ? random.uniform(0, 1) : float(random.integer(0, 1));
        const auto pack = load<FloatPack<8>>(c);
        const auto metal = fresnel_conductor(pack, n, k), glass = fresnel_dielectric(pack, n);
        for (int j = 0; j < 8; ++j) {
            const float a = fresnel_conductor(c[j], n, k), b = fresnel_dielectric(c[j], n);
            ASSERT_TRUE(a >= 0 && a <= 1 && b >= 0 && b <= 1) << n << " " << k << " " << c[j];
            ASSERT_EQ(bits_of(a), bits_of(lane(metal, j)));
            ASSERT_EQ(bits_of(b), bits_of(lane(glass, j)));
        }
    }
}

TEST(Fresnel, TheMeanOverAllSidesIsTheIntegral) {
    for (const float n : {1.1f, 1.3f, 1.5f, 1.9f}) {
        double sum = 0;
        constexpr int steps = 20000;
        for (int i = 0; i < steps; ++i) {
            const float c = (float(i) + 0.5f) / steps;
            sum += double(fresnel_dielectric(c, 1 / n)) * 2 * c / steps;  // from inside, as Jensen and others use it
        }
        EXPECT_NEAR(fresnel_diffuse(n), sum, 0.02) << n;
    }
}

TEST(Fresnel, TakesTheIndicesOfTheMaterial) {
    Material material;
    EXPECT_EQ(Fresnel{}.with_material(material).n, glm::vec3(1.5f));
    material.index_of_refraction = 1.33f;
    EXPECT_EQ(Fresnel{}.with_material(material).n, glm::vec3(1.33f));
    material.refractive_index = {0.2f, 0.9f, 1.3f};
    material.extinction = {3, 2, 1};
    EXPECT_EQ(Fresnel{}.with_material(material).n, material.refractive_index);
    EXPECT_EQ(Fresnel{}.with_material(material).k, material.extinction);
}

}  // namespace
