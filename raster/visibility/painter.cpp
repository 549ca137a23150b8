// painter.cpp: sorting triangles by depth.
#include <raster/visibility/painter.h>

#include <algorithm>
#include <array>

#include <raster/stages/vertex.h>

namespace raster {
namespace {

/// How far a point lies in front of the eye, along the view direction. Not a number counts as 0.
float eye_depth(const glm::mat4& eye_from_object, const glm::vec3& position) {
    const float depth = -transform_point(eye_from_object, position).z;
    return depth == depth ? depth : 0.0f;
}

}  // namespace

std::vector<std::uint32_t> painter_order(std::span<const SurfaceVertex<float>> vertices,
                                         std::span<const std::uint32_t> indices, const glm::mat4& eye_from_object,
                                         PainterKey key) {
    struct Entry {
        float depth;
        std::uint32_t triangle;
    };
    std::vector<Entry> entries(indices.size() / 3);
    for (std::size_t i = 0; i < entries.size(); ++i) {
        std::array<float, 3> depths{};
        for (std::size_t c = 0; c < 3; ++c)
            if (indices[3 * i + c] < vertices.size())
                depths[c] = eye_depth(eye_from_object, vertices[indices[3 * i + c]].position);
        const float farthest = std::max({depths[0], depths[1], depths[2]});
        const float sum = depths[0] + depths[1] + depths[2];  // thrice the centroid's
        const float depth = key == PainterKey::farthest_vertex ? farthest : sum;
        entries[i] = {depth == depth ? depth : 0.0f, std::uint32_t(i)};
    }
    std::stable_sort(entries.begin(), entries.end(),
                     [](const Entry& a, const Entry& b) { return a.depth > b.depth; });
    std::vector<std::uint32_t> order(entries.size());
    std::transform(entries.begin(), entries.end(), order.begin(), [](const Entry& e) { return e.triangle; });
    return order;
}

}  // namespace raster
