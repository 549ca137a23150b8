// explain.cpp: clusters of differing pixels, and the cause of each from the history of one pixel.
#include <raster/trace/explain.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include <raster/trace/history_text.h>

namespace raster {
namespace {

using Rgb = std::array<std::uint8_t, 3>;

/// Red, green and blue of a pixel in 8 bits, as stored: no transfer curve.
Rgb rgb_at(const AnyImage& any, int x, int y) {
    return std::visit(
        [&](const auto& image) {
            const auto* pixel = image.pixel(x, y);
            Rgb rgb;
            for (int c = 0; c < 3; ++c) {
                const auto sample = pixel[image.channels < 3 ? 0 : c];
                using T = std::remove_cv_t<decltype(sample)>;
                if constexpr (std::is_floating_point_v<T>) {
                    rgb[std::size_t(c)] = std::uint8_t(to_unorm8(sample));
                } else {
                    rgb[std::size_t(c)] = std::uint8_t(sizeof(T) == 1 ? sample : (sample + 128) / 257);
                }
            }
            return rgb;
        },
        any);
}

Rgb rgb_of(const glm::vec4& color) {
    const auto c = std::uint32_t(pack_rgba8(color));
    return {std::uint8_t(c), std::uint8_t(c >> 8), std::uint8_t(c >> 16)};
}

int distance(const Rgb& a, const Rgb& b) {
    int most = 0;
    for (std::size_t i = 0; i < 3; ++i) most = std::max(most, std::abs(int(a[i]) - int(b[i])));
    return most;
}

/// How far the centre is from edge i's line, in subpixels; positive inside.
double subpixels_inside(const HistoryEntry& e, int i) {
    const Edge<float>& edge = e.setup()->setup.edges[std::size_t(i)];
    const double length = std::hypot(double(edge.step_x), double(edge.step_y));
    return double(e.pixel()->coverage.edges[std::size_t(i)]) / std::max(length, 1.0);
}

/// The model without one triangle. It stays in its place as a point, so that all others keep their numbers.
Model without(const Model& model, std::int64_t number) {
    Model result = model;
    const std::size_t first = std::size_t(3 * number);
    result.indices[first + 1] = result.indices[first + 2] = result.indices[first];
    return result;
}

class Explainer {
public:
    Explainer(Target& target, const Model& model, const CameraMatrices& camera, const RenderOptions& options)
        : target_(target), model_(model), camera_(camera), options_(options) {}

    /// Explains pixel (e.x, e.y), whose colours are known.
    void explain(DiffExplanation& e) {
        e.history = history_of(model_, e.x, e.y);
        const Rgb ours = rgb_of(e.history.color);
        // Each is held to be ours when it is nearer, and near enough for another renderer's rounding.
        const int to_expected = distance(ours, e.expected), to_actual = distance(ours, e.actual);
        const bool expected_is_ours = to_expected <= to_actual;
        const bool one_is_ours = std::min(to_expected, to_actual) <= 2;
        const Rgb& other = expected_is_ours ? e.actual : e.expected;
        const char* other_name = expected_is_ours ? "the actual picture" : "the expected picture";
        const auto conclude = [&](DiffCause cause, const std::string& reason) {
            e.cause = cause;
            e.reason = reason;
        };

        const HistoryEntry* winner = e.history.decisive ? &e.history.entries[*e.history.decisive] : nullptr;
        if (winner && winner->fate != PixelFate::wrote) winner = nullptr;
        const std::string tie = edge_tie(e.history);
        const bool only_rounding = distance(e.expected, e.actual) <= 1;
        if (only_rounding && tie.empty())
            return conclude(DiffCause::rounding, "the colours differ by one step" + in(winner));
        if (!tie.empty()) return conclude(DiffCause::edge_tie, tie);
        if (const std::string depth = depth_tie(e.history); !depth.empty())
            return conclude(DiffCause::depth_tie, depth);
        if (!one_is_ours) return conclude(DiffCause::other_scene, "neither picture is what these flags draw here");
        if (winner) {
            const PixelHistory left = history_of(without(model_, winner->triangle.number), e.x, e.y);
            if (distance(rgb_of(left.color), other) <= 2 && distance(rgb_of(left.color), ours) > 2)
                return conclude(DiffCause::missing_triangle,
                                std::string(other_name) + " shows what lies below " + winner->name());
        } else {
            for (const HistoryEntry& entry : e.history.entries)
                if (entry.fate == PixelFate::culled || entry.fate == PixelFate::clipped)
                    return conclude(DiffCause::missing_triangle, std::string(other_name) + " shows something where " +
                                                                     entry.name() + " was " + to_string(entry.fate));
        }
        conclude(DiffCause::shading, winner ? winner->name() + " has another colour in " + other_name
                                            : std::string(other_name) + " has another background");
    }

private:
    static std::string in(const HistoryEntry* winner) { return winner ? " on " + winner->name() : ""; }

