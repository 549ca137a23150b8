// record.h: what is kept of an observed draw for the stepper page: plain copies of what the events held.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <raster/bugs/render_bug.h>

namespace raster::step {

/// One draw call.
struct DrawRecord {
    std::string material;
    ShadingFrequency frequency;
    Detail level;
    std::string reflectance;       ///< the model's name
    std::optional<float> n_h_power, r_v_power;  ///< of highlights that are a power of n h, or of r v
    State state;
    std::int64_t triangles = 0;
    std::size_t vertices = 0;
    std::vector<std::string> varyings;  ///< names, one a float
    glm::mat4 clip_from_object, eye_from_object;
};

/// A corner of a polygon that is being clipped. Where it is new, from whose edge it came and at which t.
struct CornerRecord {
    glm::vec4 clip;
    float distance;
    int from = -1, to = -1;  ///< corners of the polygon before; -1 for an old one
    float t = 0;             ///< clip = from + t (to - from)
};

struct PlaneRecord {
    ClipPlane plane;
    std::vector<CornerRecord> before, after;
};

/// The edge values at the pixels of a rectangle, three a pixel, row by row.
struct CoverageRecord {
    int x0 = 0, y0 = 0, width = 0, height = 0;
    std::vector<std::array<std::int64_t, 3>> edges;
};

/// Stages 6 and 7 of a piece.
struct SetupRecord {
    TriangleSetup setup;
    std::array<bool, 3> owned_opengl, owned_direct3d;  ///< whether each edge owns its points under the two rules
    Plane<float> oow;
    std::vector<Plane<float>> varyings;
    CoverageRecord coverage;
    std::int64_t tested = 0, covered = 0, passed = 0;  ///< pixels, in the whole picture
};

/// Stages 4 to 7 of what clipping left of a triangle.
struct PieceRecord {
    std::array<glm::vec4, 3> clip;
    std::array<std::vector<float>, 3> varyings;  ///< of corners that clipping made; else empty
    std::array<WindowVertex<float>, 3> window;
    std::array<SubpixelVertex<float>, 3> subpixel;
    std::array<glm::vec3, 3> ndc;  ///< what `project` has between its two steps
    std::int64_t area = 0;
    bool front_facing = false;
    CullEvent::Verdict verdict = CullEvent::Verdict::kept;
    std::optional<SetupRecord> setup;
};

/// What one light gives at a point, by the functions the shader calls.
struct LightRecord {
    int light;
    glm::vec3 l;
    float strength;
    float n_l, n_v, l_v;
    glm::vec3 h;
    float n_h, r_v;  ///< r mirrors l
    glm::vec3 diffuse, specular;            ///< the reflectance model's answer
    glm::vec3 lit_diffuse, lit_specular;    ///< times strength and the light's colour
};

/// The light at one point of a surface.
struct ShadingRecord {
    std::string where;  ///< "pixel", "centroid" or "corner"
    glm::vec3 position_eye, n, v;
    std::vector<LightRecord> lights;
    glm::vec3 sum_diffuse, sum_specular;
    glm::vec3 ka, kd, ks, emission;
    glm::vec3 ambient;  ///< of the lights
    float alpha;
    Terms<float> terms;  ///< light times colours
    bool agrees = false; ///< with the bits that the shader returned
};

/// A vertex in the spaces the stage and the model know.
struct VertexRecord {
    std::uint32_t number;  ///< in the draw
    std::vector<float> attributes;
    glm::vec4 clip;
    std::vector<float> varyings;
    glm::vec4 world{0.0f}, eye{0.0f};  ///< by the same function as clip, with the matrices up to there
    std::optional<ShadingRecord> shading;  ///< with Gouraud shading: its light, of the side that is seen
};

struct TriangleRecord {
    std::int64_t number;  ///< in the model
    std::int64_t order;   ///< in the draw
    int draw;
    std::string why;      ///< it was chosen
    std::array<std::uint32_t, 3> vertices;
    bool bad_index = false;
    std::vector<VertexRecord> corners;
    std::array<std::int32_t, 3> outcodes{};
    std::optional<ClipEvent::Verdict> clip;
    std::vector<PlaneRecord> planes;
    std::vector<PieceRecord> pieces;
};

/// Stages 7 to 11 at one pixel that a piece covers.
struct FragmentRecord {
    std::int64_t triangle;  ///< number in the model
    int draw, piece, x, y;
    float z;
    std::uint32_t incoming, stored;
    bool passed;
    bool detailed = false;  ///< whether the rest is kept
    float oow = 0;
    std::vector<float> varyings;  ///< perspective-correct; those of the shader
    std::vector<float> affine;    ///< the same linear in the window
    std::array<float, 3> weights{}, affine_weights{};  ///< as a varying that is 1 at one corner, 0 at the others
    std::vector<float> outputs;
    std::optional<Terms<float>> terms;  ///< where the shader summed them and did not give them out
    glm::vec4 source{0.0f}, before{0.0f}, after{0.0f};
    std::optional<ShadingRecord> shading;
};

/// A fragment of the painter's algorithm.
struct PaintedRecord {
    std::int64_t triangle;
    int x, y;
    float z;
    glm::vec4 after;
};

struct Region {
    int x0, y0, x1, y1;  ///< both ends included
    bool holds(int x, int y) const { return x >= x0 && x <= x1 && y >= y0 && y <= y1; }
};

/// All of it.
struct Record {
    int width, height;
    glm::ivec2 pixel;
    std::int64_t focus;  ///< triangle shown first, -1 for none
    Region region;
    std::vector<DrawRecord> draws;
    std::vector<TriangleRecord> triangles;
    std::vector<FragmentRecord> fragments;
    std::vector<PaintedRecord> painted;
    std::optional<Bug> bug;
    std::optional<FirstDifference> first_difference;  ///< from the right run
    DrawCounts counts;
    std::vector<std::string> left_out;  ///< in words
};

}  // namespace raster::step
