// shapes.cpp: the models with flat faces.
#include <raster/scene/shapes.h>

#include <algorithm>

#include <raster/math.h>
#include <raster/scene/shapes_builder.h>

namespace raster {

using detail::ModelBuilder;

Model box(const glm::vec3& low, const glm::vec3& high, int divisions) {
    const int n = std::clamp(divisions, 1, 256);
    ModelBuilder builder;
    const auto corner = [&](int x, int y, int z) {
        return glm::dvec3(x ? high.x : low.x, y ? high.y : low.y, z ? high.z : low.z);
    };
    const auto side = [&](const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, const glm::dvec3& d) {
        if (n == 1) return builder.face(a, b, c, d);
        const glm::dvec3 normal = glm::cross(c - a, d - b);
        const auto first = ModelBuilder::Index(builder.vertex_count());
        for (int j = 0; j <= n; ++j)
            for (int i = 0; i <= n; ++i) {
                const double u = double(i) / n, v = double(j) / n;
                builder.vertex(a + (b - a) * u + (d - a) * v, normal, {u, v});
            }
        const auto at = [&](int i, int j) { return first + ModelBuilder::Index(j * (n + 1) + i); };
        for (int j = 0; j < n; ++j)
            for (int i = 0; i < n; ++i) builder.quad(at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1));
    };
    side(corner(1, 0, 1), corner(1, 0, 0), corner(1, 1, 0), corner(1, 1, 1));  // +x
    side(corner(0, 0, 0), corner(0, 0, 1), corner(0, 1, 1), corner(0, 1, 0));  // -x
    side(corner(0, 1, 1), corner(1, 1, 1), corner(1, 1, 0), corner(0, 1, 0));  // +y
    side(corner(0, 0, 0), corner(1, 0, 0), corner(1, 0, 1), corner(0, 0, 1));  // -y
    side(corner(0, 0, 1), corner(1, 0, 1), corner(1, 1, 1), corner(0, 1, 1));  // +z
    side(corner(1, 0, 0), corner(0, 0, 0), corner(0, 1, 0), corner(1, 1, 0));  // -z
    builder.part("box");
    return builder.take();
}

Model cube() {
    Model model = box(glm::vec3(-1.0f), glm::vec3(1.0f));
    model.parts[0].name = "cube";
    return model;
}

Model tetrahedron() {
    ModelBuilder builder;
    const glm::dvec3 a(1, 1, 1), b(-1, 1, -1), c(-1, -1, 1), d(1, -1, -1);
    builder.face(c, a, b);
    builder.face(c, d, a);
    builder.face(d, b, a);
    builder.face(b, d, c);
    builder.part("tetrahedron");
    return builder.take();
}

Model plane(int divisions) {
    const int n = std::clamp(divisions, 1, 1024);
    ModelBuilder builder;
    for (int j = 0; j <= n; ++j) {
        for (int i = 0; i <= n; ++i) {
            const double u = double(i) / n, v = double(j) / n;
            builder.vertex({2 * u - 1, 0, 1 - 2 * v}, {0, 1, 0}, {u, v});
        }
    }
    const auto at = [&](int i, int j) { return ModelBuilder::Index(j * (n + 1) + i); };
    for (int j = 0; j < n; ++j)
        for (int i = 0; i < n; ++i) builder.quad(at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1));
    builder.part("plane");
    return builder.take();
}

Model cyclic_trio() {
    ModelBuilder builder;
    const std::pair<const char*, glm::vec3> colors[] = {
        {"blue", {0.10f, 0.30f, 0.75f}}, {"orange", {0.90f, 0.45f, 0.05f}}, {"white", {0.85f, 0.85f, 0.80f}}};
    for (int i = 0; i < 3; ++i) {
        // One long triangle rises towards the viewer along a side of a triangle; the others are it, turned.
        const auto [s, c] = sin_cos_degrees(120.0 * i);
        const auto turned = [&, s = s, c = c](double x, double y, double z) {
            return glm::dvec3(c * x - s * y, s * x + c * y, z);
        };
        builder.face(turned(-1.2, -0.8, -0.4), turned(1.4, -0.45, 0.4), turned(-1.2, -0.1, -0.4));
        Material material;
        material.name = colors[i].first;
        material.ambient = material.diffuse = colors[i].second;
        material.illumination = 1;  // no highlights
        builder.part(material.name, builder.material(material));
    }
    return builder.take();
}

}  // namespace raster
