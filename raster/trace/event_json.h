// event_json.h: each event as the members of a JSON object; docs/trace.schema.json says what they mean.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <raster/scene/observe.h>
#include <raster/trace/json.h>

namespace raster {

// The names of the enumerators in files. Numbers are exact: floats as short as they can be read back the same, integers
// below 2^53.
const char* word_for(ClipPlane plane);
const char* word_for(ClipEvent::Verdict verdict);
const char* word_for(CullEvent::Verdict verdict);
const char* word_for(ShadingFrequency frequency);
const char* word_for(Detail level);
const char* word_for(Compare compare);
const char* word_for(Cull cull);
const char* word_for(FillRule rule);
const char* word_for(Blend blend);

// Members of an open object, without the triangle's number, which only who knows the draw can tell.
void write_members(JsonWriter& json, const VertexEvent& e);
void write_members(JsonWriter& json, const AssembleEvent& e);
void write_members(JsonWriter& json, const ClipEvent& e);
void write_members(JsonWriter& json, const ClipPlaneEvent& e);
void write_members(JsonWriter& json, const ProjectEvent& e);
void write_members(JsonWriter& json, const CullEvent& e);
void write_members(JsonWriter& json, const SetupEvent& e);
void write_members(JsonWriter& json, const CoverageEvent& e);
void write_members(JsonWriter& json, const DepthEvent& e);
void write_members(JsonWriter& json, const InterpolateEvent& e);
void write_members(JsonWriter& json, const FragmentEvent& e);
void write_members(JsonWriter& json, const BlendEvent& e);
void write_members(JsonWriter& json, const State& state);
/// A matrix as an array of rows, from the top.
void write_rows(JsonWriter& json, const glm::mat4& m);

namespace detail {
constexpr std::string_view stage_name(const DrawEvent*) { return "draw"; }
constexpr std::string_view stage_name(const VertexEvent*) { return "vertex"; }
constexpr std::string_view stage_name(const AssembleEvent*) { return "assemble"; }
constexpr std::string_view stage_name(const ClipPlaneEvent*) { return "clip_plane"; }
constexpr std::string_view stage_name(const ClipEvent*) { return "clip"; }
constexpr std::string_view stage_name(const ProjectEvent*) { return "project"; }
constexpr std::string_view stage_name(const CullEvent*) { return "cull"; }
constexpr std::string_view stage_name(const SetupEvent*) { return "setup"; }
constexpr std::string_view stage_name(const CoverageEvent*) { return "coverage"; }
constexpr std::string_view stage_name(const DepthEvent*) { return "depth"; }
constexpr std::string_view stage_name(const InterpolateEvent*) { return "interpolate"; }
constexpr std::string_view stage_name(const FragmentEvent*) { return "fragment"; }
constexpr std::string_view stage_name(const BlendEvent*) { return "blend"; }
}  // namespace detail

/// The stage of an event, as in --stage.
template <class Event>
constexpr std::string_view stage_of() {
    return detail::stage_name(static_cast<const Event*>(nullptr));
}

/// What the numbers of a vertex, of varyings and of outputs are, in their order: "normal_eye.x".
std::vector<std::string> attribute_names();
std::vector<std::string> varying_names(ShadingFrequency frequency, Detail level);
std::vector<std::string> output_names(Detail level);

}  // namespace raster