    PixelHistory history_of(const Model& model, int x, int y) {
        return pixel_history(target_, model, camera_, options_, x, y, {1.0, false});
    }

    /// A centre on an edge, or so near that other rounding of the corners puts it on the other side: of what is seen,
    /// or of what nearly covers the pixel.
    static std::string edge_tie(const PixelHistory& history) {
        for (const HistoryEntry& e : history.entries) {
            if (!e.pixel() || !e.setup()) continue;
            const bool inside_enough = e.pixel()->coverage.covered ? e.visible : e.distance * subpixels <= 1.5;
            if (!inside_enough) continue;
            for (int i = 0; i < 3; ++i) {
                const double inside = subpixels_inside(e, i);
                if (std::abs(inside) > 1.0) continue;
                const Edge<float>& edge = e.setup()->setup.edges[std::size_t(i)];
                const std::string which = std::string(" ") + to_string(side_of(edge)) + " edge of " + e.name();
                if (e.is_tie(i))
                    return "the centre lies exactly on the" + which + ", which " +
                           (edge.inclusive ? "owns it" : "does not own it");
                return "the centre lies within a subpixel of the" + which;
            }
        }
        return "";
    }

    /// Two covered triangles whose depths are two steps apart or less, of which one is seen.
    static std::string depth_tie(const PixelHistory& history) {
        if (!history.decisive) return "";
        const HistoryEntry& winner = history.entries[*history.decisive];
        if (!winner.pixel() || !winner.pixel()->depth) return "";
        for (const HistoryEntry& e : history.entries) {
            if (&e == &winner || !e.pixel() || !e.pixel()->depth) continue;
            const auto a = std::int64_t(winner.pixel()->depth->incoming), b = std::int64_t(e.pixel()->depth->incoming);
            if (std::abs(a - b) <= 2)
                return winner.name() + " and " + e.name() +
                       (a == b ? " have the same depth"
                               : " are " + std::to_string(std::abs(a - b)) + " depth steps apart");
        }
        return "";
    }

