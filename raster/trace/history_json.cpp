// history_json.cpp: a pixel's history as JSON: the same stage objects as in a trace, put together by triangle.
#include <raster/trace/event_json.h>
#include <raster/trace/history_text.h>

namespace raster {
namespace {

class HistoryJson {
public:
    HistoryJson(std::string& out, const PixelHistory& history) : json_(out), h_(history) {}

    void write() {
        json_.open('{');
        json_.member("format", "raster-pixel");
        json_.member("version", 1);
        json_.member("pixel", std::array{h_.x, h_.y});
        json_.member("size", std::array{h_.width, h_.height});
        json_.member("verdict", to_string(h_.verdict));
        json_.member("text", verdict_text(h_));
        json_.key("decisive_entry");
        h_.decisive ? json_.value(*h_.decisive) : json_.null();
        json_.member("color_before", h_.color_before);
        json_.member("color", h_.color);
        json_.member("depth_before", h_.depth_before);
        json_.member("depth", h_.depth);
        json_.member("depth_format", h_.depth_format == DepthFormat::unorm24 ? "unorm24" : "float32");
        json_.key("triangles");
        write_counts();
        json_.key("draws");
        json_.open('[');
        for (const RecordedDraw& draw : h_.draws) write(draw);
        json_.close(']');
        json_.key("entries");
        json_.open('[');
        for (const HistoryEntry& entry : h_.entries) write(entry);
        json_.close(']');
        json_.key("nearest");
        h_.nearest ? write(*h_.nearest) : json_.null();
        json_.close('}');
    }

private:
    void write_counts() {
        const DrawCounts& c = h_.counts;
        json_.open('{');
        json_.member("submitted", c.submitted);
        json_.member("bad_index", c.bad_index);
        json_.member("not_finite", c.not_finite);
        json_.member("outside", c.outside);
        json_.member("culled", c.culled);
        json_.member("zero_area", c.zero_area);
        json_.member("drawn", c.drawn);
        json_.close('}');
    }

    void write(const RecordedDraw& draw) {
        json_.open('{');
        json_.member("draw", draw.draw);
        json_.member("shading", word_for(draw.frequency));
        json_.member("detail", word_for(draw.level));
        json_.key("state");
        json_.open('{');
        write_members(json_, draw.state);
        json_.close('}');
        json_.close('}');
    }

    template <class Event>
    void write_stage(const Event& e) {
        json_.key(stage_of<Event>());
        json_.open('{');
        write_members(json_, e);
        json_.close('}');
    }
    template <class Event>
    void write_stage(const std::optional<Event>& e) {
        if (e) return write_stage(*e);
        json_.key(stage_of<Event>());
        json_.null();
    }

    void write(const HistoryEntry& e) {
        const RecordedTriangle& t = e.triangle;
        json_.open('{');
        json_.member("draw", t.draw);
        json_.member("triangle", t.number + 1);
        json_.member("order", t.triangle);
        json_.member("piece", e.piece());
        json_.member("fate", to_string(e.fate));
        json_.member("visible", e.visible);
        json_.member("distance_pixels", e.distance);
        write_ties(e);
        json_.key("cut_by");
        json_.open('[');
        for (const ClipPlane plane : e.cut_by) json_.value(word_for(plane));
        json_.close(']');
        json_.key("vertex");
        json_.open('[');
        for (const RecordedVertex& v : t.corners) {
            json_.open('{');
            write_members(json_, VertexEvent{v.vertex, v.attributes, v.clip, v.varyings});
            json_.close('}');
        }
        json_.close(']');
        write_stage(t.clip);
        write_cuts(t);
        write_piece(e);
        write_terms(e);
        write_corners(e);
        json_.close('}');
    }

    /// The edges that the centre lies on, and whether they own it.
    void write_ties(const HistoryEntry& e) {
        json_.key("ties");
        json_.open('[');
        for (int i = 0; i < 3; ++i) {
            if (!e.is_tie(i)) continue;
            const Edge<float>& edge = e.setup()->setup.edges[std::size_t(i)];
            json_.open('{');
            json_.member("edge", i);
            json_.member("side", to_string(side_of(edge)));
            json_.member("owned", bool(edge.inclusive));
            json_.close('}');
        }
        json_.close(']');
        json_.key("rejecting_edge");
        e.rejecting_edge() < 0 ? json_.null() : json_.value(e.rejecting_edge());
    }

    void write_cuts(const RecordedTriangle& t) {
        json_.key("clip_plane");
        json_.open('[');
        for (const RecordedCut& cut : t.cuts) {
            const auto corners = [](const std::vector<RecordedClipCorner>& from) {
                std::vector<ClipCorner> to;
                for (const RecordedClipCorner& c : from) to.push_back({c.clip, c.distance, c.varyings});
                return to;
            };
            const auto before = corners(cut.before), after = corners(cut.after);
            json_.open('{');
            write_members(json_, ClipPlaneEvent{t.triangle, cut.plane, before, after});
            json_.close('}');
        }
        json_.close(']');
    }

    void write_piece(const HistoryEntry& e) {
        const RecordedPiece* piece = e.triangle.pieces.empty() ? nullptr : &e.triangle.pieces[0];
        const RecordedPixel* pixel = e.pixel();
        const std::int64_t n = e.triangle.triangle;
        const int p = e.piece();
        write_stage(piece ? std::optional(piece->project) : std::nullopt);
        write_stage(piece ? piece->cull : std::nullopt);
        if (const RecordedSetup* s = e.setup()) {
            write_stage(SetupEvent{n, p, s->setup, s->oow, s->varyings});
        } else {
            json_.key("setup");
            json_.null();
        }
        write_stage(pixel ? std::optional(pixel->coverage) : std::nullopt);
        write_stage(pixel ? pixel->depth : std::nullopt);
        std::optional<InterpolateEvent> interpolation;
        if (pixel && pixel->interpolation)
            interpolation =
                InterpolateEvent{n, p, h_.x, h_.y, pixel->interpolation->oow, pixel->interpolation->varyings};
        write_stage(interpolation);
        std::optional<FragmentEvent> fragment;
        if (pixel && pixel->outputs) fragment = FragmentEvent{n, p, h_.x, h_.y, *pixel->outputs};
        write_stage(fragment);
        write_stage(pixel ? pixel->blend : std::nullopt);
    }

    void write_corners(const HistoryEntry& e) {
        json_.key("corner_light");
        if (e.corners.empty()) return json_.null();
        json_.open('[');
        for (const CornerLight& c : e.corners) {
            json_.open('{');
            json_.member("weight", c.weight);
            json_.member("diffuse", c.diffuse);
            json_.member("specular", c.specular);
            json_.close('}');
        }
        json_.close(']');
    }

    void write_terms(const HistoryEntry& e) {
        json_.key("terms");
        if (!e.terms) return json_.null();
        json_.open('{');
        json_.member("normal_world", e.terms->normal_world);
        json_.member("ambient", e.terms->ambient);
        json_.member("diffuse", e.terms->diffuse);
        json_.member("specular", e.terms->specular);
        json_.member("emission", e.terms->emission);
        json_.member("color", e.terms->color);
        json_.close('}');
    }

    JsonWriter json_;
    const PixelHistory& h_;
};

}  // namespace

std::string history_json(const PixelHistory& history) {
    std::string out;
    HistoryJson(out, history).write();
    return out;
}

}  // namespace raster
