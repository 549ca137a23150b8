// flip_paper.h: FLIP as its paper has it, in double precision with the C library's mathematics, for tests.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <vector>

#include <raster/image/image.h>

/// Andersson and others, FLIP: A Difference Evaluator for Alternating Images, 2020; written apart from the library's.
namespace raster::testing::flip_paper {

using Color = std::array<double, 3>;
using Plane = std::vector<double>;

inline constexpr double pi = 3.14159265358979324;
inline constexpr Color white = {0.950428545, 1.000000000, 1.088900371};

inline Color xyz_from_linear(const Color& c) {
    return {(10135552.0 * c[0] + 8788810.0 * c[1] + 4435075.0 * c[2]) / 24577794.0,
            (2613072.0 * c[0] + 8788810.0 * c[1] + 887015.0 * c[2]) / 12288897.0,
            (1425312.0 * c[0] + 8788810.0 * c[1] + 70074185.0 * c[2]) / 73733382.0};
}

inline Color linear_from_xyz(const Color& xyz) {
    // Cramer's rule.
    const Color r = xyz_from_linear({1, 0, 0}), g = xyz_from_linear({0, 1, 0}), b = xyz_from_linear({0, 0, 1});
    const auto determinant = [](const Color& u, const Color& v, const Color& w) {
        return u[0] * (v[1] * w[2] - v[2] * w[1]) - u[1] * (v[0] * w[2] - v[2] * w[0]) +
               u[2] * (v[0] * w[1] - v[1] * w[0]);
    };
    const double all = determinant(r, g, b);
    return {determinant(xyz, g, b) / all, determinant(r, xyz, b) / all, determinant(r, g, xyz) / all};
}

inline Color ycxcz_from_linear(const Color& c) {
    Color t = xyz_from_linear(c);
    for (int i = 0; i < 3; ++i) t[i] /= white[i];
    return {116 * t[1] - 16, 500 * (t[0] - t[1]), 200 * (t[1] - t[2])};
}

inline Color linear_from_ycxcz(const Color& c) {
    const double y = (c[0] + 16) / 116, x = y + c[1] / 500, z = y - c[2] / 200;
    return linear_from_xyz({x * white[0], y * white[1], z * white[2]});
}

inline Color hunt_lab_from_linear(const Color& c) {
    Color t = xyz_from_linear(c);
    for (int i = 0; i < 3; ++i) {
        t[i] /= white[i];
        const double delta = 6.0 / 29;
        t[i] = t[i] > delta * delta * delta ? std::cbrt(t[i]) : t[i] / (3 * delta * delta) + 4.0 / 29;
    }
    const double l = 116 * t[1] - 16;
    return {l, 0.01 * l * 500 * (t[0] - t[1]), 0.01 * l * 200 * (t[1] - t[2])};
}

inline double hyab(const Color& p, const Color& q) {
    return std::abs(p[0] - q[0]) + std::hypot(p[1] - q[1], p[2] - q[2]);
}

struct Planes {
    int width, height;
    std::array<Plane, 3> plane;
};

struct Kernel {
    int radius;
    Plane weights;
    double at(int x, int y) const { return weights[std::size_t((y + radius) * (2 * radius + 1) + x + radius)]; }
};

inline Kernel make_kernel(int radius, const std::function<double(int, int)>& weight) {
    Kernel kernel{radius, {}};
    for (int y = -radius; y <= radius; ++y)
        for (int x = -radius; x <= radius; ++x) kernel.weights.push_back(weight(x, y));
    return kernel;
}

inline Kernel sensitivity(double ppd, double a1, double b1, double a2, double b2) {
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

inline Kernel feature(double ppd, bool point, bool along_y) {
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

inline Plane filter(const Plane& in, int width, int height, const Kernel& kernel) {
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
inline Planes ycxcz(const Planes& image) {
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

inline Seen see(const Planes& image, double ppd) {
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

inline Plane flip_by_the_paper(const Planes& reference, const Planes& test, double ppd) {
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

inline double linear_from_srgb(double v) { return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4); }

inline Planes linear(const Image8& image) {
    Planes planes{image.width, image.height, {}};
    for (int i = 0; i < image.width * image.height; ++i)
        for (std::size_t k = 0; k < 3; ++k)
            planes.plane[k].push_back(linear_from_srgb(image.samples[std::size_t(3 * i) + k] / 255.0));
    return planes;
}

}  // namespace raster::testing::flip_paper
