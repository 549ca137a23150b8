// He and Torrance's model: its parts against double precision and iteration, its limits of smooth and rough.
#include <gtest/gtest.h>
#include <raster/shading/models.h>

#include "shading_hemisphere.h"

namespace {

using namespace raster;
using namespace raster::testing;

const Fresnel mirror{glm::vec3(1e-4f), glm::vec3(1e4f)};

TEST(HeTorranceParts, TheErrorFunctionIsTheLibrarys) {
    for (double x = 0; x < 6; x += 0.01) EXPECT_NEAR(he_torrance::erfc(float(x)), std::erfc(x), 1e-6);
}

TEST(HeTorranceParts, TheEffectiveRoughnessSolvesThePapersEquation) {
    for (const double shape : {0.7, 2.0, 5.0}) {
        for (const double c_l : {0.003, 0.05, 0.3, 0.8}) {
            for (const double c_v : {0.003, 0.1, 0.9}) {
                const auto k = [&](double c) {
                    const double tan = std::sqrt(1 - c * c) / c;
                    return tan * std::erfc(shape / tan);
                };
                // sqrt(pi / 2) x = (K + K) / 4 exp(-x^2 / 2), by bisection.
                const double right = (k(c_l) + k(c_v)) / 4;
                double low = 0, high = 10;
                for (int i = 0; i < 60; ++i) {
                    const double x = (low + high) / 2;
                    (std::sqrt(3.14159265358979 / 2) * x > right * std::exp(-x * x / 2) ? high : low) = x;
                }
                const double expected = 1 / (1 + low * low);
                EXPECT_NEAR(he_torrance::effective_roughness(float(c_l), float(c_v), float(shape)), expected, 2e-3)
                    << shape << " " << c_l << " " << c_v;
            }
        }
    }
}

double exact_series(double g, double spread) {
    double sum = 0;
    for (int m = 1; m < 2000; ++m)
        sum += std::exp(m * std::log(g) - g - std::lgamma(m + 1)) / m * std::exp(-spread / m);
    return sum;
}

TEST(HeTorranceParts, TheSeriesIsTheSum) {
    for (const double g : {0.01, 0.5, 0.99, 2.0, 3.9, 8.0, 15.9, 19.9}) {
        const double peak = exact_series(g, 0);
        for (const double spread : {0.0, 0.3, 2.0, 10.0, 40.0}) {
            const double expected = exact_series(g, spread);
            EXPECT_NEAR(he_torrance::scattering(float(g), float(spread), 20.0f), expected, 1e-4 * peak)
                << g << " " << spread;
            EXPECT_NEAR(he_torrance::scattering(float(g), float(spread), float(g)), expected, 3e-3 * peak)
                << g << " " << spread;
        }
    }
}

TEST(HeTorranceParts, BeyondTheSeriesItsExpansionIsNear) {
    for (const double g : {20.1, 25.0, 60.0, 400.0}) {
        const double peak = exact_series(g, 0);
        for (const double t : {0.0, 0.5, 1.0, 2.0, 4.0, 7.0})
            EXPECT_NEAR(he_torrance::scattering(float(g), float(t * g), 1000.0f), exact_series(g, t * g), 3e-4 * peak)
                << g << " " << t;
    }
}

/// The directional diffuse part of one channel without Fresnel's factor; light and viewer on opposite sides.
double exact_directional(const HeTorrance& m, double c_l, double c_v, double wavelength) {
    const double pi = 3.14159265358979, sigma = double(m.sigma), tau = double(m.tau);
    const auto tangent = [](double c) { return std::sqrt(1 - c * c) / c; };
    const auto k = [&](double c) { return tangent(c) * std::erfc(tau / (2 * sigma * tangent(c))); };
    const auto seen = [&](double c) {
        const double nu = tau / (2 * sigma * tangent(c));
        const double hidden = (std::exp(-nu * nu) / (nu * std::sqrt(pi)) - std::erfc(nu)) / 2;
        return (1 - std::erfc(nu) / 2) / (1 + hidden);
    };
    const double right = (k(c_l) + k(c_v)) / 4;
    double x = 0, high = 20;
    for (int i = 0; i < 80; ++i) {
        const double middle = (x + high) / 2;
        (std::sqrt(pi / 2) * middle > right * std::exp(-middle * middle / 2) ? high : x) = middle;
    }
    const double s_l = std::sqrt(1 - c_l * c_l), s_v = std::sqrt(1 - c_v * c_v), sum = c_l + c_v;
    const double tilt = (s_l - s_v) * (s_l - s_v), length2 = sum * sum + tilt;
    const double phase = 2 * pi / wavelength * sigma / std::sqrt(1 + x * x) * sum;
    const double series = exact_series(phase * phase, tilt * std::pow(pi * tau / wavelength, 2));
    return std::pow(length2 / sum * pi * tau / wavelength, 2) / 4 * series / c_v * seen(c_l) * seen(c_v);
}

TEST(HeTorrance, IsThePapersFormulaUpToTheEdgeOfTheSurface) {
    HeTorrance model;
    model.fresnel = mirror;
    model.sigma = 0.25f;
    model.source_degrees = 0.01f;  // of the mirror part nothing is seen here
    for (const double c_l : {0.9, 0.5}) {
        for (const double c_v : {0.8, 0.2, 0.01, 1e-3, 1e-4, 1e-5, 1e-6}) {
            const glm::vec3 l(-float(std::sqrt(1 - c_l * c_l)), 0, float(c_l));
            const glm::vec3 v(float(std::sqrt(1 - c_v * c_v)), 0, float(c_v));
            const auto value = model.evaluate(flat_frame(v), l).specular;
            for (int c = 0; c < 3; ++c) {
                const double expected = exact_directional(model, c_l, c_v, double(model.wavelength[c]));
                EXPECT_NEAR(value[c], expected, 1e-3 * expected + 1e-5) << c_l << " " << c_v << " " << c;
            }
        }
    }
}

TEST(HeTorrance, ASmoothSurfaceIsAMirror) {
    HeTorrance model;
    model.fresnel = mirror;
    model.sigma = 0;
    const float bright = model.evaluate(flat_frame(at_degrees(-40)), at_degrees(40)).specular.x;
    EXPECT_NEAR(bright, 3.14159265 / (2 * 3.14159265 * (1 - std::cos(3.14159265 / 180))), 60)
        << "pi over the solid angle";
    EXPECT_EQ(model.evaluate(flat_frame(at_degrees(-42)), at_degrees(40)).specular.x, 0.0f);
}

TEST(HeTorrance, TheMirrorPartIsExpMinusGAndGrowsTowardsGrazing) {
    HeTorrance model;
    model.fresnel = mirror;
    model.sigma = 0.06f;
    model.tau = 20;  // so wide that nothing is hidden and the diffuse part is narrow
    HeTorrance smooth = model;
    smooth.sigma = 0;
    for (const double angle : {0.0, 40.0, 70.0}) {
        const double c = std::cos(angle * 3.14159265358979 / 180);
        for (int channel = 0; channel < 3; ++channel) {
            const double g = std::pow(2 * 3.14159265358979 * 0.06 / double(model.wavelength[channel]) * 2 * c, 2);
            const auto frame = flat_frame(at_degrees(-angle + 0.9));  // at the edge of the mirror's cone
            const float rough = model.evaluate(frame, at_degrees(angle)).specular[channel];
            const float whole = smooth.evaluate(frame, at_degrees(angle)).specular[channel];
            HeTorrance without = model;
            without.source_degrees = 0.0f;
            const float diffuse = without.evaluate(frame, at_degrees(angle)).specular[channel];
            EXPECT_NEAR((rough - diffuse) / whole, std::exp(-g), 0.02) << angle;
        }
    }
}

TEST(HeTorrance, ARoughSurfaceIsCookTorrancesOfItsSlope) {
    // In the limit of large g the phases are random, and what is left are mirrors of the slope m = 2 sigma / tau.
    HeTorrance he;
    he.fresnel = mirror;
    he.sigma = 3.0f;
    he.tau = 20.0f;
    const CookTorrance facets{mirror, 0.3f};
    for (const double light : {0.0, 20.0, 40.0}) {
        for (const double viewer : {-55.0, -40.0, -20.0, 0.0, 15.0}) {
            const auto frame = flat_frame(at_degrees(viewer));
            const float a = he.evaluate(frame, at_degrees(light)).specular.y;
            const float b = facets.evaluate(frame, at_degrees(light)).specular.y;
            EXPECT_NEAR(a, b, 0.05 * b + 0.02) << light << " " << viewer;
        }
    }
}

TEST(HeTorrance, RedSeesASmootherSurfaceThanBlue) {
    HeTorrance model;
    model.fresnel = mirror;
    model.sigma = 0.1f;
    const auto value = model.evaluate(flat_frame(at_degrees(-60)), at_degrees(60)).specular;
    EXPECT_GT(value.x, value.y);
    EXPECT_GT(value.y, value.z);
}

}  // namespace
