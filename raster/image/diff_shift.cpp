// diff_shift.cpp: differences that go away when edges may lie a pixel or so elsewhere.
#include <raster/image/diff_steps.h>

#include <algorithm>
#include <atomic>
#include <cmath>

#include <raster/tiles/parallel.h>

namespace raster::diff_steps {
namespace {

template <class T>
float distance(const T* a, const T* b, int channels) {
    double largest = 0;
    for (int c = 0; c < channels; ++c)
        largest = std::max(largest, a[c] == b[c] ? 0.0 : std::abs(double(a[c]) - double(b[c])));
    return float(largest);
}

/// The distance from a colour to the nearest one around (x, y) in `image`, if it is below `best`; else `best`.
template <class T>
float nearest_around(const T* color, const Image<T>& image, int x, int y, int radius, float best, float enough) {
    const int x0 = std::max(x - radius, 0), x1 = std::min(x + radius, image.width - 1);
    const int y0 = std::max(y - radius, 0), y1 = std::min(y + radius, image.height - 1);
    for (int v = y0; v <= y1; ++v)
        for (int u = x0; u <= x1; ++u) {
            best = std::min(best, distance(color, image.pixel(u, v), image.channels));
            if (best <= enough) return best;
        }
    return best;
}

// Both ways, or a line that is missing altogether would pass: each of its pixels, now background, has background near.
template <class T>
float shifted_delta(const Image<T>& expected, const Image<T>& actual, int x, int y, int radius, float delta,
                    float enough) {
    const float to_expected = nearest_around(actual.pixel(x, y), expected, x, y, radius, delta, enough);
    const float to_actual = nearest_around(expected.pixel(x, y), actual, x, y, radius, delta, enough);
    return std::max(to_expected, to_actual);
}

}  // namespace

void allow_shift(const AnyImage& expected, const AnyImage& actual, int radius, ImageF& deltas) {
    std::visit(
        [&]<class T>(const Image<T>& e) {
            const auto& a = std::get<Image<T>>(actual);
            tiles::parallel_for(std::size_t(deltas.height), [&](std::size_t row) {
                float* delta = deltas.pixel(0, int(row));
                for (int x = 0; x < deltas.width; ++x)
                    if (delta[x] > 0) delta[x] = shifted_delta(e, a, x, int(row), radius, delta[x], 0.0f);
            });
        },
        expected);
}

bool shift_explains_all(const AnyImage& expected, const AnyImage& actual, int radius, float max_delta,
                        const ImageF& deltas) {
    return std::visit(
        [&]<class T>(const Image<T>& e) {
            const auto& a = std::get<Image<T>>(actual);
            for (int y = 0; y < deltas.height; ++y)
                for (int x = 0; x < deltas.width; ++x) {
                    const float delta = *deltas.pixel(x, y);
                    if (delta > max_delta && shifted_delta(e, a, x, y, radius, delta, max_delta) > max_delta)
                        return false;
                }
            return true;
        },
        expected);
}

}  // namespace raster::diff_steps
