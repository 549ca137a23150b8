// scenes.cpp: builds the benchmark's meshes: from an OBJ file, by subdivision, or from a few numbers.
#include "scenes.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>

#include <raster/scene/obj.h>
#include <raster/scene/shapes.h>
#include <raster/scene/transform.h>
#include <raster/shading/models.h>

namespace bench {

namespace {

using Corner = Vertex<float>;

/// Squares of grey ramps and white, 1024 x 1024.
void add_texture(Scene& scene) {
    constexpr std::uint32_t size = 1024;
    scene.shading = Shading::textured;
    scene.texture.width = scene.texture.height = int(size);
    scene.texture.texels.resize(std::size_t(size) * size);
    for (std::uint32_t y = 0; y < size; ++y)
        for (std::uint32_t x = 0; x < size; ++x) {
            const std::uint32_t check = ((x >> 5) ^ (y >> 5)) & 1;
            const std::uint32_t r = check ? 255 : (x >> 2) & 255, g = (y >> 2) & 255, b = (x * 7 + y * 13) & 255;
            scene.texture.texels[y * size + x] = std::int32_t(r | g << 8 | b << 16 | 0xff000000u);
        }
    for (std::uint32_t y = size; y-- > 0;) {
        const auto row = scene.texture.texels.begin() + std::ptrdiff_t(y * size);
        scene.upside_down.insert(scene.upside_down.end(), row, row + size);
    }
}

void add_quad(Scene& scene, const glm::vec3& origin, const glm::vec3& u, const glm::vec3& v) {
    const auto first = std::uint32_t(scene.vertices.size());
    const glm::vec3 n = glm::normalize(glm::cross(u, v));
    scene.vertices.push_back({origin, n, {0, 0}});
    scene.vertices.push_back({origin + u, n, {1, 0}});
    scene.vertices.push_back({origin + u + v, n, {1, 1}});
    scene.vertices.push_back({origin + v, n, {0, 1}});
    for (const std::uint32_t i : {0u, 1u, 2u, 0u, 2u, 3u}) scene.indices.push_back(first + i);
}

glm::mat4 ground_camera() {
    return raster::product(raster::rotate_x(35), raster::translate({0, -4, -5}));
}

/// Turns a model, centres its box and scales it so that the larger of width and height is 2.
void place_model(Scene& scene) {
    const glm::mat4 turn = raster::product(raster::rotate_x(10), raster::rotate_y(30));
    glm::vec3 low(1e30f), high(-1e30f);
    for (Corner& v : scene.vertices) {
        v.position = glm::vec3(turn * glm::vec4(v.position, 1));
        v.normal = glm::mat3(turn) * v.normal;
        low = glm::min(low, v.position);
        high = glm::max(high, v.position);
    }
    const glm::vec3 center = (low + high) * 0.5f;
    const float factor = 2.0f / std::max(high.x - low.x, high.y - low.y);
    for (Corner& v : scene.vertices) v.position = (v.position - center) * factor;
    const float tan_half = float(raster::perspective(45, 1, 1, 2)[1][1]);
    scene.eye_from_world = raster::translate({0, 0, -1.25f * tan_half});
}

void take(Scene& scene, const raster::Model& model) {
    scene.vertices.clear();
    for (const auto& v : model.vertices) scene.vertices.push_back({v.position, v.normal, v.uv});
    scene.indices = model.indices;
}

/// Each triangle becomes four at the midpoints of its edges.
void subdivide(Scene& scene) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
    const auto middle = [&](std::uint32_t a, std::uint32_t b) {
        const auto [place, made] = middles.try_emplace(std::minmax(a, b), std::uint32_t(scene.vertices.size()));
        if (made) {
            const Corner &p = scene.vertices[a], &q = scene.vertices[b];
            scene.vertices.push_back(
                {(p.position + q.position) * 0.5f, glm::normalize(p.normal + q.normal), (p.uv + q.uv) * 0.5f});
        }
        return place->second;
    };
    std::vector<std::uint32_t> finer;
    for (std::size_t i = 0; i < scene.indices.size(); i += 3) {
        const std::uint32_t a = scene.indices[i], b = scene.indices[i + 1], c = scene.indices[i + 2];
        const std::uint32_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
        finer.insert(finer.end(), {a, ab, ca, ab, b, bc, ca, bc, c, ab, bc, ca});
    }
    scene.indices = std::move(finer);
}

void cube_and_ground(Scene& scene) {
    const glm::mat4 turn = raster::product(raster::translate({0, 1.5f, 0}),
                                           raster::product(raster::rotate_y(30), raster::rotate_x(25)));
    const glm::vec3 axes[3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    for (int axis = 0; axis < 3; ++axis)
        for (const float side : {-1.0f, 1.0f}) {
            const glm::vec3 n = axes[axis] * side, u = axes[(axis + 1) % 3], v = axes[(axis + 2) % 3] * side;
            add_quad(scene, n - u - v, u * 2.0f, v * 2.0f);
        }
    for (Corner& c : scene.vertices) {
        c.position = glm::vec3(turn * glm::vec4(c.position, 1));
        c.normal = glm::mat3(turn) * c.normal;
    }
    add_quad(scene, {-18, 0, 5}, {36, 0, 0}, {0, 0, -21});
    scene.eye_from_world = ground_camera();
}

/// A torus of across x along quads, without raster::torus's limit of 1024 each.
void fine_torus(Scene& scene, int across, int along) {
    std::vector<raster::SinCos> turns;
    for (int j = 0; j < along; ++j) turns.push_back(raster::sin_cos_degrees(360.0 * j / along));
    for (int i = 0; i < across; ++i) {
        const auto [s, c] = raster::sin_cos_degrees(360.0 * i / across);
        for (const auto& [sin, cos] : turns) {
            const glm::dvec3 normal(c * cos, sin, s * cos);
            scene.vertices.push_back({glm::vec3(glm::dvec3(c, 0, s) + 0.4 * normal), glm::vec3(normal), {0, 0}});
        }
    }
    const auto at = [&](int i, int j) {
        return std::uint32_t(i % across) * std::uint32_t(along) + std::uint32_t(j % along);
    };
    for (int i = 0; i < across; ++i)
        for (int j = 0; j < along; ++j) {
            const std::uint32_t a = at(i, j), b = at(i, j + 1), c = at(i + 1, j + 1), d = at(i + 1, j);
            scene.indices.insert(scene.indices.end(), {a, b, c, a, c, d});
        }
}

void layers(Scene& scene, int count, bool back_to_front) {
    scene.shading = Shading::flat_color;
    scene.cull_back = false;
    for (int i = 0; i < count; ++i) {
        const float z = -1.0f - 32.0f * float(back_to_front ? count - 1 - i : i) / float(count);
        const float reach = -z * 2.0f;
        add_quad(scene, {-reach, -reach, z}, {2 * reach, 0, 0}, {0, 2 * reach, 0});
    }
}

}  // namespace

namespace {
/// The number that follows a scene's kind in its name; 0 for another kind, and for what is no number.
int number_after(const std::string& kind, const std::string& name) {
    return name.rfind(kind, 0) == 0 ? std::atoi(name.c_str() + kind.size()) : 0;
}
}  // namespace

glm::vec3 to_light_eye() { return glm::normalize(glm::vec3(0.4f, 0.7f, 1.0f)); }

glm::mat4 projection(int width, int height) {
    return raster::perspective(45, double(width) / double(height), 0.5, 50);
}

std::vector<std::string> scene_names() {
    return {"clear", "s1", "s2", "s3", "s4", "s4q", "s5", "s6b", "s6a", "s6f", "s7", "s7d"};
}

std::vector<std::string> reflectance_scene_names() {
    std::vector<std::string> names;
    for (const std::string_view name : raster::reflectance_names()) names.push_back("m-" + std::string(name));
    return names;
}

raster::Result<Scene> make_scene(const std::string& name, const std::string& bunny) {
    Scene scene;
    scene.name = name;
    if (name == "s2" || name == "s3" || name == "s5" || name == "s7d") {
        raster::LoadReport report;
        auto model = raster::load_obj(bunny, raster::ObjOptions{}, report);
        if (!model) return model.error();
        take(scene, *model);
        if (name == "s5" || name == "s7d") subdivide(scene), subdivide(scene);
        place_model(scene);
    }
    if (name == "clear") {
        scene.what = "clear only";
        scene.shading = Shading::none;
    } else if (name == "s1") {
        scene.what = "cube and ground, per-pixel Blinn-Phong";
        cube_and_ground(scene);
    } else if (name == "s2") {
        scene.what = "bunny, Gouraud";
        scene.shading = Shading::gouraud;
    } else if (name == "s3") {
        scene.what = "bunny, per-pixel Blinn-Phong";
    } else if (name == "s4") {
        scene.what = "teapot, bilinear texture, Lambert";
        add_texture(scene);
        take(scene, raster::teapot(10));
        place_model(scene);
    } else if (name == "s4q") {
        scene.what = "32 x 32 textured quads on the ground";
        add_texture(scene);
        for (int z = 0; z < 32; ++z)
            for (int x = 0; x < 32; ++x)
                add_quad(scene, {-18 + 36 * float(x) / 32, 0, 5 - 21 * float(z) / 32}, {36.0f / 32, 0, 0},
                         {0, 0, -21.0f / 32});
        scene.eye_from_world = ground_camera();
    } else if (name == "s5") {
        scene.what = "bunny subdivided twice, Gouraud";
        scene.shading = Shading::gouraud;
    } else if (name == "fill") {
        scene.what = "one full-screen quad";
        layers(scene, 1, true);
    } else if (name == "s6b") {
        scene.what = "64 full-screen quads, back to front";
        layers(scene, 64, true);
    } else if (name == "s6a") {
        scene.what = "64 full-screen quads, blended";
        layers(scene, 64, true);
        scene.blend = true;
    } else if (name == "s6f") {
        scene.what = "64 full-screen quads, front to back";
        layers(scene, 64, false);
    } else if (name == "s7") {
        scene.what = "torus of 100,000 triangles, depth only";
        scene.shading = Shading::none;
        take(scene, raster::torus(0.4f, 250, 200));
        place_model(scene);
    } else if (name == "s7d") {
        scene.what = "s5's mesh, depth only";
        scene.shading = Shading::none;
    } else if (const int count = number_after("torus:", name); count > 0) {
        scene.what = "torus, Gouraud";
        scene.shading = Shading::gouraud;
        const int across = std::max(3, int(std::lround(std::sqrt(double(count) / 2.5))));
        fine_torus(scene, across, std::max(3, count / 2 / across));
        place_model(scene);
    } else if (const int quads = number_after("layers:", name); quads > 0) {
        scene.what = "full-screen quads, back to front";
        layers(scene, quads, true);
    } else if (name.rfind("m-", 0) == 0 && raster::find_reflectance(name.substr(2))) {
        scene.reflectance = name.substr(2);
        scene.what = "sphere, " + scene.reflectance;
        scene.shading = Shading::reflectance;
        take(scene, raster::sphere());
        place_model(scene);
    } else {
        return raster::Error{raster::ErrorKind::usage, "no scene named '" + name + "'"};
    }
    return scene;
}

}  // namespace bench
