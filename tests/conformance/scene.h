// scene.h: a scene that both the library and OSMesa can draw, and the picture that comes out.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <glm/glm.hpp>

#include <raster/shading/texture.h>
#include <raster/state.h>

namespace raster::conformance {

/// What the shaders of both sides take. The position is in clip space.
struct Vertex {
    glm::vec4 position;
    glm::vec4 color;
    glm::vec2 uv;
};

/// How a draw is coloured.
enum class Coloring {
    smooth,          ///< the vertices' colours, perspective-correct
    flat,            ///< the colour of the provoking vertex
    noperspective,   ///< colours, linear in the window
    fixed_function,  ///< smooth, but without GLSL in OpenGL
    textured,        ///< a texture times the colour
};

struct Texture {
    PackedTexture image;
    Wrap wrap = Wrap::repeat;
    Filter filter = Filter::nearest;
};

struct Draw {
    std::vector<Vertex> vertices;
    std::vector<std::uint32_t> indices;
    State state;
    std::vector<glm::vec4> clip_planes = {};  ///< the state's, which only refers to them
    Coloring coloring = Coloring::smooth;
    Texture texture;

    State full_state() const {
        State full = state;
        full.clip_planes = clip_planes;
        return full;
    }
};

struct Scene {
    int width = 0, height = 0;
    glm::vec4 clear_color = glm::vec4(0);
    float clear_depth = 1;
    std::vector<Draw> draws;
};

/// The two planes, rows from top to bottom: r | g << 8 | b << 16 | a << 24, and depth in 24 bits.
struct Picture {
    std::vector<std::uint32_t> color, depth;

    friend bool operator==(const Picture&, const Picture&) = default;
};

/// How far two pictures of the same size are apart.
struct Difference {
    std::size_t color_pixels = 0;
    std::size_t depth_pixels = 0;
    int largest = 0;        ///< largest difference of a channel, in 1/255
    std::size_t first = 0;  ///< index of the first pixel that differs

    bool none() const { return color_pixels == 0 && depth_pixels == 0; }
};
Difference compare(const Picture& a, const Picture& b);
std::string describe(const Difference& difference, int width);

/// FNV-1a (Fowler, Noll, Vo) over the words of both planes.
std::uint64_t hash_of(const Picture& picture);

/// The scene drawn by the library: by tiles and lanes, or one pixel after the other.
enum class Path { fast, observed };
Picture render(const Scene& scene, Path path);

}  // namespace raster::conformance
