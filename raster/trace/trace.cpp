// trace.cpp: an observer that writes what it is told.
#include <raster/trace/trace.h>

#include <algorithm>
#include <limits>

#include <raster/trace/event_json.h>
#include <raster/trace/scene_hash.h>

namespace raster {
namespace {

class TraceWriter {
public:
    TraceWriter(const TraceFilter& filter, std::string& out) : filter_(filter), out_(out) {
        for (std::size_t i = 0; i < trace_stages.size(); ++i)
            wanted_[i] =
                filter.stages.empty() || std::ranges::find(filter.stages, trace_stages[i]) != filter.stages.end();
    }

    WatchedPixels watched_pixels() const {
        return {filter_.pixels.value_or(PixelBox{0, 0, max_target_size, max_target_size})};
    }
    bool is_too_long() const { return out_.size() > filter_.max_bytes; }

    void on(const DrawEvent& e) {
        draw_ = e.draw;
        planned_ = &e.planned;
        vertices_.clear();
        pending_.clear();
        write<DrawEvent>(out_, [&](JsonWriter& json) { describe(json, e.planned); });
    }
    void on(const VertexEvent& e) {
        if (!wanted_[0] || is_too_long()) return;
        std::string& line = filters_triangles() ? vertices_.emplace_back() : out_;
        write<VertexEvent>(line, [&](JsonWriter& json) { write_members(json, e); });
    }
    void on(const AssembleEvent& e) {
        pending_.clear();
        number_ = number_in_model(*planned_, e.triangle);
        chosen_ = filter_.triangles.empty() || std::ranges::find(filter_.triangles, number_) != filter_.triangles.end();
        // What a pixel's triangles are is known when they reach it.
        waiting_ = chosen_ && filter_.pixels;
        corners_ = e.vertices;
        if (chosen_ && !waiting_) write_corners();
        add(e);
    }
    void on(const ClipEvent& e) { add(e); }
    void on(const ClipPlaneEvent& e) { add(e); }
    void on(const ProjectEvent& e) { add(e); }
    void on(const CullEvent& e) { add(e); }
    void on(const SetupEvent& e) { add(e); }
    void on(const CoverageEvent& e) {
        if (waiting_) {
            write_corners();
            out_ += pending_;
            pending_.clear();
            waiting_ = false;
        }
        add(e);
    }
    void on(const DepthEvent& e) { add(e); }
    void on(const InterpolateEvent& e) { add(e); }
    void on(const FragmentEvent& e) { add(e); }
    void on(const BlendEvent& e) { add(e); }

private:
    bool filters_triangles() const { return filter_.pixels || !filter_.triangles.empty(); }

    template <class Event>
    bool wants() const {
        constexpr std::string_view stage = stage_of<Event>() == "clip_plane" ? "clip" : stage_of<Event>();
        constexpr std::size_t i = std::size_t(std::ranges::find(trace_stages, stage) - trace_stages.begin());
        return wanted_[i];
    }

    template <class Event, class Write>
    void write(std::string& out, const Write& members) {
        JsonWriter json(out);
        json.open('{');
        json.member("stage", stage_of<Event>());
        json.member("draw", draw_);
        members(json);
        json.close('}');
        out += '\n';
    }

    template <class Event>
    void add(const Event& e) {
        if (!chosen_ || !wants<Event>() || is_too_long()) return;
        write<Event>(waiting_ ? pending_ : out_, [&](JsonWriter& json) {
            json.member("triangle", number_ + 1);
            write_members(json, e);
        });
    }

    /// The vertices of a chosen triangle that were not yet written.
    void write_corners() {
        for (const std::uint32_t v : corners_) {
            if (v >= vertices_.size()) continue;
            out_ += vertices_[v];
            vertices_[v].clear();
        }
    }

    static void describe(JsonWriter& json, const PlannedDraw& planned) {
        json.member("shading", word_for(planned.frequency));
        json.member("detail", word_for(planned.level));
        json.key("state");
        json.open('{');
        write_members(json, planned.state);
        json.close('}');
        json.key("clip_from_object");
        write_rows(json, planned.uniforms.clip_from_object);
        json.key("eye_from_object");
        write_rows(json, planned.uniforms.eye_from_object);
        const auto list = [&](const char* name, const std::vector<std::string>& words) {
            json.key(name);
            json.open('[');
            for (const std::string& word : words) json.value(std::string_view(word));
            json.close(']');
        };
        list("attributes", attribute_names());
        list("varyings", varying_names(planned.frequency, planned.level));
        list("outputs", output_names(planned.level));
    }

