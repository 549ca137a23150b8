// hash.cpp: FNV-1a over a target's colours.
#include "hash.h"

#include <bit>
#include <cstdio>

namespace raster::tool {
namespace {

struct Fnv1a {
    std::uint64_t state = 0xcbf29ce484222325u;
    void add(std::uint32_t word) {
        for (int shift = 0; shift < 32; shift += 8) state = (state ^ (word >> shift & 255)) * 0x100000001b3u;
    }
};

}  // namespace

std::string content_hash(const Target& target) {
    Fnv1a hash;
    hash.add(std::uint32_t(target.width()));
    hash.add(std::uint32_t(target.height()));
    if (target.color_format() == ColorFormat::rgba8) {
        for (const std::uint32_t color : target.color8()) hash.add(color);
    } else {
        for (const glm::vec4& color : target.color_float())
            for (int channel = 0; channel < 4; ++channel) hash.add(std::bit_cast<std::uint32_t>(color[channel]));
    }
    char text[20];
    std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(hash.state));
    return text;
}

}  // namespace raster::tool
