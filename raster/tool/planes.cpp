// planes.cpp: from float planes to pictures one can look at.
#include "planes.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <raster/shading/uniforms.h>

namespace raster::tool {

const char* const planes_help =
    "Also writes these, beside the picture as NAME.PLANE.png, or where .pfm is added to a word, as NAME.PLANE.pfm with"
    " the exact floats: a list of\n"
    "depth: nearest white, farthest dark, background black; floats: window depth, 0 near to 1 far and background\n"
    "normal: as lit, in world space, -1..1 as 0..255; floats: X,Y,Z\n"
    "triangle: a colour each; floats: its number from 1, 0 is the background\n"
    "overdraw: how often a pixel was written, 0 black, then blue to orange, 8 and more white; floats: the count\n"
    "ambient, diffuse, specular, emission: the terms that add up to the colour; floats: not clamped\n"
    "Example: --aov depth,normal.pfm";

namespace {

/// Where a plane's values are found among the extra channels of a target, and how many they are.
struct PlaneKind {
    std::string_view name;
    int first;  ///< extra channel; -1 for what is no extra channel
    int count;
};
constexpr std::array<PlaneKind, 8> kinds = {{{"depth", -1, 1},
                                             {"normal", shaded_plane::normal, 3},
                                             {"triangle", shaded_plane::triangle, 1},
                                             {"overdraw", -1, 1},
                                             {"ambient", shaded_plane::ambient, 3},
                                             {"diffuse", shaded_plane::diffuse, 3},
                                             {"specular", shaded_plane::specular, 3},
                                             {"emission", shaded_plane::emission, 3}}};

const PlaneKind& kind_of(const PlaneChoice& plane) {
    return *std::ranges::find_if(kinds, [&](const PlaneKind& kind) { return kind.name == plane.name; });
}

std::uint8_t to_byte(float value) { return std::uint8_t(std::nearbyint(std::clamp(value, 0.0f, 1.0f) * 255.0f)); }

/// Distance from the eye along the view direction, for matrices as `perspective` makes them; else window depth.
float eye_distance(const glm::mat4& clip_from_eye, float depth) {
    const float ndc = 2.0f * depth - 1.0f;
    if (clip_from_eye[2][3] != -1.0f || clip_from_eye[3][3] != 0.0f) return depth;
    return clip_from_eye[3][2] / (ndc + clip_from_eye[2][2]);
}

Image8 depth_picture(const ImageF& depth, const glm::mat4& clip_from_eye) {
    Image8 image(depth.width, depth.height, 1);
    const auto drawn = [](float d) { return d < 1.0f; };
    float nearest = HUGE_VALF, farthest = -HUGE_VALF;
    for (const float d : depth.samples) {
        if (!drawn(d)) continue;
        nearest = std::min(nearest, d);
        farthest = std::max(farthest, d);
    }
    const float low = eye_distance(clip_from_eye, nearest), high = eye_distance(clip_from_eye, farthest);
    const float range = high > low ? high - low : 1.0f;
    for (std::size_t i = 0; i < image.samples.size(); ++i) {
        const float d = depth.samples[i];
        if (drawn(d)) image.samples[i] = to_byte(1.0f - 0.85f * (eye_distance(clip_from_eye, d) - low) / range);
    }
    return image;
}

/// A colour for a number: neighbours differ, none is near black.
std::array<std::uint8_t, 3> color_of(std::uint32_t number) {
    if (number == 0) return {0, 0, 0};
    std::uint32_t h = number * 0x9e3779b1u;
    h = (h ^ (h >> 15)) * 0x85ebca6bu;
    h ^= h >> 13;
    const auto channel = [&](int shift) { return std::uint8_t(64 + ((h >> shift & 255) * 3 >> 2)); };
    return {channel(0), channel(8), channel(16)};
}

/// From blue to orange to white: told apart by those who see no red or green, and by brightness alone.
constexpr std::array<std::array<std::uint8_t, 3>, 9> overdraw_colors = {{{0, 0, 0},
                                                                         {14, 38, 92},
                                                                         {26, 71, 140},
                                                                         {50, 110, 180},
                                                                         {110, 140, 170},
                                                                         {190, 140, 90},
                                                                         {235, 150, 50},
                                                                         {255, 195, 120},
                                                                         {255, 255, 255}}};

}  // namespace

Result<std::vector<PlaneChoice>> parse_planes(std::string_view text) {
    std::vector<PlaneChoice> planes;
    std::vector<std::string> names;
    std::string known;
    for (const PlaneKind& kind : kinds) {
        names.emplace_back(kind.name);
        known += (known.empty() ? "" : ", ") + std::string(kind.name);
    }
    for (const std::string_view word : split(text, ',')) {
        const std::size_t dot = word.find('.');
        const std::string name(word.substr(0, dot)), extension(dot == std::string_view::npos ? "" : word.substr(dot));
        if (std::ranges::find(names, name) == names.end())
            return Error{ErrorKind::usage, in_quotes(word) + " is none of " + known + did_you_mean(name, names)};
        if (!extension.empty() && extension != ".png" && extension != ".pfm")
            return Error{ErrorKind::usage, in_quotes(word) + ": planes are written as .png or .pfm"};
        PlaneChoice plane{name, extension == ".pfm"};
        const auto same = [&](const PlaneChoice& p) { return p.suffix() == plane.suffix(); };
        if (std::ranges::none_of(planes, same)) planes.push_back(std::move(plane));
    }
    return planes;
}

PlaneRenderer::PlaneRenderer(const Model& model, const View& view, const RenderOptions& options)
    : model_(model), view_(view), options_(options) {}

/// A target of its own, so that the picture is the same whether planes are asked for or not.
const Target& PlaneRenderer::terms() {
    if (!terms_) {
        terms_.emplace(view_.size.width, view_.size.height, ColorFormat::rgba8, DepthFormat::unorm24,
                       shaded_plane::count);
        render(*terms_, model_, view_.matrices, options_);
    }
    return *terms_;
}

const Target& PlaneRenderer::overdraw() {
    if (!overdraw_) {
        overdraw_.emplace(view_.size.width, view_.size.height, ColorFormat::rgba_float);
        render_overdraw(*overdraw_, model_, view_.matrices, options_);
    }
    return *overdraw_;
}

ImageF PlaneRenderer::floats(const PlaneChoice& plane, const Target& picture) {
    const PlaneKind& kind = kind_of(plane);
    if (plane.name == "depth") return picture.depth_image();
    ImageF image(view_.size.width, view_.size.height, kind.count);
    if (plane.name == "overdraw") {
        const std::vector<glm::vec4>& counts = overdraw().color_float();
        std::ranges::transform(counts, image.samples.begin(), [](const glm::vec4& c) { return c.x; });
        return image;
    }
    for (int channel = 0; channel < kind.count; ++channel) {
        const std::vector<float>& values = terms().extra(kind.first + channel);
        for (std::size_t i = 0; i < values.size(); ++i)
            image.samples[i * std::size_t(kind.count) + std::size_t(channel)] = values[i];
    }
    return image;
}

Image8 PlaneRenderer::colors(const PlaneChoice& plane, const Target& picture) {
    const ImageF values = floats(plane, picture);
    if (plane.name == "depth") return depth_picture(values, view_.matrices.clip_from_eye);
    Image8 image(values.width, values.height, 3);
    if (plane.name == "triangle" || plane.name == "overdraw") {
        const bool counts = plane.name == "overdraw";
        for (std::size_t i = 0; i < values.samples.size(); ++i) {
            const auto number = std::uint32_t(values.samples[i]);
            const auto color = counts ? overdraw_colors[std::min<std::size_t>(number, 8)] : color_of(number);
            std::ranges::copy(color, image.samples.begin() + std::ptrdiff_t(3 * i));
        }
        return image;
    }
    const bool normal = plane.name == "normal";
    for (std::size_t i = 0; i < values.samples.size(); i += 3) {
        const float* v = &values.samples[i];
        const bool background = v[0] == 0 && v[1] == 0 && v[2] == 0;
        for (std::size_t c = 0; c < 3; ++c)
            image.samples[i + c] = normal && !background ? to_byte(v[c] * 0.5f + 0.5f) : to_byte(v[c]);
    }
    return image;
}

}  // namespace raster::tool
