// recorder.h: the second observed run, which keeps the numbers of what was chosen.
#pragma once

#include <map>

#include <raster/step/record.h>
#include <raster/step/watch.h>

namespace raster::step {

class Recorder {
public:
    /// Fills `record`, whose pixel and region are set. `chosen` are triangles by number in the model, and why.
    Recorder(Record& record, std::map<std::int64_t, std::string> chosen, const glm::mat4& world_from_object)
        : record_(record), chosen_(std::move(chosen)), world_from_object_(world_from_object) {}

    void on(const DrawEvent& event);
    void on(const VertexEvent& event);
    void on(const AssembleEvent& event);
    void on(const ClipPlaneEvent& event);
    void on(const ClipEvent& event);
    void on(const ProjectEvent& event);
    void on(const CullEvent& event);
    void on(const SetupEvent& event);
    void on(const CoverageEvent& event);
    void on(const DepthEvent& event);
    void on(const InterpolateEvent& event);
    void on(const FragmentEvent& event);
    void on(const BlendEvent& event);

private:
    /// The piece at hand, whether its triangle is chosen or not.
    struct Piece {
        std::array<WindowVertex<float>, 3> window;
        std::array<std::vector<float>, 3> varyings;
        bool front_facing = false;
        std::array<int, 3> order{};
        PlaneBasis<float> basis{};
        std::vector<Plane<float>> affine;
        std::array<Plane<float>, 3> weights{}, affine_weights{};
        Plane<float> oow{};
    };
    bool in_region(int x, int y) const { return record_.region.holds(x, y); }
    TriangleRecord* triangle() { return is_chosen_ ? &record_.triangles.back() : nullptr; }
    SetupRecord* setup() { return is_chosen_ ? &*record_.triangles.back().pieces.back().setup : nullptr; }
    FragmentRecord* fragment(int x, int y);

    Record& record_;
    std::map<std::int64_t, std::string> chosen_;
    glm::mat4 world_from_object_;
    const PlannedDraw* draw_ = nullptr;
    int draw_number_ = 0;
    std::vector<VertexRecord> vertices_;  ///< of the draw
    std::int64_t number_ = 0;             ///< of the triangle at hand, in the model
    bool is_chosen_ = false;
    std::array<std::uint32_t, 3> corners_{};
    std::vector<std::vector<float>> polygon_;  ///< varyings of what clipping left so far; empty when nothing was cut
    Piece piece_;
};

/// The painter's algorithm at the pixels of a region.
class PaintRecorder {
public:
    PaintRecorder(Record& record) : record_(record) {}
    void on(const DrawEvent& event) { draw_ = &event.planned; }
    void on(const DepthEvent& event) { z_ = event.z; }
    void on(const BlendEvent& event) {
        if (record_.region.holds(event.x, event.y))
            record_.painted.push_back({number_in_model(*draw_, event.triangle), event.x, event.y, z_, event.after});
    }

private:
    Record& record_;
    const PlannedDraw* draw_ = nullptr;
    float z_ = 0;
};

/// What the shader computed at a fragment of flat or Phong shading, term by term.
ShadingRecord shading_at(const PlannedDraw& draw, std::int64_t triangle, bool front_facing,
                         const std::optional<Bug>& bug, std::span<const float> varyings,
                         std::span<const float> outputs);
/// What Gouraud's vertex shader computed, of the side that is seen.
ShadingRecord shading_of_corner(const PlannedDraw& draw, std::uint32_t vertex, bool front_facing,
                                std::span<const float> varyings);
/// What Gouraud's fragment shader summed from the light that arrived as varyings; nothing where it arrived as a colour.
std::optional<Terms<float>> terms_of_varyings(const PlannedDraw& draw, bool front_facing,
                                              std::span<const float> varyings, std::span<const float> outputs);

}  // namespace raster::step
