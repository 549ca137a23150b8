// osmesa.h: OSMesa (Mesa's off-screen OpenGL with llvmpipe) as the oracle that pictures are compared with.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "scene.h"

namespace raster::conformance {

/// One OpenGL context. There is one a process, because Mesa reads its settings from the environment once.
class Oracle {
public:
    static Oracle& instance();
    ~Oracle();

    /// What the driver calls itself, as "Mesa 22.3.6" and "llvmpipe (LLVM 15.0.6, 128 bits)".
    std::string version() const;
    std::string renderer() const;

    Picture render(const Scene& scene);

    /// For tests that give OpenGL commands of their own: a target of this size is made current and cleared, `commands`
    /// run, and the picture is read.
    template <class Commands>
    Picture render(int width, int height, glm::vec4 clear_color, float clear_depth, const Commands& commands) {
        begin(width, height, clear_color, clear_depth);
        commands();
        return end();
    }

    /// A program from GLSL sources, compiled once. Attributes 0 to 2 are `position`, `color` and `uv`.
    unsigned program(const std::string& vertex, const std::string& fragment);

    /// Makes a texture current in a texture unit.
    static void bind_texture(const TextureView& texture, unsigned unit);

    /// Sets what a State says, on a target of this height.
    static void apply(const State& state, int width, int height);

private:
    std::string string(unsigned name) const;
    Oracle();
    void begin(int width, int height, glm::vec4 clear_color, float clear_depth);
    Picture end();
    void draw(const Draw& draw, int width, int height);

    void* context_ = nullptr;
    int width_ = 0, height_ = 0;
    std::vector<std::uint32_t> buffer_;
    std::map<std::string, unsigned> programs_;
};

}  // namespace raster::conformance
