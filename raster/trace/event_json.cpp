// event_json.cpp: events as JSON members.
#include <raster/trace/event_json.h>

#include <raster/trace/history.h>

namespace raster {
namespace {

void write_corners(JsonWriter& json, std::span<const ClipCorner> corners) {
    json.open('[');
    for (const ClipCorner& c : corners) {
        json.open('{');
        json.member("clip", c.clip);
        json.member("distance", c.distance);
        json.member("varyings", c.varyings);
        json.close('}');
    }
    json.close(']');
}

std::array<float, 3> numbers(const Plane<float>& p) { return {p.origin, p.dadx, p.dady}; }

void write_piece(JsonWriter& json, int piece) { json.member("piece", piece); }

template <class Event>
void write_place(JsonWriter& json, const Event& e) {
    write_piece(json, e.piece);
    json.member("x", e.x);
    json.member("y", e.y);
}

/// name.x, name.y, ...
void add(std::vector<std::string>& names, const std::string& name, const std::string& components) {
    for (const char c : components) names.push_back(name + "." + c);
}

}  // namespace

void write_members(JsonWriter& json, const VertexEvent& e) {
    json.member("vertex", e.vertex);
    json.member("attributes", e.attributes);
    json.member("clip", e.clip);
    json.member("varyings", e.varyings);
}

void write_members(JsonWriter& json, const AssembleEvent& e) {
    json.member("order", e.triangle);
    json.member("vertices", e.vertices);
    json.member("bad_index", e.bad_index);
}

void write_members(JsonWriter& json, const ClipEvent& e) {
    json.member("clip", e.clip);
    json.member("outcodes", e.outcodes);
    json.member("verdict", word_for(e.verdict));
    json.member("pieces", e.pieces);
}

void write_members(JsonWriter& json, const ClipPlaneEvent& e) {
    json.member("plane", word_for(e.plane));
    json.key("before");
    write_corners(json, e.before);
    json.key("after");
    write_corners(json, e.after);
}

void write_members(JsonWriter& json, const ProjectEvent& e) {
    write_piece(json, e.piece);
    json.member("clip", e.clip);
    std::array<std::array<float, 4>, 3> window;
    std::array<std::array<std::int32_t, 2>, 3> subpixel;
    for (std::size_t c = 0; c < 3; ++c) {
        window[c] = {e.window[c].x, e.window[c].y, e.window[c].z, e.window[c].oow};
        subpixel[c] = {e.subpixel[c].x, e.subpixel[c].y};
    }
    json.member("window", window);
    json.member("subpixel", subpixel);
}

void write_members(JsonWriter& json, const CullEvent& e) {
    write_piece(json, e.piece);
    json.member("area", e.area);
    json.member("front_facing", e.front_facing);
    json.member("verdict", word_for(e.verdict));
}

void write_members(JsonWriter& json, const SetupEvent& e) {
    write_piece(json, e.piece);
    json.member("order", e.setup.order);
    json.key("edges");
    json.open('[');
    for (const Edge<float>& edge : e.setup.edges) {
        json.open('{');
        json.member("step_x", edge.step_x);
        json.member("step_y", edge.step_y);
        json.member("origin", edge.origin);
        json.member("inclusive", bool(edge.inclusive));
        json.member("side", to_string(side_of(edge)));
        json.close('}');
    }
    json.close(']');
    const PixelBox& box = e.setup.box;
    json.member("box", std::array{box.min_x, box.min_y, box.max_x, box.max_y});
    json.member("depth", numbers(e.setup.depth));
    json.member("oow", numbers(e.oow));
    json.key("varyings");
    json.open('[');
    for (const Plane<float>& plane : e.varyings) json.value(numbers(plane));
    json.close(']');
}

void write_members(JsonWriter& json, const CoverageEvent& e) {
    write_place(json, e);
    json.member("edges", e.edges);
    json.member("covered", e.covered);
}

void write_members(JsonWriter& json, const DepthEvent& e) {
    write_place(json, e);
    json.member("z", e.z);
    json.member("incoming", e.incoming);
    json.member("stored", e.stored);
    json.member("passed", e.passed);
}

void write_members(JsonWriter& json, const InterpolateEvent& e) {
    write_place(json, e);
    json.member("oow", e.oow);
    json.member("varyings", e.varyings);
}

void write_members(JsonWriter& json, const FragmentEvent& e) {
    write_place(json, e);
    json.member("outputs", e.outputs);
}

void write_members(JsonWriter& json, const BlendEvent& e) {
    write_place(json, e);
    json.member("source", e.source);
    json.member("before", e.before);
    json.member("after", e.after);
}

void write_members(JsonWriter& json, const State& state) {
    json.member("cull", word_for(state.cull));
    json.member("fill_rule", word_for(state.fill_rule));
    json.member("depth_compare", word_for(state.depth_compare));
    json.member("depth_write", state.depth_write);
    json.member("blend", word_for(state.blend));
}

void write_rows(JsonWriter& json, const glm::mat4& m) {
    json.open('[');
    for (int row = 0; row < 4; ++row) json.value(glm::vec4(m[0][row], m[1][row], m[2][row], m[3][row]));
    json.close(']');
}

const char* word_for(ClipPlane plane) {
    constexpr const char* words[] = {"right", "left",  "top",   "bottom", "near",  "far",   "user1",
                                     "user2", "user3", "user4", "user5",  "user6", "user7", "user8"};
    static_assert(std::size(words) == max_clip_planes);
    return words[int(plane)];
}
const char* word_for(ClipEvent::Verdict verdict) {
    constexpr const char* words[] = {"inside", "not_finite", "outside", "clipped"};
    return words[int(verdict)];
}
const char* word_for(CullEvent::Verdict verdict) {
    constexpr const char* words[] = {"kept", "culled", "zero_area"};
    return words[int(verdict)];
}
const char* word_for(ShadingFrequency frequency) {
    constexpr const char* words[] = {"flat", "gouraud", "phong"};
    return words[int(frequency)];
}
const char* word_for(Detail level) {
    constexpr const char* words[] = {"plain", "mapped", "terms"};
    return words[int(level)];
}
const char* word_for(Compare compare) {
    constexpr const char* words[] = {"never",   "less",      "equal",         "less_equal",
                                     "greater", "not_equal", "greater_equal", "always"};
    return words[int(compare)];
}
const char* word_for(Cull cull) {
    constexpr const char* words[] = {"none", "back", "front", "both"};
    return words[int(cull)];
}
const char* word_for(FillRule rule) { return rule == FillRule::bottom_left ? "opengl" : "direct3d"; }
const char* word_for(Blend blend) {
    constexpr const char* words[] = {"off", "source_over", "additive"};
    return words[int(blend)];
}

std::vector<std::string> attribute_names() {
    std::vector<std::string> names;
    add(names, "position", "xyz");
    add(names, "normal", "xyz");
    add(names, "uv", "uv");
    add(names, "color", "rgb");
    return names;
}

std::vector<std::string> varying_names(ShadingFrequency frequency, Detail level) {
    std::vector<std::string> names;
    const bool plain = level == Detail::plain;
    switch (frequency) {
        case ShadingFrequency::flat:
            if (!plain) add(names, "uv", "uv");
            return names;
        case ShadingFrequency::gouraud:
            if (plain) {
                add(names, "color", "rgb");
                return names;
            }
            for (const char* side : {"front", "back"})
                for (const char* term : {"diffuse", "specular"}) add(names, std::string(side) + "_" + term, "rgb");
            break;
        case ShadingFrequency::phong:
            add(names, "normal_eye", "xyz");
            add(names, "position_eye", "xyz");
            if (plain) return names;
            break;
    }
    add(names, "uv", "uv");
    add(names, "color", "rgb");
    if (frequency == ShadingFrequency::gouraud) add(names, "normal_eye", "xyz");
    return names;
}

std::vector<std::string> output_names(Detail level) {
    std::vector<std::string> names;
    add(names, "color", "rgba");
    if (level != Detail::terms) return names;
    add(names, "normal_world", "xyz");
    names.push_back("triangle");
    for (const char* term : {"ambient", "diffuse", "specular", "emission"}) add(names, term, "rgb");
    return names;
}

}  // namespace raster
