// shapes_builder.h: collects the vertices and triangles of a generated model.
#pragma once

#include <cmath>
#include <string>
#include <utility>

#include <glm/glm.hpp>

#include <raster/scene/model.h>

namespace raster::detail {

/// Everything is computed in double precision and rounded to float here, once.
class ModelBuilder {
public:
    using Index = std::uint32_t;

    Index vertex(const glm::dvec3& position, const glm::dvec3& normal, const glm::dvec2& uv) {
        const double length = std::sqrt(glm::dot(normal, normal));
        const glm::dvec3 unit = length > 0 ? normal / length : glm::dvec3(0, 1, 0);
        // Adding 0 turns -0 into 0, so that equal positions are equal bits.
        model_.vertices.push_back({.position = glm::vec3(position) + 0.0f,
                                   .normal = glm::vec3(unit) + 0.0f,
                                   .uv = glm::vec2(uv) + 0.0f,
                                   .color = glm::vec3(1.0f)});
        return Index(model_.vertices.size() - 1);
    }

    /// Counter-clockwise seen from the front. A triangle with two corners at one place (at a pole) is left
    /// out.
    void triangle(Index a, Index b, Index c) {
        const auto at = [&](Index i) -> const glm::vec3& { return model_.vertices[i].position; };
        if (at(a) == at(b) || at(b) == at(c) || at(c) == at(a)) return;
        model_.indices.insert(model_.indices.end(), {a, b, c});
    }
    void quad(Index a, Index b, Index c, Index d) {
        triangle(a, b, c);
        triangle(a, c, d);
    }

    /// A quad of its own four vertices, from its lower left corner counter-clockwise, with the normal of its
    /// diagonals (Newell's normal of a quad) and the whole texture on it.
    void face(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, const glm::dvec3& d) {
        const glm::dvec3 n = glm::cross(c - a, d - b);
        const Index i = vertex(a, n, {0, 0}), j = vertex(b, n, {1, 0}), k = vertex(c, n, {1, 1});
        quad(i, j, k, vertex(d, n, {0, 1}));
    }
    void face(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
        const glm::dvec3 n = glm::cross(b - a, c - a);
        const Index i = vertex(a, n, {0, 0}), j = vertex(b, n, {1, 0});
        triangle(i, j, vertex(c, n, {0.5, 1}));
    }

    std::size_t vertex_count() const { return model_.vertices.size(); }

    int material(Material material) {
        model_.materials.push_back(std::move(material));
        return int(model_.materials.size()) - 1;
    }

    /// The triangles since the last part become a part.
    void part(std::string name, int material = -1) {
        Index first = 0;
        for (const Part& p : model_.parts) first += p.index_count;
        model_.parts.push_back({std::move(name), material, first, Index(model_.indices.size()) - first});
    }

    Model take() { return std::move(model_); }

private:
    Model model_;
};

}  // namespace raster::detail