    Target& target_;
    const Model& model_;
    const CameraMatrices& camera_;
    const RenderOptions& options_;
};

}  // namespace

const char* to_string(DiffCause cause) {
    switch (cause) {
        case DiffCause::edge_tie: return "edge tie";
        case DiffCause::depth_tie: return "depth tie";
        case DiffCause::missing_triangle: return "missing triangle";
        case DiffCause::rounding: return "rounding of one step";
        case DiffCause::shading: return "shading";
        case DiffCause::other_scene: break;
    }
    return "another scene";
}

std::vector<DiffCluster> diff_clusters(const Diff& diff) {
    std::vector<DiffCluster> clusters;
    if (!diff.figures || diff.figures->differing == 0) return clusters;
    const ImageF& deltas = diff.deltas;
    const float limit = diff.figures->failing > 0 ? diff.allowed_delta : 0.0f;
    std::vector<std::uint8_t> seen(deltas.samples.size());
    const auto place = [&](int x, int y) { return std::size_t(y) * std::size_t(deltas.width) + std::size_t(x); };
    std::vector<std::pair<int, int>> open;
    std::vector<std::size_t> places;
    for (int y0 = 0; y0 < deltas.height; ++y0)
        for (int x0 = 0; x0 < deltas.width; ++x0) {
            if (seen[place(x0, y0)] || !(deltas.samples[place(x0, y0)] > limit)) continue;
            DiffCluster cluster;
            int x1 = x0, x2 = x0, y2 = y0;
            places.clear();
            seen[place(x0, y0)] = 1;
            open.assign(1, {x0, y0});
            while (!open.empty()) {
                const auto [x, y] = open.back();
                open.pop_back();
                ++cluster.pixels;
                places.push_back(place(x, y));
                x1 = std::min(x1, x), x2 = std::max(x2, x), y2 = std::max(y2, y);
                const float delta = deltas.samples[place(x, y)];
                const bool comes_first = y < cluster.y || (y == cluster.y && x < cluster.x);
                if (delta > cluster.max_delta || (delta == cluster.max_delta && comes_first))
                    cluster.max_delta = delta, cluster.x = x, cluster.y = y;
                for (int v = std::max(y - 1, 0); v <= std::min(y + 1, deltas.height - 1); ++v)
                    for (int u = std::max(x - 1, 0); u <= std::min(x + 1, deltas.width - 1); ++u) {
                        if (seen[place(u, v)] || !(deltas.samples[place(u, v)] > limit)) continue;
                        seen[place(u, v)] = 1;
                        open.emplace_back(u, v);
                    }
            }
            cluster.box = {x1, y0, x2 - x1 + 1, y2 - y0 + 1};
            cluster.samples = {{cluster.x, cluster.y}};
            std::sort(places.begin(), places.end());
            for (const std::size_t i : {places.size() / 3, places.size() * 2 / 3}) {
                const glm::ivec2 pixel(int(places[i]) % deltas.width, int(places[i]) / deltas.width);
                if (std::ranges::find(cluster.samples, pixel) == cluster.samples.end())
                    cluster.samples.push_back(pixel);
            }
            clusters.push_back(cluster);
        }
    std::stable_sort(clusters.begin(), clusters.end(),
                     [](const DiffCluster& a, const DiffCluster& b) { return a.pixels > b.pixels; });
    return clusters;
}

Result<std::vector<DiffExplanation>> explain_diff(Target& target, const AnyImage& expected, const AnyImage& actual,
                                                  const Diff& diff, const Model& model, const CameraMatrices& camera,
                                                  const RenderOptions& options, std::size_t most) {
    for (const AnyImage* image : {&expected, &actual}) {
        const auto [width, height] = std::visit([](const auto& i) { return std::pair(i.width, i.height); }, *image);
        if (width != target.width() || height != target.height())
            return Error{ErrorKind::usage, "the pictures have another size than the one that is drawn"};
    }
    std::vector<DiffExplanation> explanations;
    Explainer explainer(target, model, camera, options);
    for (const DiffCluster& cluster : diff_clusters(diff)) {
        if (explanations.size() == most) break;
        std::vector<DiffExplanation> samples;
        for (const glm::ivec2 pixel : cluster.samples) {
            DiffExplanation& e = samples.emplace_back();
            e.cluster = cluster;
            e.x = pixel.x, e.y = pixel.y;
            e.expected = rgb_at(expected, e.x, e.y);
            e.actual = rgb_at(actual, e.x, e.y);
            explainer.explain(e);
        }
        const auto alike = [&](const DiffExplanation& e) {
            return std::ranges::count_if(samples, [&](const DiffExplanation& o) { return o.cause == e.cause; });
        };
        explanations.push_back(std::move(*std::ranges::max_element(samples, {}, alike)));
    }
    return explanations;
}

}  // namespace raster
