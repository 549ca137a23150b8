// append.cpp: copies with their indices moved up.
#include <raster/scene/append.h>

#include <cmath>
#include <limits>

#include <raster/scene/transform.h>

namespace raster {
namespace {

Error problem(const char* text) { return {ErrorKind::bad_input, text}; }

bool is_finite(const glm::vec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

double determinant(const glm::mat4& m) {
    const glm::dvec3 x(m[0]), y(m[1]), z(m[2]);
    return glm::dot(x, glm::cross(y, z));
}

}  // namespace

Status append(Model& into, const Model& model, const glm::mat4& into_from_model) {
    const double volume = determinant(into_from_model);
    if (!std::isfinite(volume) || volume == 0) return problem("the transform has no inverse");
    constexpr std::size_t limit = std::numeric_limits<std::uint32_t>::max();
    if (into.vertices.size() + model.vertices.size() > limit || into.indices.size() + model.indices.size() > limit)
        return problem("too many vertices");

    const glm::mat3 normals = normal_matrix(into_from_model);
    std::vector<SurfaceVertex<float>> vertices = model.vertices;
    for (SurfaceVertex<float>& v : vertices) {
        v.position = glm::vec3(into_from_model * glm::vec4(v.position, 1.0f));
        if (!is_finite(v.position)) return problem("the transform moves a vertex out of the range of floats");
        const glm::dvec3 n = glm::dmat3(normals) * glm::dvec3(v.normal);
        const double length = std::sqrt(glm::dot(n, n));
        if (length > 0 && std::isfinite(length)) v.normal = glm::vec3(n / length);
    }

    const auto first_vertex = std::uint32_t(into.vertices.size());
    const auto first_index = std::uint32_t(into.indices.size());
    const int first_material = int(into.materials.size()), first_texture = int(into.textures.size());
    into.vertices.insert(into.vertices.end(), vertices.begin(), vertices.end());
    into.indices.reserve(into.indices.size() + model.indices.size());
    for (std::size_t i = 0; i + 2 < model.indices.size(); i += 3) {
        const std::uint32_t a = model.indices[i], b = model.indices[i + 1], c = model.indices[i + 2];
        for (const std::uint32_t corner : {a, volume < 0 ? c : b, volume < 0 ? b : c})
            into.indices.push_back(first_vertex + corner);
    }
    for (Part part : model.parts) {
        part.first_index += first_index;
        if (part.material >= 0) part.material += first_material;
        into.parts.push_back(std::move(part));
    }
    if (model.parts.empty()) into.parts.push_back({"", -1, first_index, std::uint32_t(model.indices.size())});
    for (Material material : model.materials) {
        for (int* texture : {&material.ambient_texture, &material.diffuse_texture, &material.specular_texture,
                             &material.emission_texture, &material.alpha_texture})
            if (*texture >= 0) *texture += first_texture;
        const glm::dvec3 grain = glm::dmat3(glm::mat3(into_from_model)) * glm::dvec3(material.grain);
        const double length = std::sqrt(glm::dot(grain, grain));
        if (length > 0 && std::isfinite(length)) material.grain = glm::vec3(grain / length);
        into.materials.push_back(std::move(material));
    }
    into.textures.insert(into.textures.end(), model.textures.begin(), model.textures.end());
    return Done{};
}

}  // namespace raster
