// outline.h: the edges or the corners of triangles, each once: what a wireframe or a cloud of points is made of.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace raster {

/// Lines (two indices each) or points (one), in the order in which the triangles name them first.
struct Outline {
    std::vector<std::uint32_t> indices;
    std::vector<std::uint32_t> triangles;  ///< of each line or point: the first triangle that has it
};

/// Of those triangles of an index list, three indices each, that `keep` wants by their number. Edges and corners are
/// the same when their indices are: on a seam, where a position has two vertices, there are two.
using KeepTriangle = std::function<bool(std::uint32_t)>;
Outline edges_of(std::span<const std::uint32_t> indices, const KeepTriangle& keep = {});
Outline corners_of(std::span<const std::uint32_t> indices, const KeepTriangle& keep = {});

}  // namespace raster
