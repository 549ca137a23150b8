// normals.h: normals for surfaces that come without, smooth where the surface is and sharp at its creases.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/glm.hpp>

namespace raster {

/// What the file says about a face's smoothness (the `s` statement of OBJ): 0 is flat; any other number is a
/// group, within which the surface is smooth.
inline constexpr std::uint32_t smoothing_off = 0;
/// The file says nothing: the crease angle decides.
inline constexpr std::uint32_t smoothing_by_angle = 0xffffffffu;

struct Creases {
    /// In degrees, 0 to 180: two faces that meet at a corner share its normal if theirs differ by at most this
    /// much. 0 is flat shading, 180 smooths all.
    float angle = 60.0f;
    /// Whether the angle counts inside smoothing groups too.
    bool within_groups = false;
};

/// Polygons that meet.
struct Faces {
    std::span<const std::uint32_t> corners;  ///< positions of all faces' corners, one face after the other
    std::span<const std::uint32_t> ends;     ///< a face: where its corners end; empty if all are triangles
    std::span<const std::uint32_t> groups;   ///< a face: its smoothing group; empty if all are smoothing_by_angle
};

/// Makes up one unit normal for each of `faces.corners`, which are indices into `positions`.
///
/// It is the sum of the normals of the faces around the corner, each weighted by its area: Gouraud, "Continuous
/// Shading of Curved Surfaces" (1971), with the weights that fall out of the cross product. Faces meet by
/// position, not by index, and count as the polygons they are, so it does not matter how they will be cut into
/// triangles. Only faces of the same smoothing group and within the crease angle take part; at a position where
/// more than 128 meet, all of the group do, to bound the time. A face of zero area, or with a position that is
/// not finite, takes no part; a corner that only such faces have gets (0, 0, 1).
///
/// The order of the faces matters in the last bits only, the machine not at all.
std::vector<glm::vec3> make_normals(std::span<const glm::vec3> positions, const Faces& faces,
                                    const Creases& creases = {});

}  // namespace raster
