// scenes.h: what the benchmark draws: meshes, matrices and state, the same for this library and for its rival.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <glm/glm.hpp>

#include <raster/lanes.h>
#include <raster/result.h>
#include <raster/shading/texture.h>

namespace bench {

/// A vertex of every scene, in the scene's world space.
template <class F>
struct Vertex {
    raster::vec<3, F> position, normal;
    raster::vec<2, F> uv;
};

/// How a scene is shaded. All have one directional light and a local viewer; `reflectance` is the library's own pixel
/// shader with a model of its list.
enum class Shading { none, flat_color, gouraud, per_pixel, reflectance, textured };

struct Scene {
    std::string name;
    std::string what;
    std::vector<Vertex<float>> vertices;
    std::vector<std::uint32_t> indices;
    glm::mat4 eye_from_world{1.0f};
    Shading shading = Shading::per_pixel;
    std::string reflectance;  ///< the model's name
    bool cull_back = true;
    bool blend = false;
    raster::PackedTexture texture;          ///< of textured scenes
    std::vector<std::int32_t> upside_down;  ///< its rows from the bottom up, as OpenGL wants them
};

inline const glm::vec4 clear_color(0.1f, 0.1f, 0.15f, 1.0f);
inline const glm::vec3 base_color(0.8f, 0.6f, 0.4f);
inline constexpr float ambient = 0.2f, diffuse = 0.8f, specular = 0.5f, exponent = 32.0f;
glm::vec3 to_light_eye();
glm::mat4 projection(int width, int height);

/// The names of all scenes, in the order of the table.
std::vector<std::string> scene_names();
/// Those that show what a reflectance model costs: m-NAME.
std::vector<std::string> reflectance_scene_names();
/// The indices of refraction of m-cook-torrance: gold.
inline const glm::vec3 metal_n(0.156f, 0.424f, 1.383f), metal_k(3.602f, 2.472f, 1.916f);

/// Builds a scene, one of those or "fill", one quad over the whole picture, "torus:N" of about N triangles or
/// "layers:N" of N quads; `bunny` is the path of an OBJ file that the scenes s2, s3, s5 and s7d show.
raster::Result<Scene> make_scene(const std::string& name, const std::string& bunny);

}  // namespace bench
