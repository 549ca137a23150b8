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

/// The stage of an event, as in --stage.
template <class Event>
constexpr std::string_view stage_of();
template <> constexpr std::string_view stage_of<DrawEvent>() { return "draw"; }
template <> constexpr std::string_view stage_of<VertexEvent>() { return "vertex"; }
template <> constexpr std::string_view stage_of<AssembleEvent>() { return "assemble"; }
template <> constexpr std::string_view stage_of<ClipPlaneEvent>() { return "clip_plane"; }
template <> constexpr std::string_view stage_of<ClipEvent>() { return "clip"; }
template <> constexpr std::string_view stage_of<ProjectEvent>() { return "project"; }
template <> constexpr std::string_view stage_of<CullEvent>() { return "cull"; }
template <> constexpr std::string_view stage_of<SetupEvent>() { return "setup"; }
template <> constexpr std::string_view stage_of<CoverageEvent>() { return "coverage"; }
template <> constexpr std::string_view stage_of<DepthEvent>() { return "depth"; }
template <> constexpr std::string_view stage_of<InterpolateEvent>() { return "interpolate"; }
template <> constexpr std::string_view stage_of<FragmentEvent>() { return "fragment"; }
template <> constexpr std::string_view stage_of<BlendEvent>() { return "blend"; }

/// What the numbers of a vertex, of varyings and of outputs are, in their order: "normal_eye.x".
std::vector<std::string> attribute_names();
std::vector<std::string> varying_names(ShadingFrequency frequency, Detail level);
std::vector<std::string> output_names(Detail level);

}  // namespace raster
