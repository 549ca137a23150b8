// rival.h: the same scenes drawn by Mesa's llvmpipe through OSMesa.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "scenes.h"

namespace bench {

/// Whether there is GLSL for a reflectance model.
bool has_glsl(const std::string& reflectance);

/// One scene, size and context. The vertex arrays live in buffer objects; frame() goes from clear to finished pixels.
/// LP_NUM_THREADS is read when the first context of a process is made: 0 rasterizes in the calling thread.
class Rival {
public:
    Rival(const Scene& scene, int width, int height);
    ~Rival();
    Rival(const Rival&) = delete;
    Rival& operator=(const Rival&) = delete;

    bool ok() const { return error_.empty(); }
    const std::string& error() const { return error_; }
    std::string version() const;
    void frame();
    /// Row 0 on top. Depth is 24 bits.
    const std::vector<std::uint32_t>& color() const { return color_; }
    std::vector<std::uint32_t> depth();

private:
    const Scene& scene_;
    int width_, height_;
    std::vector<std::uint32_t> color_;
    void* context_ = nullptr;
    unsigned program_ = 0;
    int index_count_ = 0;
    std::string error_;
};

}  // namespace bench
