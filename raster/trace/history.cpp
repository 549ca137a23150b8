// history.cpp: which triangles belong to a pixel's history, and what its verdict is.
#include <raster/trace/history.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include <raster/stages/coverage.h>

namespace raster {
namespace {

/// The distance of a point from the segment a b.
double segment_distance(glm::dvec2 p, glm::dvec2 a, glm::dvec2 b) {
    const glm::dvec2 along = b - a;
    const double square = glm::dot(along, along);
    const double t = square > 0 ? std::clamp(glm::dot(p - a, along) / square, 0.0, 1.0) : 0.0;
    return glm::length(p - (a + t * along));
}

/// Places of a history in exact subpixels, whose centres are the multiples of 256.
class PixelPlace {
public:
    PixelPlace(int x, int y, int width, int height) : x_(x), y_(y), width_(width), height_(height) {}

    /// From the centre to the nearest point of a triangle's outline, in pixels.
    double distance_to(const std::array<SubpixelVertex<float>, 3>& v) const {
        const glm::dvec2 p(double(x_) * subpixels, double(y_) * subpixels);
        double nearest = std::numeric_limits<double>::infinity();
        for (std::size_t i = 0; i < 3; ++i) {
            const auto &a = v[i], &b = v[(i + 1) % 3];
            nearest = std::min(nearest, segment_distance(p, {a.x, a.y}, {b.x, b.y}));
        }
        return nearest / subpixels;
    }

    /// Whether a piece that was not set up would have covered the pixel.
    bool would_cover(const ProjectEvent& e, std::int64_t area, FillRule rule) const {
        const TriangleSetup setup = make_setup(e.window, e.subpixel, area, rule, width_, height_);
        return std::ranges::all_of(setup.edges,
                                   [&](const Edge<float>& edge) { return is_inside(edge, edge_at(edge, x_, y_)); });
    }

    /// The planes beyond which a triangle lies at this pixel; nothing where it is not in front of the eye there, or
    /// inside the volume. In homogeneous coordinates (Olano and Greer 1997), since what is clipped away was never
    /// divided by w.
    std::vector<ClipPlane> cutting_planes(const std::array<glm::vec4, 3>& clip, const State& state) const {
        const Viewport v = effective_viewport(state.viewport, width_, height_);
        const glm::dvec3 p((x_ + 0.5 - v.x) / v.width * 2 - 1, 1 - (y_ + 0.5 - v.y) / v.height * 2, 1);
        std::array<glm::dvec3, 3> c;
        for (std::size_t i = 0; i < 3; ++i) c[i] = {clip[i].x, clip[i].y, clip[i].w};
        const double all = glm::dot(c[0], glm::cross(c[1], c[2]));
        if (all == 0 || !std::isfinite(all)) return {};
        glm::dvec4 there(0);
        for (std::size_t i = 0; i < 3; ++i) {
            const double part = glm::dot(p, glm::cross(c[(i + 1) % 3], c[(i + 2) % 3])) / all;
            if (!(part >= 0)) return {};
            there += part * glm::dvec4(clip[i]);
        }
        std::vector<ClipPlane> planes;
        for (const ClipPlane plane : {ClipPlane::near, ClipPlane::far})
            if (glm::dot(glm::dvec4(clip_planes[std::size_t(plane)]), there) < 0) planes.push_back(plane);
        for (std::size_t i = 0; i < std::min(state.clip_planes.size(), std::size_t(max_user_planes)); ++i)
            if (glm::dot(glm::dvec4(state.clip_planes[i]), there) < 0)
                planes.push_back(ClipPlane(clip_plane_count + int(i)));
        return planes;
    }

private:
    int x_, y_, width_, height_;
};

/// Listens to a whole picture and keeps what belongs to one pixel.
class HistoryMaker {
public:
    HistoryMaker(PixelHistory& history, const HistoryOptions& options)
        : history_(history), options_(options), place_(history.x, history.y, history.width, history.height) {}

