// random.h: a small seeded generator, since the standard distributions differ between libraries.
#pragma once

#include <cstdint>

namespace raster::testing {

/// SplitMix64 (Steele, Lea, Flood 2014). The same numbers on every compiler.
class Random {
public:
    explicit Random(std::uint64_t seed) : state_(seed) {}

#if defined(__wasm__)
    [[gnu::noinline]]  // clang 14 loads a state for two lanes after it has stored the next one over it
#endif
    std::uint64_t bits() {
        std::uint64_t z = (state_ += 0x9e3779b97f4a7c15u);
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
        z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
        return z ^ (z >> 31);
    }
    /// In [low, high), in steps of 2^-24 of the range.
    float uniform(float low, float high) {
        const float unit = float(bits() >> 40) * (1.0f / 16777216.0f);
        return low + (high - low) * unit;
    }
    /// In [low, high], both included.
    int integer(int low, int high) { return low + int(bits() % std::uint64_t(high - low + 1)); }

private:
    std::uint64_t state_;
};

}  // namespace raster::testing
