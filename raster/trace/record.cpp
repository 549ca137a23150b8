// record.cpp: puts the events of a triangle together.
#include <raster/trace/record.h>

#include <algorithm>

namespace raster {
namespace {

std::vector<float> copy(std::span<const float> numbers) { return {numbers.begin(), numbers.end()}; }

std::vector<RecordedClipCorner> copy(std::span<const ClipCorner> corners) {
    std::vector<RecordedClipCorner> result;
    for (const ClipCorner& c : corners) result.push_back({c.clip, c.distance, copy(c.varyings)});
    return result;
}

}  // namespace

WatchedPixels Recorder::watched_pixels() const {
    return choice_.pixels.value_or(WatchedPixels{{0, 0, max_target_size, max_target_size}});
}

void Recorder::finish() {
    if (recording_) sink_(draw_, triangle_);
    recording_ = false;
}

void Recorder::on(const DrawEvent& e) {
    finish();
    const ShadingUniforms& u = e.planned.uniforms;
    draw_ = {e.draw,
             e.planned.frequency,
             e.planned.level,
             e.planned.state,
             e.target.color_format(),
             e.target.depth_format(),
             u.clip_from_object,
             u.eye_from_object};
    planned_ = &e.planned;
    attributes_.clear();
    varyings_.clear();
    clips_.clear();
}

void Recorder::on(const VertexEvent& e) {
    attribute_count_ = e.attributes.size();
    varying_count_ = e.varyings.size();
    attributes_.insert(attributes_.end(), e.attributes.begin(), e.attributes.end());
    varyings_.insert(varyings_.end(), e.varyings.begin(), e.varyings.end());
    clips_.push_back(e.clip);
}

void Recorder::on(const AssembleEvent& e) {
    finish();
    const std::int64_t number = number_in_model(*planned_, e.triangle);
    const auto& chosen = choice_.triangles;
    recording_ = chosen.empty() || std::find(chosen.begin(), chosen.end(), number) != chosen.end();
    if (!recording_) return;
    triangle_.draw = draw_.draw;
    triangle_.triangle = e.triangle;
    triangle_.number = number;
    triangle_.bad_index = e.bad_index;
    triangle_.clip.reset();
    triangle_.cuts.clear();
    triangle_.pieces.clear();
    for (std::size_t c = 0; c < 3; ++c) {
        RecordedVertex& corner = triangle_.corners[c];
        const std::size_t v = corner.vertex = e.vertices[c];
        if (v >= clips_.size()) {
            corner = {e.vertices[c], {}, glm::vec4(0.0f), {}};
            continue;
        }
        const float* attributes = attributes_.data() + v * attribute_count_;
        const float* varyings = varyings_.data() + v * varying_count_;
        corner.attributes.assign(attributes, attributes + attribute_count_);
        corner.clip = clips_[v];
        corner.varyings.assign(varyings, varyings + varying_count_);
    }
}

void Recorder::on(const ClipEvent& e) {
    if (recording_) triangle_.clip = e;
}

void Recorder::on(const ClipPlaneEvent& e) {
    if (recording_) triangle_.cuts.push_back({e.plane, copy(e.before), copy(e.after)});
}

void Recorder::on(const ProjectEvent& e) {
    if (recording_) triangle_.pieces.push_back({e, {}, {}, {}});
}

void Recorder::on(const CullEvent& e) {
    if (recording_) piece().cull = e;
}

void Recorder::on(const SetupEvent& e) {
    if (recording_) piece().setup = {e.setup, e.oow, {e.varyings.begin(), e.varyings.end()}};
}

void Recorder::on(const CoverageEvent& e) {
    if (recording_) piece().pixels.push_back({e, {}, {}, {}, {}});
}

void Recorder::on(const DepthEvent& e) {
    if (in_pixel()) pixel().depth = e;
}

void Recorder::on(const InterpolateEvent& e) {
    if (in_pixel()) pixel().interpolation = {e.oow, copy(e.varyings)};
}

void Recorder::on(const FragmentEvent& e) {
    if (in_pixel()) pixel().outputs = copy(e.outputs);
}

void Recorder::on(const BlendEvent& e) {
    if (in_pixel()) pixel().blend = e;
}

}  // namespace raster
