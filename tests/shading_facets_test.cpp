// The models of rough surfaces against their papers' formulas, written in angles and double precision.
#include <complex>

#include <gtest/gtest.h>
#include <raster/shading/models.h>

#include "shading_hemisphere.h"

namespace {

using namespace raster;
using namespace raster::testing;

constexpr double pi = 3.14159265358979323846;

/// A pair of directions by their angles, as papers have them.
struct Pair {
    glm::vec3 l, v;
    double theta_l, theta_v, phi;  ///< polar angles; phi between the azimuths
    double alpha, beta;            ///< of h from n; of l from h
};

Pair random_pair(Random& random) {
    const float phi_l = random.uniform(0, 6.28f), phi_v = random.uniform(0, 6.28f);
    Pair p;
    p.l = direction_above(random.uniform(0.03f, 0.999f), phi_l);
    p.v = direction_above(random.uniform(0.03f, 0.999f), phi_v);
    const glm::dvec3 l(p.l), v(p.v), h = glm::normalize(l + v);
    p.theta_l = std::atan2(std::hypot(l.x, l.y), l.z);
    p.theta_v = std::atan2(std::hypot(v.x, v.y), v.z);
    p.phi = std::atan2(l.y, l.x) - std::atan2(v.y, v.x);
    p.alpha = std::atan2(std::hypot(h.x, h.y), h.z);
    p.beta = std::atan2(glm::length(glm::cross(l, h)), glm::dot(l, h));
    return p;
}

template <class Check>
void for_random_pairs(const Check& check) {
    Random random(1);
    for (int i = 0; i < 2000; ++i) check(random_pair(random));
}

#define EXPECT_CLOSE(value, expected, relative) \
    EXPECT_NEAR(value, expected, relative * std::max(double(expected), 1e-3))

TEST(Distributions, HaveTheIntegralPiOfTheirProjectedFacets) {
    for (const double m : {0.05, 0.1, 0.3, 0.5, 0.7, 1.0}) {
        double beckmann = 0, gaussian = 0;
        constexpr int steps = 20000;
        for (int i = 0; i < steps; ++i) {
            const double a = (i + 0.5) / steps * pi / 2, weight = 2 * pi * std::sin(a) * std::cos(a) * pi / 2 / steps;
            beckmann += weight * double(beckmann_distribution(float(1 / std::pow(std::cos(a), 2)), float(m)));
            gaussian += weight * double(gaussian_distribution(float(std::cos(a)), float(m)));
        }
        EXPECT_NEAR(beckmann, pi, 0.001 * pi) << m;
        EXPECT_NEAR(gaussian, pi, (m > 0.7 ? 0.02 : 0.001) * pi) << m;
    }
}

TEST(Distributions, AreThePapersFunctionsOfTheAngle) {
    for (const double m : {0.1, 0.3, 0.6}) {
        const double c = double(gaussian_distribution(1.0f, float(m)));
        for (double a = 0; a < 1.2; a += 0.1) {
            const float cosine = float(std::cos(a));
            const double beckmann = std::exp(-std::pow(std::tan(a) / m, 2)) / (m * m * std::pow(std::cos(a), 4));
            EXPECT_NEAR(beckmann_distribution(1 / (cosine * cosine), float(m)), beckmann, 2e-5 / m / m);
            EXPECT_NEAR(gaussian_distribution(cosine, float(m)), c * std::exp(-std::pow(a / m, 2)), 2e-5 / m / m);
        }
    }
}

TEST(Grooves, HideLightOnOneSideOrTheOtherAndNothingFromAbove) {
    for_random_pairs([](const Pair& p) {
        const auto h = make_half_vector(flat_frame(p.v), p.l);
        const double n_h = std::cos(p.alpha), v_h = std::cos(p.beta);
        const double expected =
            std::min({1.0, 2 * n_h * std::cos(p.theta_v) / v_h, 2 * n_h * std::cos(p.theta_l) / v_h});
        EXPECT_NEAR(groove_masking(h), expected, 1e-5);
        const float d = 3.0f;
        EXPECT_CLOSE(facet_reflection(h, d), d * expected / (4 * std::cos(p.theta_v)), 1e-4);
    });
    EXPECT_EQ(groove_masking(make_half_vector(flat_frame({0, 0, 1}), glm::vec3(0, 0, 1))), 1.0f);
}

TEST(CookTorrance, IsTheFormulaOfThePaper) {
    const glm::vec3 n(0.16f, 0.42f, 1.38f), k(3.6f, 2.47f, 1.92f);
    for (const auto distribution : {CookTorrance::Distribution::beckmann, CookTorrance::Distribution::gaussian}) {
        const float m = 0.35f;
        const CookTorrance model{{n, k}, m, distribution};
        for_random_pairs([&](const Pair& p) {
            const double n_h = std::cos(p.alpha), v_h = std::cos(p.beta);
            const double g = std::min({1.0, 2 * n_h * double(p.v.z) / v_h, 2 * n_h * double(p.l.z) / v_h});
            const double d = distribution == CookTorrance::Distribution::beckmann
                                 ? std::exp(-std::pow(std::tan(p.alpha) / m, 2)) / (m * m * std::pow(n_h, 4))
                                 : double(gaussian_distribution(1.0f, m)) * std::exp(-std::pow(p.alpha / m, 2));
            const auto value = model.evaluate(flat_frame(p.v), p.l);
            for (int c = 0; c < 3; ++c) {
                const double f =
                    fresnel_conductor(float(v_h), n[c], k[c]) * g * d / (4 * pi * double(p.l.z) * double(p.v.z));
                EXPECT_CLOSE(value.specular[c], pi * f * double(p.l.z), 5e-4);
            }
            EXPECT_EQ(value.diffuse.x, p.l.z);
        });
    }
}

/// Fresnel's amplitudes over complex numbers, for a cosine c in air.
double fresnel_of_amplitudes(double c, std::complex<double> index) {
    const std::complex<double> n2 = index * index, g = std::sqrt(n2 - (1 - c * c));
    return (std::norm((c - g) / (c + g)) + std::norm((n2 * c - g) / (n2 * c + g))) / 2;
}

/// c of the Gaussian c exp(-(alpha / m)^2) whose integral of cos alpha over all directions, as far as it goes, is pi.
double gaussian_peak(double m) {
    double projected = 0;
    constexpr int steps = 2000;
    for (int i = 0; i < steps; ++i) {
        const double a = (i + 0.5) / steps * 8 * m;
        projected += pi * std::sin(2 * a) * std::exp(-std::pow(a / m, 2)) * 8 * m / steps;
    }
    return pi / projected;
}

/// pi f cos_l of Torrance and Sparrow's F G D / (4 (n l)(n v)), all from the angles.
double spread_mirrors(const Pair& p, std::complex<double> index, double m, double peak) {
    const double n_h = std::cos(p.alpha), v_h = std::cos(p.beta), n_l = std::cos(p.theta_l), n_v = std::cos(p.theta_v);
    const double g = std::min({1.0, 2 * n_h * n_v / v_h, 2 * n_h * n_l / v_h});
    return fresnel_of_amplitudes(v_h, index) * g * peak * std::exp(-std::pow(p.alpha / m, 2)) / (4 * n_v);
}

TEST(TorranceSparrow, IsTheFormulaOfThePaper) {
    const glm::vec3 n(0.16f, 0.42f, 1.38f), k(3.6f, 2.47f, 1.92f);
    for (const double m : {0.12, 0.35, 0.6}) {
        const double peak = gaussian_peak(m);
        const TorranceSparrow metal{{n, k}, float(m)}, plastic{{glm::vec3(1.5f), glm::vec3(0)}, float(m)};
        for_random_pairs([&](const Pair& p) {
            const auto value = metal.evaluate(flat_frame(p.v), p.l);
            for (int c = 0; c < 3; ++c)
                EXPECT_CLOSE(value.specular[c], spread_mirrors(p, {double(n[c]), double(k[c])}, m, peak), 5e-4);
            EXPECT_EQ(value.diffuse.x, p.l.z);
            EXPECT_CLOSE(plastic.evaluate(flat_frame(p.v), p.l).specular.y, spread_mirrors(p, 1.5, m, peak), 5e-4);
        });
    }
}

TEST(TorranceSparrow, PeaksBeyondTheMirrorDirectionAtGrazingLight) {
    const auto peak = [](double light, float m = 0.3f) {
        double best = 0, at = 0;
        for (double v = -89; v < 89; v += 0.25) {
            const double value =
                double(TorranceSparrow{{}, m}.evaluate(flat_frame(at_degrees(v)), at_degrees(-light)).specular.x);
            if (value > best) best = value, at = v;
        }
        return at;
    };
    EXPECT_NEAR(peak(0), 0, 0.3);
    EXPECT_NEAR(peak(30, 0.05f), 30, 1);
    EXPECT_GT(peak(30), 40);
    EXPECT_GT(peak(60), 65);
    EXPECT_GT(peak(70), 78);
}

TEST(OrenNayar, IsTheFormulaOfThePaper) {
    for (const double sigma : {0.1, 0.5, 1.2}) {
        for_random_pairs([&](const Pair& p) {
            const double s2 = sigma * sigma, a = 1 - 0.5 * s2 / (s2 + 0.33), b = 0.45 * s2 / (s2 + 0.09);
            const double larger = std::max(p.theta_l, p.theta_v), smaller = std::min(p.theta_l, p.theta_v);
            const double expected = std::cos(p.theta_l) *
                                    (a + b * std::max(0.0, std::cos(p.phi)) * std::sin(larger) * std::tan(smaller));
            EXPECT_NEAR(OrenNayar{float(sigma)}.evaluate(flat_frame(p.v), p.l).diffuse.x, expected, 3e-6);
        });
    }
}

TEST(OrenNayar, WithoutRoughnessIsLambert) {
    for_random_pairs([](const Pair& p) { EXPECT_EQ(OrenNayar{0}.evaluate(flat_frame(p.v), p.l).diffuse.x, p.l.z); });
}

TEST(Ward, IsTheFormulaOfThePaperInBothForms) {
    const double x = 0.15, y = 0.5;
    for_random_pairs([&](const Pair& p) {
        const glm::dvec3 l(p.l), v(p.v), h = l + v;
        const double gaussian = std::exp(-(std::pow(h.x / x, 2) + std::pow(h.y / y, 2)) / (h.z * h.z)) / (pi * x * y);
        const double old = pi * l.z * gaussian / (4 * std::sqrt(l.z * v.z));
        const double bounded = pi * l.z * gaussian * glm::dot(h, h) / std::pow(h.z, 4);
        const Ward ward{float(x), float(y)};
        EXPECT_CLOSE(ward.evaluate(flat_frame(p.v), p.l).specular.x, bounded, 1e-3);
        EXPECT_CLOSE((Ward{float(x), float(y), Ward::Form::ward_1992}.evaluate(flat_frame(p.v), p.l).specular.x), old,
                     1e-3);
    });
}

TEST(Ward, TurnsWithTheGrainAndIsRoundWithoutOne) {
    const Ward brushed{0.1f, 0.4f};
    const glm::vec3 v = at_degrees(0), aside = at_degrees(30);  // in the plane of x and z
    const auto along_x = brushed.evaluate(make_frame(glm::vec3(0, 0, 1), v, glm::vec3(1, 0, 0)), aside).specular.x;
    const auto along_y = brushed.evaluate(make_frame(glm::vec3(0, 0, 1), v, glm::vec3(0, 1, 0)), aside).specular.x;
    EXPECT_GT(along_y, 100 * along_x) << "a highlight is long across the grain";
    const auto none = brushed.evaluate(make_frame(glm::vec3(0, 0, 1), v, glm::vec3(0, 0, 1)), aside).specular.x;
    const auto round =
        Ward{0.2f, 0.2f}.evaluate(make_frame(glm::vec3(0, 0, 1), v, glm::vec3(1, 0, 0)), aside).specular.x;
    EXPECT_NEAR(none, round, 1e-4f * round);
}

TEST(Velvet, IsBrightAtItsOutlineAndDarkInTheMiddle) {
    const Velvet velvet{0.3f};
    const auto at = [&](double light, double viewer) {
        return velvet.evaluate(flat_frame(at_degrees(viewer)), at_degrees(light)).specular.x / at_degrees(light).z;
    };
    EXPECT_GT(at(60, 85), 2 * at(60, 0));
    EXPECT_GT(at(75, 80), 5 * at(0, 0));
    for_random_pairs([&](const Pair& p) {
        const double m = 0.3, sin4 = std::pow(std::sin(p.alpha), 4), c_l = std::cos(p.theta_l),
                     c_v = std::cos(p.theta_v);
        const double d = (1 + 4 * std::exp(-std::pow(1 / std::tan(p.alpha) / m, 2)) / sin4) / (pi * (1 + 4 * m * m));
        EXPECT_CLOSE(velvet.evaluate(flat_frame(p.v), p.l).specular.x, pi * c_l * d / (4 * (c_l + c_v - c_l * c_v)),
                     2e-3);
    });
}

TEST(Subsurface, OfJensensTableHasTheReflectanceThatHePrints) {
    // Table of the 2001 paper: diffuse reflectance of marble, skin 1, whole milk; to its two digits.
    const auto near = [](const Subsurface& s, glm::vec3 expected) {
        const glm::vec3 r = s.diffuse_reflectance();
        for (int c = 0; c < 3; ++c) EXPECT_NEAR(r[c], expected[c], 0.03);
    };
    near({{2.19f, 2.62f, 3.00f}, {0.0021f, 0.0041f, 0.0071f}, 1.5f}, {0.83f, 0.79f, 0.75f});
    near({{0.74f, 0.88f, 1.01f}, {0.032f, 0.17f, 0.48f}, 1.3f}, {0.44f, 0.22f, 0.13f});
    near({{2.55f, 3.21f, 3.77f}, {0.0011f, 0.0024f, 0.014f}, 1.3f}, {0.91f, 0.88f, 0.76f});
}

TEST(Subsurface, IsTheFormulaOfThePaperAboveAndBelowTheBoundary) {
    const glm::dvec3 scattering(2.19, 0.74, 0.5), absorption(0.0021, 0.17, 2);
    for (const double n : {1.2, 1.5, 1.9}) {
        const double m = 0.25, peak = gaussian_peak(m);
        const Subsurface model{glm::vec3(scattering), glm::vec3(absorption), float(n), float(m)};
        const double fdr = -1.440 / (n * n) + 0.710 / n + 0.668 + 0.0636 * n, a = (1 + fdr) / (1 - fdr);
        for_random_pairs([&](const Pair& p) {
            const auto value = model.evaluate(flat_frame(p.v), p.l);
            const double below_l = std::asin(std::sin(p.theta_l) / n), below_v = std::asin(std::sin(p.theta_v) / n);
            const double passing = (1 - fresnel_of_amplitudes(std::cos(p.theta_l), n)) *
                                   (1 - fresnel_of_amplitudes(std::cos(p.theta_v), n));
            for (int c = 0; c < 3; ++c) {
                const double albedo = scattering[c] / (scattering[c] + absorption[c]);
                const double root = std::sqrt(3 * (1 - albedo));
                const double rd = albedo / 2 * (1 + std::exp(-4.0 / 3 * a * root)) * std::exp(-root);
                const double once = albedo / (4 * (std::cos(below_l) + std::cos(below_v)));
                EXPECT_CLOSE(value.diffuse[c], passing * (rd + once) * std::cos(p.theta_l), 2e-4);
                EXPECT_CLOSE(value.specular[c], spread_mirrors(p, n, m, peak), 5e-4);
            }
        });
    }
}

TEST(Subsurface, WithoutScatteringIsBlackAndWithoutAbsorptionWhite) {
    EXPECT_EQ((Subsurface{glm::vec3(0), glm::vec3(1)}.diffuse_reflectance()), glm::vec3(0.0f));
    for (const float n : {1.1f, 1.3f, 1.5f})
        EXPECT_EQ((Subsurface{glm::vec3(2), glm::vec3(0), n}.diffuse_reflectance()), glm::vec3(1.0f));
}

}  // namespace
