// scenes.h: what the library must draw with the same bytes on every machine, each scene as one number.
#pragma once

#include <bit>
#include <cstdint>
#include <cstdio>
#include <functional>
#include <string>
#include <vector>

#include <raster/target.h>

namespace raster::everywhere {

/// FNV-1a, 64 bits, over words. All NaNs count as one: which of them an operation gives is the processor's choice.
class Hash {
public:
    void add(std::uint32_t word) {
        for (int shift = 0; shift < 32; shift += 8) value_ = (value_ ^ (word >> shift & 255)) * 0x100000001b3u;
    }
    void add(float x) { add(x == x ? std::uint32_t(as_int(x)) : 0x7fc00000u); }
    /// Every plane of a target.
    void add(const Target& target) {
        add(std::uint32_t(target.width()));
        add(std::uint32_t(target.height()));
        for (const std::uint32_t color : target.color8()) add(color);
        for (const glm::vec4& color : target.color_float())
            for (int c = 0; c < 4; ++c) add(color[c]);
        for (const std::uint32_t depth : target.depth()) add(depth);
        for (int e = 0; e < target.extra_channels(); ++e)
            for (const float value : target.extra(e)) add(value);
    }
    void add(const DrawCounts& counts) {
        for (const std::int64_t n : {counts.submitted, counts.bad_index, counts.not_finite, counts.outside,
                                     counts.culled, counts.zero_area, counts.drawn})
            add(std::uint32_t(n));
    }
    std::uint64_t value() const { return value_; }

private:
    std::uint64_t value_ = 0xcbf29ce484222325u;
};

struct Scene {
    std::string name;
    std::function<void(Hash&)> draw;
};

/// In hexadecimal, as in hashes.txt.
inline std::string hash_of(const Scene& scene) {
    Hash hash;
    scene.draw(hash);
    char text[20];
    std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(hash.value()));
    return text;
}

/// The pipeline's stages and state, with small shaders; lights, materials and models; the files in `models`, a folder.
std::vector<Scene> stage_scenes();
std::vector<Scene> model_scenes();
std::vector<Scene> file_scenes(const std::string& models);

}  // namespace raster::everywhere