    const TraceFilter& filter_;
    std::string& out_;
    std::array<bool, trace_stages.size()> wanted_{};
    int draw_ = 0;
    const PlannedDraw* planned_ = nullptr;
    std::vector<std::string> vertices_;  ///< lines of this draw that may be asked for
    std::string pending_;                ///< lines of a triangle that has not yet reached a chosen pixel
    std::int64_t number_ = 0;
    std::array<std::uint32_t, 3> corners_{};
    bool chosen_ = false, waiting_ = false;
};

void write_header(std::string& out, const Target& target, const Model& model, const CameraMatrices& camera,
                  const RenderOptions& options, const TraceFilter& filter, const TraceSource& source) {
    JsonWriter json(out);
    json.open('{');
    json.member("format", "raster-trace");
    json.member("version", 1);
    json.member("schema", "trace.schema.json");
    json.member("program", std::string_view(source.program));
    json.member("model", std::string_view(source.model));
    json.member("scene_hash", std::string_view(scene_hash(model, camera, options, target.width(), target.height())));
    json.member("width", target.width());
    json.member("height", target.height());
    json.member("triangles", model.triangle_count());
    json.member("background", options.background);
    json.member("color_format", target.color_format() == ColorFormat::rgba8 ? "rgba8" : "rgba_float");
    json.member("depth_format", target.depth_format() == DepthFormat::unorm24 ? "unorm24" : "float32");
    json.key("display");
    json.open('{');
    json.member("srgb", source.display.srgb);
    json.member("exposure", source.display.exposure);
    json.close('}');
    json.key("camera");
    json.open('{');
    for (const auto& [name, matrix] : {std::pair("eye_from_world", &camera.eye_from_world),
                                       {"clip_from_eye", &camera.clip_from_eye},
                                       {"clip_from_world", &camera.clip_from_world}}) {
        json.key(name);
        write_rows(json, *matrix);
    }
    json.close('}');
    json.key("filter");
    json.open('{');
    json.key("pixels");
    if (filter.pixels) {
        json.value(std::array{filter.pixels->min_x, filter.pixels->min_y, filter.pixels->max_x, filter.pixels->max_y});
    } else {
        json.null();
    }
    json.key("triangles");
    json.open('[');
    for (const std::int64_t number : filter.triangles) json.value(number + 1);
    json.close(']');
    json.key("stages");
    json.open('[');
    for (const std::string_view stage : filter.stages) json.value(stage);
    json.close(']');
    json.close('}');
    json.key("conventions");
    json.open('{');
    json.member("floats", "decimals that are read back as the same 32-bit float");
    json.member("triangle", "from 1, in the order of the model file");
    json.member("pixel", "from 0 at the top left, y down; its centre is at x + 0.5, y + 0.5");
    json.member("subpixel", "256 a pixel, from the centre of pixel 0");
    json.member("edge", "origin + 256 (step_x x + step_y y) at pixel x, y; inside is > 0, or = 0 on an inclusive edge");
    json.member("plane", "[origin, dadx, dady]: (dady y + (dadx x + origin)) at pixel x, y");
    json.member("matrix", "rows from the top; they multiply column vectors");
    json.member("clip", "visible is -w <= x, y, z <= w");
    json.member("depth", "0 near, 1 far; incoming and stored as the depth format has them");
    json.member("color", "red, green, blue, alpha as stored; the screen gets it times 2^exposure, sRGB-encoded if so");
    json.close('}');
    json.close('}');
    out += '\n';
}

}  // namespace

Result<std::string> trace_picture(Target& target, const Model& model, const CameraMatrices& camera,
                                  const RenderOptions& options, const TraceFilter& filter, const TraceSource& source) {
    std::string out;
    write_header(out, target, model, camera, options, filter, source);
    TraceWriter writer(filter, out);
    const DrawCounts counts = render_observed(target, model, camera, options, writer);
    if (writer.is_too_long())
        return Error{ErrorKind::usage, "the trace would be longer than " + std::to_string(filter.max_bytes) +
                                           " bytes; choose pixels, triangles or stages"};
    JsonWriter json(out);
    json.open('{');
    json.member("stage", "end");
    json.member("submitted", counts.submitted);
    json.member("bad_index", counts.bad_index);
    json.member("not_finite", counts.not_finite);
    json.member("outside", counts.outside);
    json.member("culled", counts.culled);
    json.member("zero_area", counts.zero_area);
    json.member("drawn", counts.drawn);
    json.close('}');
    out += '\n';
    return out;
}

}  // namespace raster
