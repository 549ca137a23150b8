// shapes_lathe.cpp: curves through points, and what is turned from them: the vase, the cylinder.
#include <raster/scene/shapes.h>

#include <algorithm>

namespace raster {
namespace {

/// The outline of the vase from the middle of its bottom, up its outside and down its inside: radius and height.
constexpr glm::dvec2 vase_outline[] = {
    {0, 0},        {0.42, 0},     {0.42, 0},    {0.46, 0.03},  {0.43, 0.1},  {0.6, 0.42},  {0.82, 0.95},
    {0.72, 1.45},  {0.42, 1.85},  {0.33, 2.08}, {0.42, 2.28},  {0.52, 2.37}, {0.52, 2.4},  {0.48, 2.39},
    {0.37, 2.28},  {0.28, 2.08},  {0.37, 1.83}, {0.66, 1.44},  {0.76, 0.95}, {0.55, 0.45}, {0.3, 0.2},
    {0.12, 0.16},  {0, 0.155}};

Model named(Model model, const char* name) {
    model.parts.front().name = name;
    return model;
}

}  // namespace

std::vector<glm::dvec2> curve_through(std::span<const glm::dvec2> points, int steps) {
    const int n = std::clamp(steps, 1, 64);
    std::vector<glm::dvec2> curve;
    const auto count = std::ptrdiff_t(points.size());
    for (std::ptrdiff_t i = 0; i + 1 < count; ++i) {
        const glm::dvec2 b = points[std::size_t(i)], c = points[std::size_t(i + 1)];
        curve.push_back(b);
        if (b == c) continue;
        // At an end, and at a sharp corner, the curve begins along the line to the next point.
        const glm::dvec2 a = i > 0 && points[std::size_t(i - 1)] != b ? points[std::size_t(i - 1)] : 2.0 * b - c;
        const glm::dvec2 d =
            i + 2 < count && points[std::size_t(i + 2)] != c ? points[std::size_t(i + 2)] : 2.0 * c - b;
        for (int k = 1; k < n; ++k) {
            const double t = double(k) / n;
            glm::dvec2 p = 0.5 * (2.0 * b + (c - a) * t + (2.0 * a - 5.0 * b + 4.0 * c - d) * (t * t) +
                                  (3.0 * b - a - 3.0 * c + d) * (t * t * t));
            p.x = std::max(p.x, 0.0);  // a curve that swings beyond the axis
            curve.push_back(p);
        }
    }
    if (count > 0) curve.push_back(points.back());
    return curve;
}

Model vase(int segments, int steps) {
    return named(surface_of_revolution(smooth_profile(curve_through(vase_outline, steps)), segments), "vase");
}

Model cylinder(int segments) {
    const glm::dvec2 outline[] = {{0, -1}, {1, -1}, {1, -1}, {1, 1}, {1, 1}, {0, 1}};
    return named(surface_of_revolution(smooth_profile(outline), segments), "cylinder");
}

}  // namespace raster
