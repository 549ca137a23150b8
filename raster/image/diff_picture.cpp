// diff_picture.cpp: ghosts, orange and blue.
#include <raster/image/diff_picture.h>

#include <algorithm>
#include <array>
#include <cmath>

#include <raster/image/diff_steps.h>
#include <raster/image/metrics_display.h>
#include <raster/math.h>
#include <raster/tiles/parallel.h>

namespace raster {
namespace {

using Rgb8 = std::array<std::uint8_t, 3>;

constexpr float white = 1.0f;

std::uint8_t to_byte(float v) { return std::uint8_t(v * 255.0f + 0.5f); }

void set(std::uint8_t* pixel, const Rgb8& color) { std::copy(color.begin(), color.end(), pixel); }

/// From light to dark orange as a difference grows from the smallest step to the peak.
Rgb8 failing_color(float delta, float peak) {
    constexpr Rgb8 small = {255, 168, 60}, large = {196, 48, 0};
    const float t = clamp(sqrt(delta / peak), 0.0f, 1.0f);
    Rgb8 color;
    for (std::size_t c = 0; c < 3; ++c) color[c] = std::uint8_t(float(small[c]) + t * (float(large[c]) - float(small[c])));
    return color;
}

constexpr Rgb8 tolerated_color = {64, 140, 230};

/// A panel of the triptych: how the picture's pixels map to it.
struct Scale {
    Scale(int width, int height, int larger_side) {
        constexpr int most = 1024, least = 256;
        shrink = std::max((larger_side + most - 1) / most, 1);
        grow = shrink > 1 ? 1 : std::max(least / larger_side, 1);
        this->width = (width + shrink - 1) / shrink * grow;
        this->height = (height + shrink - 1) / shrink * grow;
    }
    int shrink, grow, width, height;
};

/// The mean of a block of pixels, or (for differences) its most colourful pixel.
void shrink_block(const Image8& image, int x0, int y0, int size, bool most_colorful, std::uint8_t* out) {
    const int x1 = std::min(x0 + size, image.width), y1 = std::min(y0 + size, image.height);
    std::array<int, 3> sum{};
    int best = -1;
    for (int y = y0; y < y1; ++y)
        for (int x = x0; x < x1; ++x) {
            const std::uint8_t* p = image.pixel(x, y);
            if (most_colorful) {
                const int colorful = std::max({p[0], p[1], p[2]}) - std::min({p[0], p[1], p[2]});
                if (colorful > best) best = colorful, std::copy_n(p, 3, out);
            } else {
                for (std::size_t c = 0; c < 3; ++c) sum[c] += p[c];
            }
        }
    const int count = (x1 - x0) * (y1 - y0);
    for (std::size_t c = 0; c < 3 && !most_colorful; ++c) out[c] = std::uint8_t((sum[c] + count / 2) / count);
}

void place(const Image8& image, const Scale& scale, bool most_colorful, int left, int top, Image8& page) {
    tiles::parallel_for(std::size_t(scale.height / scale.grow), [&](std::size_t row) {
        for (int column = 0; column < scale.width / scale.grow; ++column) {
            Rgb8 color;
            shrink_block(image, column * scale.shrink, int(row) * scale.shrink, scale.shrink, most_colorful, color.data());
            for (int v = 0; v < scale.grow; ++v)
                for (int u = 0; u < scale.grow; ++u)
                    set(page.pixel(left + column * scale.grow + u, top + int(row) * scale.grow + v), color);
        }
    });
}

}  // namespace

Image8 displayed(const AnyImage& image) {
    if (const auto* bytes = std::get_if<Image8>(&image); bytes != nullptr && bytes->channels == 3) return *bytes;
    const Display display(image, white);
    Image8 out(display.width(), display.height(), 3);
    tiles::parallel_for(std::size_t(out.height), [&](std::size_t y) {
        std::vector<float> rgb(3 * std::size_t(out.width));
        float *red = rgb.data(), *green = red + out.width, *blue = green + out.width;
        display.encoded_row(0, int(y), out.width, red, green, blue);
        for (int x = 0; x < out.width; ++x) set(out.pixel(x, int(y)), {to_byte(red[x]), to_byte(green[x]), to_byte(blue[x])});
    });
    return out;
}

Image8 difference_picture(const AnyImage& expected, const Diff& diff) {
    const Display display(expected, white);
    Image8 out(display.width(), display.height(), 3);
    const int bits = diff_steps::shape_of(expected).bits;
    const float peak = bits == 8 ? 255.0f : bits == 16 ? 65535.0f : 1.0f;
    tiles::parallel_for(std::size_t(out.height), [&](std::size_t row) {
        const int y = int(row);
        std::vector<float> luma(std::size_t(out.width));
        display.luma_row(0, y, out.width, luma.data());
        for (int x = 0; x < out.width; ++x) {
            const std::uint8_t pale = to_byte(0.72f + 0.25f * luma[std::size_t(x)]);
            const float delta = diff.deltas.empty() ? 0.0f : *diff.deltas.pixel(x, y);
            std::uint8_t* pixel = out.pixel(x, y);
            set(pixel, {pale, pale, pale});
            if (!diff.compared.empty() && *diff.compared.pixel(x, y) == 0) {
                const std::uint8_t hatch = std::uint8_t((x + y) % 8 < 4 ? pale - 60 : pale - 30);
                set(pixel, {hatch, hatch, hatch});
            } else if (delta > diff.allowed_delta) {
                set(pixel, failing_color(delta, peak));
            } else if (delta > 0) {
                set(pixel, tolerated_color);
            }
        }
    });
    return out;
}

Image8 flip_picture(const Diff& diff) {
    Image8 out(diff.flip_map.width, diff.flip_map.height, 1);
    std::transform(diff.flip_map.samples.begin(), diff.flip_map.samples.end(), out.samples.begin(),
                   [](float error) { return to_byte(min(error, 1.0f)); });
    return out;
}

Image8 triptych(const AnyImage& expected, const AnyImage& actual, const Image8& difference) {
    const diff_steps::Shape e = diff_steps::shape_of(expected), a = diff_steps::shape_of(actual);
    const int larger = std::max({e.width, e.height, a.width, a.height});
    const Scale e_scale(e.width, e.height, larger), a_scale(a.width, a.height, larger);
    constexpr int gap = 8;
    const int panels = difference.empty() ? 2 : 3;
    const int width = e_scale.width + a_scale.width + (panels == 3 ? e_scale.width : 0) + (panels + 1) * gap;
    Image8 page(width, std::max(e_scale.height, a_scale.height) + 2 * gap, 3, 120);
    place(displayed(expected), e_scale, false, gap, gap, page);
    place(displayed(actual), a_scale, false, 2 * gap + e_scale.width, gap, page);
    if (panels == 3) place(difference, e_scale, true, 3 * gap + e_scale.width + a_scale.width, gap, page);
    return page;
}

}  // namespace raster
