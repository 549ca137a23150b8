// history.h: why a pixel has its colour: everything that happened there, in submission order, and one verdict.
#pragma once

#include <raster/trace/record.h>

namespace raster {

/// What decided a pixel.
enum class PixelVerdict {
    won,            ///< a triangle wrote it last
    all_rejected,   ///< covered, but no triangle passed the depth test
    never_covered,  ///< triangles come near; none has the centre inside
    clipped,        ///< what would be here lies before the near plane or behind the far one
    culled,         ///< what would be here faces the wrong way
    background,     ///< nothing is here or near
    nan,            ///< the shader gave something that is not a number
};
const char* to_string(PixelVerdict verdict);

/// Which side of its triangle an edge is, as one sees it on the picture.
enum class EdgeSide { left, right, top, bottom };
const char* to_string(EdgeSide side);
EdgeSide side_of(const Edge<float>& edge);

/// What became of one triangle, or of one of the pieces that clipping made of it, at the pixel.
enum class PixelFate {
    wrote,      ///< covered it, passed, and was written
    lost,       ///< covered it and failed the depth test
    near,       ///< does not cover the centre, but comes near
    clipped,    ///< would be here, but this part was clipped away
    culled,     ///< would be here, but faces the wrong way
    zero_area,  ///< has no area on the subpixel grid; its line or point comes near
};
const char* to_string(PixelFate fate);

/// The four summands of a colour and the normal it was lit with: what `--aov` shows, for this fragment.
struct FragmentTerms {
    glm::vec3 normal_world, ambient, diffuse, specular, emission;
    glm::vec4 color;  ///< their sum. With Gouraud shading it may differ from the picture's by rounding
};

/// A corner's light with Gouraud shading, as its vertex shader gave it or clipping interpolated it, of the side that is
/// seen; and how much of the corner there is in the fragment.
struct CornerLight {
    glm::vec3 diffuse, specular;  ///< before the material's colours
    float weight;                 ///< perspective-correct
};

struct HistoryEntry {
    PixelFate fate{};
    bool visible = false;           ///< wrote, and nothing opaque came after
    double distance = 0;            ///< from the pixel's centre to the triangle, in pixels; 0 inside
    std::vector<ClipPlane> cut_by;  ///< when clipped: the planes that took this place away
    RecordedTriangle triangle;      ///< with this one piece, or none when clipped
    std::optional<FragmentTerms> terms;
    std::vector<CornerLight> corners;  ///< of the piece, three with Gouraud shading

    /// What was computed at the pixel; null where coverage was not reached.
    const RecordedPixel* pixel() const {
        return triangle.pieces.empty() || triangle.pieces[0].pixels.empty() ? nullptr : &triangle.pieces[0].pixels[0];
    }
    const RecordedSetup* setup() const {
        return triangle.pieces.empty() || !triangle.pieces[0].setup ? nullptr : &*triangle.pieces[0].setup;
    }
    /// As people count: "triangle 1" is the first.
    std::string name() const { return "triangle " + std::to_string(triangle.number + 1); }
    /// The number of the piece among those of its triangle.
    int piece() const { return triangle.pieces.empty() ? 0 : triangle.pieces[0].project.piece; }
    /// Whether the centre lies exactly on edge i.
    bool is_tie(int i) const { return pixel() && pixel()->coverage.edges[std::size_t(i)] == 0; }
    /// The edge that the centre is farthest outside of, or on without belonging to it; -1 when covered.
    int rejecting_edge() const;
};

struct PixelHistory {
    int x = 0, y = 0, width = 0, height = 0;
    PixelVerdict verdict = PixelVerdict::background;
    std::optional<std::size_t> decisive;  ///< the entry that the verdict is about
    std::vector<RecordedDraw> draws;
    std::vector<HistoryEntry> entries;    ///< in submission order
    std::optional<HistoryEntry> nearest;  ///< of all that do not cover it, however far
    DrawCounts counts;
    ColorFormat color_format{};
    DepthFormat depth_format{};
    glm::vec4 color_before{0.0f}, color{0.0f};  ///< as cleared, and at the end
    std::uint32_t depth_before = 0, depth = 0;  ///< as encode_depth gives them

    const RecordedDraw& draw_of(const HistoryEntry& entry) const { return draws[std::size_t(entry.triangle.draw)]; }
    int count(PixelFate fate) const;
};

struct HistoryOptions {
    double near_pixels = 1.0;  ///< triangles that come as near as this are listed though they do not cover it
    bool terms = true;         ///< a second run for FragmentTerms and CornerLight
};

/// The history of pixel (x, y) of the picture that render() makes of surfaces; lines and points leave no entries. The
/// picture's own draws are run, all stages up to the setup for all triangles and those of pixels for this one; every
/// number in the entries is from that run. Only what is listed (how near a triangle comes, what clipped or culled
/// triangles would have covered) is decided here. `target` gives size and formats, is drawn to, and has its picture at
/// that pixel alone.
PixelHistory pixel_history(Target& target, const Model& model, const CameraMatrices& camera,
                           const RenderOptions& options, int x, int y, const HistoryOptions& history = {});

}  // namespace raster
