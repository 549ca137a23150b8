// ours.h: the benchmark's scenes drawn by this library, through its public interface, as a user's program would.
#pragma once

#include <vector>

#include <raster/raster.h>
#include <raster/scene/model.h>
#include <raster/shading/texture.h>

#include "scenes.h"

namespace bench {

/// One scene, size and set of buffers; frame() goes from clear to finished pixels in memory.
class Ours {
public:
    Ours(const Scene& scene, int width, int height);
    void frame();
    const std::vector<std::uint32_t>& color() { return target_.color8(); }
    const std::vector<std::uint32_t>& depth() { return target_.depth(); }
    /// What the library keeps between frames besides the target's planes.
    std::size_t scratch_bytes() { return target_.scratch().bytes(); }

private:
    void draw_reflectance(const raster::State& state);

    const Scene& scene_;
    raster::Target target_;
    glm::mat4 clip_from_eye_, clip_from_world_;
    glm::mat3 normals_;
    std::vector<raster::SurfaceVertex<float>> surface_;  ///< the scene's vertices, for the library's shaders
};

}  // namespace bench
