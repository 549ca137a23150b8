// triangle.cpp: a stranger's program: its own shader, one triangle, and the hash of the picture.
#include <cstdint>
#include <cstdio>
#include <vector>

#include <raster/raster.h>

namespace {

struct Colored {
    template <class F>
    struct Vertex {
        raster::vec<3, F> position, color;
    };
    template <class F>
    struct Varyings {
        raster::vec<3, F> color;
    };
    template <class F>
    raster::VertexOut<F, Varyings> vertex(const Vertex<F>& v) const {
        return {raster::vec<4, F>(v.position, F(1)), {v.color}};
    }
    template <class F>
    raster::vec<4, F> fragment(const Varyings<F>& in) const {
        return raster::vec<4, F>(in.color, F(1));
    }
};

/// FNV-1a over the colour plane.
std::uint64_t hash(const raster::Target& target) {
    std::uint64_t h = 14695981039346656037u;
    for (const std::uint32_t pixel : target.color8())
        for (int shift = 0; shift < 32; shift += 8) h = (h ^ ((pixel >> shift) & 255u)) * 1099511628211u;
    return h;
}

}  // namespace

int main() {
    const std::vector<Colored::Vertex<float>> corners = {
        {{-0.8f, -0.6f, 0.0f}, {1, 0, 0}}, {{0.9f, -0.4f, 0.0f}, {0, 1, 0}}, {{0.1f, 0.7f, 0.0f}, {0, 0, 1}}};
    raster::Target target(120, 80);
    target.clear({0, 0, 0, 1});
    const raster::DrawCounts counts = raster::draw(target, Colored{}, {corners});

    const std::uint64_t expected = 0x82dd53d869306534;
    const std::uint64_t found = hash(target);
    std::printf("%lld triangle drawn, picture %016llx, expected %016llx\n", static_cast<long long>(counts.drawn),
                static_cast<unsigned long long>(found), static_cast<unsigned long long>(expected));
    return counts.drawn == 1 && found == expected ? 0 : 1;
}
