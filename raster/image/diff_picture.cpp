// diff_picture.cpp: ghosts, orange and blue.
#include <raster/image/diff_picture.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <utility>

#include <raster/image/diff_steps.h>
#include <raster/image/flip_rows.h>
#include <raster/image/metrics_display.h>
#include <raster/image/pages.h>
#include <raster/math.h>
#include <raster/tiles/parallel.h>

namespace raster {
namespace {

using Rgb8 = std::array<std::uint8_t, 3>;

constexpr float white = 1.0f;

std::uint8_t to_byte(float v) { return std::uint8_t(v * 255.0f + 0.5f); }

// The palette: greys, of which the hatched ones are the darkest; what passes; what fails, from light to dark.
constexpr int darkest_grey = 124, lightest_grey = 247, tolerated_index = lightest_grey - darkest_grey + 1;
// A few steps of orange are as clear as many, and noise in them packs in half the time and bytes.
constexpr int failing_index = tolerated_index + 1, failing_steps = 33;

std::vector<Rgb8> difference_palette() {
    constexpr Rgb8 tolerated = {64, 140, 230}, small = {255, 168, 60}, large = {196, 48, 0};
    std::vector<Rgb8> palette;
    for (int grey = darkest_grey; grey <= lightest_grey; ++grey)
        palette.push_back({std::uint8_t(grey), std::uint8_t(grey), std::uint8_t(grey)});
    palette.push_back(tolerated);
    for (int step = 0; step < failing_steps; ++step) {
        const float t = float(step) / float(failing_steps - 1);
        Rgb8 color;
        for (std::size_t c = 0; c < 3; ++c)
            color[c] = std::uint8_t(float(small[c]) + t * (float(large[c]) - float(small[c])));
        palette.push_back(color);
    }
    return palette;
}

/// The colour of a pixel that fails, darker as the difference grows from the smallest step to the peak.
std::uint8_t failing(float share_of_peak) {
    const float t = min(sqrt(share_of_peak), 1.0f);
    return std::uint8_t(failing_index + int(t * float(failing_steps - 1)));
}

IndexedImage indexed(int width, int height, std::vector<Rgb8> palette) {
    IndexedImage image;
    image.indices.width = width, image.indices.height = height, image.indices.channels = 1;
    resize_whole(image.indices.samples, std::size_t(width) * std::size_t(height));
    image.palette = std::move(palette);
    return image;
}

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

/// Row y as a display shows it: of the picture itself if that has such rows, else made in `space`.
const std::uint8_t* displayed_row(const AnyImage& image, const Display& display, int y,
                                  std::vector<std::uint8_t>& space) {
    if (const auto* bytes = std::get_if<Image8>(&image); bytes != nullptr && bytes->channels == 3)
        return bytes->pixel(0, y);
    const std::size_t width = std::size_t(display.width());
    std::vector<float> rgb(3 * width);
    space.resize(3 * width);
    display.encoded_row(0, y, int(width), rgb.data(), rgb.data() + width, rgb.data() + 2 * width);
    for (std::size_t x = 0; x < width; ++x)
        for (std::size_t c = 0; c < 3; ++c) space[3 * x + c] = to_byte(rgb[c * width + x]);
    return space.data();
}

/// Puts row `row` of a panel, `grow` pixels for each colour, on the page.
void place_row(const std::vector<Rgb8>& colors, const Scale& scale, int left, int top, int row, Image8& page) {
    for (int v = 0; v < scale.grow; ++v) {
        std::uint8_t* out = page.pixel(left, top + row * scale.grow + v);
        if (scale.grow == 1) {  // of a large picture, all at once
            std::memcpy(out, colors.data(), colors.size() * sizeof(Rgb8));
            continue;
        }
        for (const Rgb8& color : colors)
            for (int u = 0; u < scale.grow; ++u) out = std::copy(color.begin(), color.end(), out);
    }
}

/// A picture, each colour the mean of a block. A Sum holds that of a block's column.
template <class Sum>
void place_means(const AnyImage& image, const Scale& scale, int left, int top, Image8& page) {
    const Display display(image, white);
    tiles::parallel_for(std::size_t(scale.height / scale.grow), [&](std::size_t row) {
        const int y0 = int(row) * scale.shrink, y1 = std::min(y0 + scale.shrink, display.height());
        const std::size_t samples = 3 * std::size_t(display.width()), block = 3 * std::size_t(scale.shrink);
        std::vector<Sum> sums(samples);
        std::vector<std::uint8_t> space;
        for (int y = y0; y < y1; ++y) {
            const std::uint8_t* in = displayed_row(image, display, y, space);
            Sum* const out = sums.data();
            for (std::size_t i = 0; i < samples; ++i) out[i] = Sum(out[i] + in[i]);
        }
        std::vector<Rgb8> colors;
        colors.reserve(samples / block + 1);
        for (std::size_t start = 0; start < samples; start += block) {
            const std::size_t end = std::min(start + block, samples);
            std::uint32_t r = 0, g = 0, b = 0;
            for (std::size_t i = start; i < end; i += 3) r += sums[i], g += sums[i + 1], b += sums[i + 2];
            // Rounded to the nearest: half a count more, and so far from whole numbers that the product may round too.
            const double half = double((end - start) / 3 * std::size_t(y1 - y0) / 2) + 0.5;
            const double share = 1.0 / double((end - start) / 3 * std::size_t(y1 - y0));
            const auto mean = [&](std::uint32_t sum) { return std::uint8_t((double(sum) + half) * share); };
            colors.push_back({mean(r), mean(g), mean(b)});
        }
        place_row(colors, scale, left, top, int(row), page);
    });
}

void place(const AnyImage& image, const Scale& scale, int left, int top, Image8& page) {
    if (scale.shrink <= 257)
        place_means<std::uint16_t>(image, scale, left, top, page);
    else
        place_means<std::uint32_t>(image, scale, left, top, page);
}

/// A difference, each colour the most colourful pixel of a block.
void place(const IndexedImage& image, const Scale& scale, int left, int top, Image8& page) {
    std::array<std::uint8_t, 256> colorful{};
    for (std::size_t i = 0; i < image.palette.size(); ++i) {
        const auto [least, most] = std::minmax_element(image.palette[i].begin(), image.palette[i].end());
        colorful[i] = std::uint8_t(*most - *least);
    }
    tiles::parallel_for(std::size_t(scale.height / scale.grow), [&](std::size_t row) {
        const int y0 = int(row) * scale.shrink, y1 = std::min(y0 + scale.shrink, image.indices.height);
        const int width = image.indices.width;
        std::vector<std::uint8_t> columns(image.indices.pixel(0, y0), image.indices.pixel(0, y0) + width);
        const auto take = [&](std::uint8_t& best, std::uint8_t i) { best = colorful[i] > colorful[best] ? i : best; };
        for (int y = y0 + 1; y < y1; ++y) {
            const std::uint8_t* in = image.indices.pixel(0, y);
            for (int x = 0; x < width; ++x) take(columns[std::size_t(x)], in[x]);
        }
        std::vector<Rgb8> colors;
        for (int x0 = 0; x0 < width; x0 += scale.shrink) {
            std::uint8_t best = columns[std::size_t(x0)];
            for (int x = x0; x < std::min(x0 + scale.shrink, width); ++x) take(best, columns[std::size_t(x)]);
            colors.push_back(image.palette[best]);
        }
        place_row(colors, scale, left, top, int(row), page);
    });
}

}  // namespace

Image8 displayed(const AnyImage& image) {
    const Display display(image, white);
    Image8 out(display.width(), display.height(), 3);
    tiles::parallel_for(std::size_t(out.height), [&](std::size_t y) {
        std::vector<std::uint8_t> space;
        std::copy_n(displayed_row(image, display, int(y), space), 3 * std::size_t(out.width), out.pixel(0, int(y)));
    });
    return out;
}

IndexedImage indexed_difference(const AnyImage& expected, const Diff& diff) {
    const Display display(expected, white);
    IndexedImage out = indexed(display.width(), display.height(), difference_palette());
    const int bits = diff_steps::shape_of(expected).bits, width = display.width();
    const float peak = bits == 8 ? 255.0f : bits == 16 ? 65535.0f : 1.0f;
    std::vector<std::uint8_t> by_delta;  // for whole numbers; 0: a grey
    for (int delta = 0; bits != 32 && delta <= int(peak); ++delta)
        by_delta.push_back(float(delta) > diff.allowed_delta ? failing(float(delta) / peak)
                           : delta > 0                       ? std::uint8_t(tolerated_index)
                                                             : std::uint8_t(0));
    tiles::parallel_for(std::size_t(display.height()), [&](std::size_t row) {
        const int y = int(row);
        std::uint8_t* const pixel = out.indices.pixel(0, y);
        const float* const deltas = diff.deltas.empty() ? nullptr : diff.deltas.pixel(0, y);
        const auto color_of = [&](float delta) {
            // Beyond the peak where the other picture has more bits.
            if (bits != 32) return by_delta[std::size_t(std::int32_t(min(delta, peak)))];
            if (delta > diff.allowed_delta) return failing(delta / peak);
            return std::uint8_t(delta > 0 ? tolerated_index : 0);
        };
        constexpr int block = 256;
        for (int x0 = 0; x0 < width; x0 += block) {
            const int count = std::min(block, width - x0);
            std::uint8_t colors[block] = {};
            for (int i = 0; deltas != nullptr && i < count; ++i) colors[i] = color_of(deltas[x0 + i]);
            std::uint8_t* const to = pixel + x0;
            if (std::memchr(colors, 0, std::size_t(count)) == nullptr) {
                std::memcpy(to, colors, std::size_t(count));
                continue;
            }
            float luma[block];
            display.luma_row(x0, y, count, luma);
            std::uint8_t greys[block];
            for (int i = 0; i < count; ++i)
                greys[i] = std::uint8_t(int((0.72f + 0.25f * luma[i]) * 255.0f + 0.5f) - darkest_grey);
            for (int i = 0; i < count; ++i) to[i] = colors[i] != 0 ? colors[i] : greys[i];
        }
        if (diff.compared.empty()) return;
        const std::uint8_t* counts = diff.compared.pixel(0, y);
        for (int x = 0; x < width; ++x)
            if (counts[x] == 0) pixel[x] = std::uint8_t(pixel[x] - ((x + y) % 8 < 4 ? 60 : 30));  // equal there: a grey
    });
    return out;
}

Image8 difference_picture(const AnyImage& expected, const Diff& diff) {
    const IndexedImage indexed = indexed_difference(expected, diff);
    Image8 out(indexed.indices.width, indexed.indices.height, 3);
    for (std::size_t i = 0; i < indexed.indices.samples.size(); ++i)
        std::copy_n(indexed.palette[indexed.indices.samples[i]].begin(), 3,
                    out.samples.begin() + std::ptrdiff_t(3 * i));
    return out;
}

IndexedImage flip_picture(Diff&& diff) {
    IndexedImage out;
    for (int step = 0; step <= flip::most_step; ++step) {
        const std::uint8_t grey = to_byte(float(step) / float(flip::most_step));
        out.palette.push_back({grey, grey, grey});
    }
    if (!diff.flip_steps.empty()) {
        out.indices = std::move(diff.flip_steps);
        return out;
    }
    const ImageF& map = diff.flip_map;
    out = indexed(map.width, map.height, std::move(out.palette));
    tiles::parallel_for(std::size_t(map.height), [&](std::size_t y) {
        flip::steps_of_errors(map.pixel(0, int(y)), map.width, out.indices.pixel(0, int(y)));
    });
    return out;
}

Image8 triptych(const AnyImage& expected, const AnyImage& actual, const IndexedImage& difference) {
    const diff_steps::Shape e = diff_steps::shape_of(expected), a = diff_steps::shape_of(actual);
    const int larger = std::max({e.width, e.height, a.width, a.height});
    const Scale e_scale(e.width, e.height, larger), a_scale(a.width, a.height, larger);
    constexpr int gap = 8;
    const int panels = difference.empty() ? 2 : 3;
    const int width = e_scale.width + a_scale.width + (panels == 3 ? e_scale.width : 0) + (panels + 1) * gap;
    Image8 page(width, std::max(e_scale.height, a_scale.height) + 2 * gap, 3, 120);
    place(expected, e_scale, gap, gap, page);
    place(actual, a_scale, 2 * gap + e_scale.width, gap, page);
    if (panels == 3) place(difference, e_scale, 3 * gap + e_scale.width + a_scale.width, gap, page);
    return page;
}

}  // namespace raster