    void see(const RecordedDraw& draw, RecordedTriangle& t) {
        if (history_.draws.size() <= std::size_t(draw.draw)) history_.draws.resize(std::size_t(draw.draw) + 1);
        history_.draws[std::size_t(draw.draw)] = draw;
        if (!t.clip) return;
        if (t.clip->verdict == ClipEvent::Verdict::outside || t.clip->verdict == ClipEvent::Verdict::clipped)
            see_clipped(draw, t);
        const bool covered = std::ranges::any_of(t.pieces, [](const RecordedPiece& piece) {
            return !piece.pixels.empty() && piece.pixels[0].coverage.covered;
        });
        for (const RecordedPiece& piece : t.pieces) see_piece(draw, t, piece, covered);
    }

private:
    void see_clipped(const RecordedDraw& draw, const RecordedTriangle& t) {
        std::vector<ClipPlane> planes = place_.cutting_planes(t.clip->clip, draw.state);
        if (planes.empty()) return;
        HistoryEntry& entry = add(t, nullptr, PixelFate::clipped, 0);
        entry.cut_by = std::move(planes);
    }

    void see_piece(const RecordedDraw& draw, const RecordedTriangle& t, const RecordedPiece& piece, bool others_cover) {
        const CullEvent& cull = *piece.cull;
        if (cull.verdict == CullEvent::Verdict::culled) {
            if (place_.would_cover(piece.project, cull.area, draw.state.fill_rule))
                add(t, &piece, PixelFate::culled, 0);
            return;
        }
        if (!piece.pixels.empty() && piece.pixels[0].coverage.covered) {
            const std::optional<DepthEvent>& depth = piece.pixels[0].depth;
            add(t, &piece, depth && depth->passed ? PixelFate::wrote : PixelFate::lost, 0);
            return;
        }
        if (others_cover) return;
        const double distance = place_.distance_to(piece.project.subpixel);
        const bool drawn = cull.verdict == CullEvent::Verdict::kept;
        if (distance <= options_.near_pixels) add(t, &piece, drawn ? PixelFate::near : PixelFate::zero_area, distance);
        if (drawn && !(history_.nearest && history_.nearest->distance <= distance))
            history_.nearest = make(t, &piece, PixelFate::near, distance);
    }

    static HistoryEntry make(const RecordedTriangle& t, const RecordedPiece* piece, PixelFate fate, double distance) {
        HistoryEntry entry;
        entry.fate = fate;
        entry.distance = distance;
        entry.triangle.draw = t.draw;
        entry.triangle.triangle = t.triangle;
        entry.triangle.number = t.number;
        entry.triangle.corners = t.corners;
        entry.triangle.clip = t.clip;
        entry.triangle.cuts = t.cuts;
        if (piece) entry.triangle.pieces.push_back(*piece);
        return entry;
    }
    HistoryEntry& add(const RecordedTriangle& t, const RecordedPiece* piece, PixelFate fate, double distance) {
        return history_.entries.emplace_back(make(t, piece, fate, distance));
    }

