// shapes_testing.h: a model's surface as the eye takes it, for tests of its topology.
#pragma once

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include <raster/scene/model.h>

namespace raster::testing {

/// A model's surface with vertices at one place made one: what the eye takes for one surface.
struct Surface {
    std::vector<glm::dvec3> points;
    std::vector<std::array<int, 3>> triangles;

    explicit Surface(const Model& model) {
        std::map<std::array<float, 3>, int> number;
        std::vector<int> point_of;
        for (std::uint32_t i : model.indices) {
            const glm::vec3& p = model.vertices[i].position;
            const auto [at, is_new] = number.try_emplace({p.x, p.y, p.z}, int(points.size()));
            if (is_new) points.emplace_back(p);
            point_of.push_back(at->second);
        }
        for (std::size_t i = 0; i < point_of.size(); i += 3)
            triangles.push_back({point_of[i], point_of[i + 1], point_of[i + 2]});
    }

    /// Directed edges that have no partner in the opposite direction.
    std::vector<std::pair<int, int>> open_edges() const {
        std::map<std::pair<int, int>, int> count;
        for (const auto& t : triangles)
            for (int k = 0; k < 3; ++k) ++count[{t[k], t[(k + 1) % 3]}];
        std::vector<std::pair<int, int>> open;
        for (const auto& [edge, n] : count) {
            EXPECT_EQ(n, 1) << "a directed edge used twice: not a manifold, or not oriented";
            if (!count.count({edge.second, edge.first})) open.push_back(edge);
        }
        return open;
    }

    int euler_characteristic() const {
        std::set<std::pair<int, int>> edges;
        for (const auto& t : triangles)
            for (int k = 0; k < 3; ++k) edges.insert(std::minmax(t[k], t[(k + 1) % 3]));
        return int(points.size()) - int(edges.size()) + int(triangles.size());
    }

    double volume() const {
        double v = 0;
        for (const auto& [a, b, c] : triangles) v += glm::dot(points[a], glm::cross(points[b], points[c]));
        return v / 6;
    }
};

}  // namespace raster::testing
