// limit.cpp: the loops, by the library's packs of lanes and its blend.
#include "limit.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cstring>

#include <raster/lanes.h>
#include <raster/stages/blend.h>

namespace bench {

namespace {

using raster::FloatN;
using raster::IntN;
using raster::load_int;
using raster::store_int;

constexpr int side = 64, pixels = side * side;
constexpr std::int32_t farthest = 0xffffff;

void store_all(std::int32_t* to, int count, std::int32_t value) {
    int i = 0;
    for (; i + raster::native_lanes <= count; i += raster::native_lanes) store_int(to + i, IntN(value));
    for (; i < count; ++i) to[i] = value;
}

}  // namespace

Limit::Limit(const Scene& scene, int width, int height)
    : width_(width),
      height_(height),
      layers_(int(scene.indices.size() / 6)),
      front_to_back_(scene.name == "s6f") {
    if (scene.name == "clear") kind_ = Kind::clear;
    if (scene.name == "fill") kind_ = Kind::fill;
    if (scene.name == "s6b" || scene.name == "s6f") kind_ = Kind::tested;
    if (scene.name == "s6a") kind_ = Kind::blended;
    if (!known()) return;
    color_.resize(std::size_t(width) * std::size_t(height));
    depth_.resize(color_.size());
}

void Limit::write_rows(int first, int count) {
    const std::size_t at = std::size_t(first) * std::size_t(width_);
    store_all(color_.data() + at, count * width_, 0x1234567);
    if (kind_ == Kind::fill) store_all(depth_.data() + at, count * width_, 0x123456);
}

/// The layers are no constants to the compiler, which could else leave some out.
void Limit::tile(int x, int y) {
    alignas(64) std::int32_t color[pixels], depth[pixels];
    store_all(color, pixels, 0);
    store_all(depth, pixels, farthest);
    for (int layer = 0; layer < layers_; ++layer) {
        IntN source(std::int32_t(0x80000000u) + layer * 0x10203), z(front_to_back_ ? layer : layers_ - layer);
        if (kind_ == Kind::blended) {
            for (int i = 0; i < pixels; i += raster::native_lanes)
                store_int(color + i, blend_rgba8(raster::Blend::source_over, source, load_int<FloatN>(color + i)));
        } else {
            for (int i = 0; i < pixels; i += raster::native_lanes) {
                IntN before = load_int<FloatN>(depth + i);
                store_int(depth + i, select(z < before, z, before));
                store_int(color + i, select(z < before, source, load_int<FloatN>(color + i)));
            }
        }
        asm volatile("" : : "r"(color), "r"(depth) : "memory");
    }
    const int columns = std::min(side, width_ - x), rows = std::min(side, height_ - y);
    for (int row = 0; row < rows; ++row) {
        const std::size_t at = std::size_t(y + row) * std::size_t(width_) + std::size_t(x);
        std::memcpy(color_.data() + at, color + row * side, std::size_t(columns) * sizeof(std::int32_t));
        std::memcpy(depth_.data() + at, depth + row * side, std::size_t(columns) * sizeof(std::int32_t));
    }
}

void Limit::frame() {
    const int across = (width_ + side - 1) / side, down = (height_ + side - 1) / side;
    if (kind_ == Kind::clear || kind_ == Kind::fill) {
        tbb::parallel_for(0, down, [&](int i) { write_rows(i * side, std::min(side, height_ - i * side)); });
    } else {
        tbb::parallel_for(0, across * down, [&](int i) { tile(i % across * side, i / across * side); });
    }
}

}  // namespace bench