    PixelHistory& history_;
    const HistoryOptions& options_;
    PixelPlace place_;
};

bool has_nan(const HistoryEntry& entry) {
    const RecordedPixel& pixel = *entry.pixel();
    if (pixel.depth && std::isnan(pixel.depth->z)) return true;
    return pixel.outputs && std::any_of(pixel.outputs->begin(), pixel.outputs->begin() + 4,
                                        [](float value) { return std::isnan(value); });
}

void judge(PixelHistory& history) {
    std::vector<HistoryEntry>& entries = history.entries;
    bool hidden = false;
    for (std::size_t i = entries.size(); i-- > 0;) {
        if (entries[i].fate != PixelFate::wrote) continue;
        entries[i].visible = !hidden;
        hidden = hidden || history.draw_of(entries[i]).state.blend == Blend::off;
    }
    const auto last = [&](PixelFate fate) -> std::optional<std::size_t> {
        for (std::size_t i = entries.size(); i-- > 0;)
            if (entries[i].fate == fate) return i;
        return {};
    };
    for (const auto& [fate, verdict] : {std::pair(PixelFate::wrote, PixelVerdict::won),
                                        {PixelFate::lost, PixelVerdict::all_rejected},
                                        {PixelFate::clipped, PixelVerdict::clipped},
                                        {PixelFate::culled, PixelVerdict::culled},
                                        {PixelFate::near, PixelVerdict::never_covered}}) {
        history.decisive = last(fate);
        if (!history.decisive) continue;
        history.verdict = verdict;
        break;
    }
    if (!history.decisive) return;
    if (history.verdict == PixelVerdict::never_covered) {
        const auto nearest = std::ranges::min_element(entries, {}, [](const HistoryEntry& e) {
            return e.fate == PixelFate::near ? e.distance : std::numeric_limits<double>::infinity();
        });
        history.decisive = std::size_t(nearest - entries.begin());
    }
    // What is see-through takes in all that lies below it.
    for (std::size_t i = 0; i < entries.size(); ++i) {
        const HistoryEntry& e = entries[i];
        const bool counts = e.visible || (history.verdict == PixelVerdict::all_rejected && e.fate == PixelFate::lost);
        if (!counts || !has_nan(e)) continue;
        history.verdict = PixelVerdict::nan;
        history.decisive = i;
    }
}

/// The corners of a piece, from a run whose varyings begin with the light of both sides: front diffuse, front specular,
/// back diffuse, back specular.
std::vector<CornerLight> corners_of(const RecordedTriangle& t, const RecordedPiece& piece, float x, float y) {
    const TriangleSetup& setup = piece.setup->setup;
    const std::array<int, 3> fan = clip_fan(piece.project.piece);
    const float w = 1.0f / value_at(piece.setup->oow, x, y);
    std::vector<CornerLight> corners(3);
    for (std::size_t i = 0; i < 3; ++i) {
        const auto corner = std::size_t(setup.order[i]);
        std::array<float, 3> one{};
        one[i] = piece.project.window[corner].oow;
        const std::vector<float>& v =
            t.cuts.empty() ? t.corners[corner].varyings : t.cuts.back().after[std::size_t(fan[corner])].varyings;
        const std::size_t side = piece.cull->front_facing ? 0 : 6;
        corners[corner] = {{v[side], v[side + 1], v[side + 2]},
                           {v[side + 3], v[side + 4], v[side + 5]},
                           value_at(make_plane(setup.basis, one[0], one[1], one[2]), x, y) * w};
    }
    return corners;
}

/// Runs the picture with the planes' shaders, and takes the terms of what was written.
void add_terms(PixelHistory& history, const Model& model, const CameraMatrices& camera, const RenderOptions& options) {
    Target target(history.width, history.height, history.color_format, history.depth_format, 1);
    const WatchedPixels here{{history.x, history.y, history.x, history.y}};
    RecordChoice choice{here, {}};
    for (const HistoryEntry& e : history.entries)
        if (e.fate == PixelFate::wrote) choice.triangles.push_back(e.triangle.number);
    if (choice.triangles.empty()) return;
    Recorder recorder(std::move(choice), [&](const RecordedDraw& draw, const RecordedTriangle& t) {
        for (const RecordedPiece& piece : t.pieces) {
            if (piece.pixels.empty() || !piece.pixels[0].outputs) continue;
            const std::vector<float>& o = *piece.pixels[0].outputs;
            const auto three = [&](int plane) {
                const std::size_t i = std::size_t(4 + plane);
                return glm::vec3(o[i], o[i + 1], o[i + 2]);
            };
            for (HistoryEntry& e : history.entries) {
                if (e.fate != PixelFate::wrote || e.triangle.draw != t.draw || e.triangle.triangle != t.triangle ||
                    e.piece() != piece.project.piece)
                    continue;
                e.terms = {three(shaded_plane::normal),   three(shaded_plane::ambient),
                           three(shaded_plane::diffuse),  three(shaded_plane::specular),
                           three(shaded_plane::emission), {o[0], o[1], o[2], o[3]}};
                if (draw.frequency == ShadingFrequency::gouraud)
                    e.corners = corners_of(t, piece, float(history.x), float(history.y));
            }
        }
    });
    render_observed(target, model, camera, options, recorder);
    recorder.finish();
}

}  // namespace

int HistoryEntry::rejecting_edge() const {
    if (!pixel() || !setup() || pixel()->coverage.covered) return -1;
    int worst = -1;
    double farthest = -1;
    for (int i = 0; i < 3; ++i) {
        const Edge<float>& edge = setup()->setup.edges[std::size_t(i)];
        const std::int64_t value = pixel()->coverage.edges[std::size_t(i)];
        if (is_inside(edge, value)) continue;
        const double outside = -double(value) / std::hypot(double(edge.step_x), double(edge.step_y));
        if (outside > farthest) worst = i, farthest = outside;
    }
    return worst;
}

int PixelHistory::count(PixelFate fate) const {
    return int(std::ranges::count_if(entries, [&](const HistoryEntry& e) { return e.fate == fate; }));
}

EdgeSide side_of(const Edge<float>& edge) {
    // As in make_edge: the triangle runs counter-clockwise on the picture.
    if (edge.step_x != 0) return edge.step_x > 0 ? EdgeSide::left : EdgeSide::right;
    return edge.step_y < 0 ? EdgeSide::bottom : EdgeSide::top;
}

const char* to_string(PixelVerdict verdict) {
    switch (verdict) {
        case PixelVerdict::won: return "WON";
        case PixelVerdict::all_rejected: return "ALL_REJECTED";
        case PixelVerdict::never_covered: return "NEVER_COVERED";
        case PixelVerdict::clipped: return "CLIPPED";
        case PixelVerdict::culled: return "CULLED";
        case PixelVerdict::background: return "BACKGROUND";
        case PixelVerdict::nan: break;
    }
    return "NAN";
}

const char* to_string(EdgeSide side) {
    switch (side) {
        case EdgeSide::left: return "left";
        case EdgeSide::right: return "right";
        case EdgeSide::top: return "top";
        case EdgeSide::bottom: break;
    }
    return "bottom";
}

const char* to_string(PixelFate fate) {
    switch (fate) {
        case PixelFate::wrote: return "wrote";
        case PixelFate::lost: return "lost";
        case PixelFate::near: return "near";
        case PixelFate::clipped: return "clipped";
        case PixelFate::culled: return "culled";
        case PixelFate::zero_area: break;
    }
    return "zero_area";
}

PixelHistory pixel_history(Target& target, const Model& model, const CameraMatrices& camera,
                           const RenderOptions& options, int x, int y, const HistoryOptions& history_options) {
    PixelHistory history;
    history.x = x, history.y = y;
    history.width = target.width(), history.height = target.height();
    history.color_format = target.color_format();
    history.depth_format = target.depth_format();
    target.clear(options.background);
    history.color_before = target.color(x, y);
    history.depth_before = target.depth()[target.index(x, y)];

    HistoryMaker maker(history, history_options);
    Recorder recorder({WatchedPixels{{x, y, x, y}, true}, {}},
                      [&](const RecordedDraw& draw, RecordedTriangle& t) { maker.see(draw, t); });
    history.counts = render_observed(target, model, camera, options, recorder);
    recorder.finish();
    history.color = target.color(x, y);
    history.depth = target.depth()[target.index(x, y)];
    judge(history);
    if (history_options.terms) add_terms(history, model, camera, options);
    return history;
}

}  // namespace raster
