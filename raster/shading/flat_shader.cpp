// flat_shader.cpp: lighting the triangles of a mesh, several at once.
#include <raster/shading/flat_shader.h>

#include <algorithm>

#include <raster/tiles/parallel.h>

namespace raster {
namespace {

/// lanes<F> faces from `first` on. Beyond the end, and for bad indices, the face has no area.
template <class F>
Face<F> gather_faces(const Mesh<SurfaceVertex<float>>& mesh, std::size_t first, std::size_t count) {
    constexpr std::size_t n = std::size_t(lanes<F>);
    float position[3][3][n] = {};
    float color[3][n] = {};
    const std::size_t end = std::min(first + n, count);
    for (std::size_t face = first; face < end; ++face) {
        std::array<std::size_t, 3> corners;
        for (std::size_t c = 0; c < 3; ++c)
            corners[c] = mesh.indices.empty() ? 3 * face + c : mesh.indices[3 * face + c];
        if (std::max({corners[0], corners[1], corners[2]}) >= mesh.vertices.size()) continue;
        for (std::size_t c = 0; c < 3; ++c)
            for (int i = 0; i < 3; ++i)
                position[c][i][face - first] = mesh.vertices[corners[c]].position[i];
        for (int i = 0; i < 3; ++i)
            color[i][face - first] = (mesh.vertices[corners[0]].color[i] + mesh.vertices[corners[1]].color[i] +
                                      mesh.vertices[corners[2]].color[i]) * (1.0f / 3.0f);
    }
    Face<F> r;
    for (int i = 0; i < 3; ++i) {
        for (std::size_t c = 0; c < 3; ++c) r.position[c][i] = load<F>(position[c][i]);
        r.color[i] = load<F>(color[i]);
    }
    return r;
}

}  // namespace

std::vector<FaceLight> light_faces(const ShadingUniforms& u, const RuntimeModel& model,
                                   const Mesh<SurfaceVertex<float>>& mesh) {
    constexpr std::size_t n = std::size_t(lanes<FloatN>);
    const std::size_t count = (mesh.indices.empty() ? mesh.vertices.size() : mesh.indices.size()) / 3;
    std::vector<FaceLight> faces(count);
    const std::size_t blocks = (count + n - 1) / n;
    constexpr std::size_t chunk = 256;  // blocks that one thread takes at once
    tiles::parallel_for((blocks + chunk - 1) / chunk, [&](std::size_t c) {
        for (std::size_t block = c * chunk; block < std::min((c + 1) * chunk, blocks); ++block) {
            const Face<FloatN> face = gather_faces<FloatN>(mesh, block * n, count);
            const LitFace<FloatN> lit = light_face(u, model, face);
            const auto pick = [](const vec<3, FloatN>& v, int i) {
                return glm::vec3(lane(v.x, i), lane(v.y, i), lane(v.z, i));
            };
            for (std::size_t i = block * n; i < std::min(block * n + n, count); ++i) {
                const int l = int(i - block * n);
                faces[i] = {{pick(lit.lit.diffuse, l), pick(lit.lit.specular, l)}, pick(lit.normal_eye, l),
                            pick(face.color, l)};
            }
        }
    });
    return faces;
}

}  // namespace raster
