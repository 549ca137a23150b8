// osmesa.h: OSMesa (Mesa's off-screen OpenGL with llvmpipe) as the oracle that pictures are compared with.
#pragma once

#include <map>
#include <memory>
#include <string>

#include "opengl.h"
#include "scene.h"

namespace raster::conformance {

/// One OpenGL context. There is one a process, because Mesa reads its settings from the environment once.
class Oracle {
public:
    static Oracle& instance();

    /// What the driver calls itself, as "Mesa 22.3.6, llvmpipe (LLVM 15.0.6, 128 bits)".
    std::string version();

    Picture render(const Scene& scene);

private:
    Oracle();
    void draw(const Draw& draw);
    /// A program from GLSL sources, compiled once. Attributes 0 to 2 are `position`, `color` and `uv`.
    unsigned program(const std::string& vertex, const std::string& fragment);

    std::unique_ptr<tool::OpenGl> gl_;
    std::map<std::string, unsigned> programs_;
};

}  // namespace raster::conformance
