// obj_dedup.h: a table in which equal values find each other.
#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <vector>

namespace raster::obj {

/// Of types without padding, whose sizes are multiples of four.
template <class T>
bool same_bits(const T& a, const T& b) {
    static_assert(sizeof(T) % sizeof(std::uint32_t) == 0);
    constexpr std::size_t words = sizeof(T) / sizeof(std::uint32_t);
    std::uint32_t first[words], second[words], difference = 0;
    std::memcpy(first, &a, sizeof(T)), std::memcpy(second, &b, sizeof(T));
    for (std::size_t i = 0; i < words; ++i) difference |= first[i] ^ second[i];
    return difference == 0;
}

/// Gives equal values the same number. The values stand in a vector of the caller's; the table holds their numbers
/// only (open addressing, at most half full). T is compared bit by bit: it has no padding, and -0 differs from 0.
template <class T>
class Dedup {
public:
    /// Makes room for `expected` values; more can come.
    explicit Dedup(std::vector<T>& values, std::size_t expected = 0)
        : values_(values), slots_(std::bit_ceil(std::max<std::size_t>(1024, 2 * expected + 2)), empty) {}

    /// The number of `value` in the vector; it is appended if it is new.
    std::uint32_t operator()(const T& value) {
        if (2 * values_.size() >= slots_.size()) grow();
        std::size_t slot = hash(value) & (slots_.size() - 1);
        while (slots_[slot] != empty) {
            if (same_bits(values_[slots_[slot]], value)) return slots_[slot];
            slot = (slot + 1) & (slots_.size() - 1);
        }
        slots_[slot] = std::uint32_t(values_.size());
        values_.push_back(value);
        return slots_[slot];
    }

    /// Asks memory for what the search for `value` will read. Most of its time it would wait for that.
    void ask_ahead([[maybe_unused]] const T& value) const {
#if defined(__GNUC__)
        __builtin_prefetch(&slots_[hash(value) & (slots_.size() - 1)]);
#endif
    }

private:
    static constexpr std::uint32_t empty = 0xffffffffu;

    // Multiplication mixes upwards only, so the high half is folded down after each word.
    static std::size_t hash(const T& value) {
        std::uint32_t words[sizeof(T) / sizeof(std::uint32_t)];
        std::memcpy(words, &value, sizeof(T));
        std::uint64_t h = 0x9e3779b97f4a7c15u;
        for (const std::uint32_t word : words) {
            h = (h ^ word) * 0xbf58476d1ce4e5b9u;
            h ^= h >> 32;
        }
        return std::size_t(h);
    }

    void grow() {
        std::vector<std::uint32_t> larger(4 * slots_.size(), empty);
        slots_.swap(larger);
        for (std::uint32_t i = 0; i < values_.size(); ++i) {
            std::size_t slot = hash(values_[i]) & (slots_.size() - 1);
            while (slots_[slot] != empty) slot = (slot + 1) & (slots_.size() - 1);
            slots_[slot] = i;
        }
    }

    std::vector<T>& values_;
    std::vector<std::uint32_t> slots_;
};

}  // namespace raster::obj
