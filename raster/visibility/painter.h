// painter.h: the painter's algorithm: triangles in an order in which each covers what lies behind it.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <raster/scene/model.h>

namespace raster {

/// By which distance a whole triangle is sorted. Distances are eye depths, that is along the view direction.
enum class PainterKey {
    centroid,         ///< of the mean of its corners
    farthest_vertex,  ///< of its farthest corner, as Newell, Newell and Sancha's algorithm begins (1972)
};

/// The numbers of the triangles, the farthest first; those of equal depth keep their order. Three indices a triangle.
/// Drawn in this order without a depth test the nearest surface stays on top, as a rule:
///
/// - One number cannot stand for a whole triangle. A large one beside or under a small one may be sorted wrongly by
///   either key, although an order exists.
/// - Triangles that overlap in a cycle, or that pierce each other, have no right order at all; they would have to be
/// cut.
///
/// Both go wrong silently. Where no two triangles overlap on the picture, or their depths do not, the picture is the
/// z-buffer's.
std::vector<std::uint32_t> painter_order(std::span<const SurfaceVertex<float>> vertices,
                                         std::span<const std::uint32_t> indices, const glm::mat4& eye_from_object,
                                         PainterKey key = PainterKey::centroid);

}  // namespace raster
