// record.h: what happened to chosen triangles in a picture, kept as plain data: the events of each, put together.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include <raster/scene/observe.h>

namespace raster {

// Everything here is what the stages computed. What a stage did not reach is an empty optional, never a number.

/// What a draw was told, of the things that explain its triangles.
struct RecordedDraw {
    int draw = 0;  ///< counted from 0
    ShadingFrequency frequency{};
    Detail level{};
    State state;
    ColorFormat color_format{};
    DepthFormat depth_format{};
    glm::mat4 clip_from_object{1.0f}, eye_from_object{1.0f};
};

struct RecordedVertex {
    std::uint32_t vertex = 0;  ///< its place in the draw's vertex array
    std::vector<float> attributes;
    glm::vec4 clip{0.0f};
    std::vector<float> varyings;
};

/// A corner of a polygon on its way through the clip planes.
struct RecordedClipCorner {
    glm::vec4 clip;
    float distance;
    std::vector<float> varyings;
};
struct RecordedCut {
    ClipPlane plane;
    std::vector<RecordedClipCorner> before, after;
};

struct RecordedSetup {
    TriangleSetup setup;
    Plane<float> oow;
    std::vector<Plane<float>> varyings;
};

struct RecordedInterpolation {
    float oow;
    std::vector<float> varyings;
};

/// One pixel of one piece: the stages in their order, as far as they were reached.
struct RecordedPixel {
    CoverageEvent coverage;
    std::optional<DepthEvent> depth;
    std::optional<RecordedInterpolation> interpolation;
    std::optional<std::vector<float>> outputs;  ///< of the shader: colour, then extra planes
    std::optional<BlendEvent> blend;
};

/// A triangle, or one of the fan that clipping made of it.
struct RecordedPiece {
    ProjectEvent project;
    std::optional<CullEvent> cull;
    std::optional<RecordedSetup> setup;
    std::vector<RecordedPixel> pixels;  ///< watched ones of its box, or all watched ones
};

struct RecordedTriangle {
    int draw = 0;
    std::int64_t triangle = 0;  ///< in the draw, from 0: the order of submission
    std::int64_t number = 0;    ///< in the model, from 0
    bool bad_index = false;
    std::array<RecordedVertex, 3> corners;
    std::optional<ClipEvent> clip;
    std::vector<RecordedCut> cuts;
    std::vector<RecordedPiece> pieces;
};

/// What is to be recorded.
struct RecordChoice {
    std::optional<WatchedPixels> pixels;  ///< where to watch; everywhere when empty
    std::vector<std::int64_t> triangles;  ///< numbers in the model, from 0; all when empty
};

/// An observer for render_observed that puts records together. Call finish() after the draws.
class Recorder {
public:
    /// Called for each chosen triangle in submission order, when it is complete. The record may be moved from.
    using Sink = std::function<void(const RecordedDraw& draw, RecordedTriangle& triangle)>;

    Recorder(RecordChoice choice, Sink sink) : choice_(std::move(choice)), sink_(std::move(sink)) {}
    void finish();

    WatchedPixels watched_pixels() const;
    void on(const DrawEvent& e);
    void on(const VertexEvent& e);
    void on(const AssembleEvent& e);
    void on(const ClipEvent& e);
    void on(const ClipPlaneEvent& e);
    void on(const ProjectEvent& e);
    void on(const CullEvent& e);
    void on(const SetupEvent& e);
    void on(const CoverageEvent& e);
    void on(const DepthEvent& e);
    void on(const InterpolateEvent& e);
    void on(const FragmentEvent& e);
    void on(const BlendEvent& e);

private:
    RecordedPiece& piece() { return triangle_.pieces.back(); }
    RecordedPixel& pixel() { return piece().pixels.back(); }
    /// Whether the stages of a pixel have somewhere to go: lines and points have no pieces.
    bool in_pixel() const { return recording_ && !triangle_.pieces.empty() && !triangle_.pieces.back().pixels.empty(); }

    RecordChoice choice_;
    Sink sink_;
    RecordedDraw draw_;
    const PlannedDraw* planned_ = nullptr;
    // The draw's vertices, flat: those of one triangle are put into its record.
    std::size_t attribute_count_ = 0, varying_count_ = 0;
    std::vector<float> attributes_, varyings_;
    std::vector<glm::vec4> clips_;
    RecordedTriangle triangle_;
    bool recording_ = false;
};

}  // namespace raster
