// png_filters.cpp: the five filters of PNG (https://www.w3.org/TR/png/), undone several rows at once.
#include <raster/image/png_filters.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <vector>

namespace raster {
namespace {

using Byte = std::uint8_t;

// The bytes of a pixel, widened so that their sums fit: 8 at most, the rest is 0.
using Wide = std::int16_t __attribute__((vector_size(16)));

using Narrow = Byte __attribute__((vector_size(8)));

// Through a register: a vector read back right after its bytes were written one by one makes the processor wait.
template <int step>
Wide load_pixel(const Byte* from) {
    std::uint64_t bytes = 0;
    if constexpr (step == 3 || step == 6) {
        std::uint32_t low = 0;
        std::uint16_t high = 0;
        std::memcpy(&low, from, step - 2);
        std::memcpy(&high, from + step - 2, 2);
        bytes = std::uint64_t(high) << (8 * (step - 2)) | low;
    } else {
        std::memcpy(&bytes, from, step);
    }
    return __builtin_convertvector(std::bit_cast<Narrow>(bytes), Wide);
}

template <int step>
void store_pixel(Byte* to, Wide pixel) {
    const auto bytes = std::bit_cast<std::uint64_t>(__builtin_convertvector(pixel, Narrow));
    std::memcpy(to, &bytes, step);
}

/// The neighbour of left, above and above-left that is nearest to left + above - above-left (PNG, 9.4).
Wide paeth(Wide left, Wide above, Wide corner) {
    const auto absolute = [](Wide x) { return x > -x ? x : -x; };
    const Wide from_left = absolute(above - corner), from_above = absolute(left - corner);
    const Wide from_corner = absolute(left + above - 2 * corner);
    const Wide nearer = from_above < from_left ? above : left;
    const Wide distance = from_above < from_left ? from_above : from_left;
    return from_corner < distance ? corner : nearer;
}

/// A row of the filters Average, 3, or Paeth, 4, undone from left to right (PNG, 9.2).
template <int step, int filter>
struct Predicted {
    Wide left{}, corner{};
    Wide next(Wide in, Wide above) {
        left = (in + (filter == 4 ? paeth(left, above, corner) : (left + above) >> 1)) & 0xff;
        corner = above;
        return left;
    }
};

using Chunk = Byte __attribute__((vector_size(32)));

// step is the bytes of a pixel: a constant, so that the compiler keeps the pixel to the left in registers. `out` may be
// `in` or lie before it.
template <int step>
bool undo_filter(int filter, const Byte* in, const Byte* above, Byte* out, std::size_t size) {
    std::array<Byte, step> left{};
    std::size_t i = 0;
    switch (filter) {
        case 0: std::memmove(out, in, size); return true;
        case 1:
            for (; i < size; i += step)
                for (int c = 0; c < step; ++c) out[i + c] = left[c] = Byte(in[i + c] + left[c]);
            return true;
        case 2:
            for (Chunk here, up; i + sizeof here <= size; i += sizeof here) {
                std::memcpy(&here, in + i, sizeof here);
                std::memcpy(&up, above + i, sizeof up);
                here += up;
                std::memcpy(out + i, &here, sizeof here);
            }
            for (; i < size; ++i) out[i] = Byte(in[i] + above[i]);
            return true;
        case 3:
            for (; i < size; i += step)
                for (int c = 0; c < step; ++c)
                    out[i + c] = left[c] = Byte(in[i + c] + ((left[c] + above[i + c]) >> 1));
            return true;
        case 4:
            for (Predicted<step, 4> row; i < size; i += step)
                store_pixel<step>(out + i, row.next(load_pixel<step>(in + i), load_pixel<step>(above + i)));
            return true;
        default: return false;
    }
}

/// Two rows of one filter, 3 or 4, the second a pixel behind the first: each pixel waits for the one to its left, so
/// that two rows take little longer than one. `out_2` must not lie in `in_1`.
template <int step, int filter>
void undo_two(const Byte* in_1, const Byte* in_2, const Byte* above, Byte* out_1, Byte* out_2, std::size_t size) {
    Predicted<step, filter> first, second;
    Wide previous = first.next(load_pixel<step>(in_1), load_pixel<step>(above));
    store_pixel<step>(out_1, previous);
    for (std::size_t i = step; i < size; i += step) {
        const Wide pixel = first.next(load_pixel<step>(in_1 + i), load_pixel<step>(above + i));
        store_pixel<step>(out_2 + i - step, second.next(load_pixel<step>(in_2 + i - step), previous));
        store_pixel<step>(out_1 + i, pixel);
        previous = pixel;
    }
    store_pixel<step>(out_2 + size - step, second.next(load_pixel<step>(in_2 + size - step), previous));
}

// Of small pixels, a register holds two: one of a row and one of the next.

/// `low` and `high` pixels side by side.
Wide both(std::uint32_t low, std::uint32_t high) {
    return __builtin_convertvector(std::bit_cast<Narrow>(std::uint64_t(high) << 32 | low), Wide);
}

/// Four rows, each a pixel behind the one above it.
template <int step>
class FourRows {
public:
    /// `size` bytes a row.
    explicit FourRows(std::size_t size) : size_(size) {
        for (std::vector<Byte>& copy : copies_) copy.resize(size + 4);
    }

    /// in[0 to 3] are led by their filters' numbers, of which there are 0 to 4.
    void undo(const Byte* const* in, const Byte* above, Byte* const* out) {
        // Copies, since rows go where the bytes of those before them end.
        for (std::size_t k = 0; k < 4; ++k) std::memcpy(copies_[k].data(), in[k] + 1, size_);
        const auto all_are = [&](Byte filter) {
            return std::all_of(in, in + 4, [&](const Byte* row) { return row[0] == filter; });
        };
        if (all_are(3))
            return undo(above, out, [](Wide left, Wide above, Wide, int) { return (left + above) >> 1; });
        if (all_are(4))
            return undo(above, out, [](Wide left, Wide above, Wide corner, int) { return paeth(left, above, corner); });
        Wide masks[4][2] = {};
        for (std::size_t k = 0; k < 4; ++k)
            for (int lane = 0; in[k][0] > 0 && lane < 4; ++lane)
                masks[in[k][0] - 1][k / 2][int(k % 2) * 4 + lane] = -1;
        undo(above, out, [masks](Wide left, Wide above, Wide corner, int pair) {
            return (left & masks[0][pair]) | (above & masks[1][pair]) | ((left + above) >> 1 & masks[2][pair]) |
                   (paeth(left, above, corner) & masks[3][pair]);
        });
    }

private:
    template <class Predict>
    void undo(const Byte* above, Byte* const* out, const Predict& predict) {
        State state;
        const std::ptrdiff_t size = std::ptrdiff_t(size_);
        std::ptrdiff_t i = 0;
        for (; i < 3 * step; i += step) advance<true>(state, i, above, out, predict);
        for (; i + 4 <= size; i += step) advance<false>(state, i, above, out, predict);
        for (; i < size + 3 * step; i += step) advance<true>(state, i, above, out, predict);
    }

    struct State {
        Wide left[2] = {}, corner[2] = {};
    };

    /// One pixel of each row; at i of the first.
    template <bool at_ends, class Predict>
    void advance(State& state, std::ptrdiff_t i, const Byte* above, Byte* const* out, const Predict& predict) const {
        const auto pixel = [&](const Byte* row, std::ptrdiff_t at) {
            std::uint32_t bytes = 0;
            if (!at_ends)
                std::memcpy(&bytes, row + at, 4);
            else if (at >= 0 && at < std::ptrdiff_t(size_))
                std::memcpy(&bytes, row + at, step);
            return bytes;
        };
        const auto in = [&](int k) { return pixel(copies_[k].data(), i - k * step); };
        const Wide first = state.left[0], second = state.left[1];
        const Wide loaded = both(pixel(above, i), 0);
        const Wide over[2] = {__builtin_shufflevector(loaded, first, 0, 1, 2, 3, 8, 9, 10, 11),
                              __builtin_shufflevector(first, second, 4, 5, 6, 7, 8, 9, 10, 11)};
        for (int pair = 0; pair < 2; ++pair) {
            const Wide predicted = predict(state.left[pair], over[pair], state.corner[pair], pair);
            state.left[pair] = (both(in(2 * pair), in(2 * pair + 1)) + predicted) & 0xff;
            state.corner[pair] = over[pair];
            const auto bytes = std::bit_cast<std::uint64_t>(__builtin_convertvector(state.left[pair], Narrow));
            for (int k = 0; k < 2; ++k) {
                const auto value = std::uint32_t(bytes >> (32 * k));
                const std::ptrdiff_t at = i - (2 * pair + k) * step;
                // Bytes beyond the pixel are of the next one, which comes later.
                if (!at_ends)
                    std::memcpy(out[2 * pair + k] + at, &value, 4);
                else if (at >= 0 && at < std::ptrdiff_t(size_))
                    std::memcpy(out[2 * pair + k] + at, &value, step);
            }
        }
    }

    std::size_t size_;
    std::array<std::vector<Byte>, 4> copies_;
};

template <int step>
bool undo_filters(const Byte* in, std::size_t row_bytes, std::uint32_t height, Byte* out, std::size_t stride) {
    const std::vector<Byte> zeros(row_bytes);
    const Byte* above = zeros.data();
    const auto waits = [](int filter) { return filter == 3 || filter == 4; };
    [[maybe_unused]] FourRows<std::min(step, 4)> four(row_bytes);
    [[maybe_unused]] std::vector<Byte> first(row_bytes);
    for (std::uint32_t y = 0; y < height; ++y, in += 1 + row_bytes, out += stride) {
        if constexpr (step <= 4) {
            const Byte* const ins[4] = {in, in + (1 + row_bytes), in + 2 * (1 + row_bytes), in + 3 * (1 + row_bytes)};
            const auto known = [](const Byte* row) { return row[0] <= 4; };
            if (height - y >= 4 && waits(in[0]) && std::all_of(ins, ins + 4, known)) {
                Byte* const outs[4] = {out, out + stride, out + 2 * stride, out + 3 * stride};
                four.undo(ins, above, outs);
                y += 3, in = ins[3], out = outs[3], above = out;
                continue;
            }
        } else if (const Byte* const next = in + 1 + row_bytes; height - y >= 2 && in[0] == next[0] && waits(in[0])) {
            // A copy, since the second row goes where the first one's bytes end.
            std::memcpy(first.data(), in + 1, row_bytes);
            Byte* const below = out + stride;
            (in[0] == 3 ? undo_two<step, 3> : undo_two<step, 4>)(first.data(), next + 1, above, out, below, row_bytes);
            ++y, in = next, out = below, above = below;
            continue;
        }
        if (!undo_filter<step>(in[0], in + 1, above, out, row_bytes)) return false;
        above = out;
    }
    return true;
}

}  // namespace

bool undo_png_filters(int step, const Byte* in, std::size_t row_bytes, std::uint32_t height, Byte* out,
                      std::size_t out_stride) {
    switch (step) {
        case 1: return undo_filters<1>(in, row_bytes, height, out, out_stride);
        case 2: return undo_filters<2>(in, row_bytes, height, out, out_stride);
        case 3: return undo_filters<3>(in, row_bytes, height, out, out_stride);
        case 4: return undo_filters<4>(in, row_bytes, height, out, out_stride);
        case 6: return undo_filters<6>(in, row_bytes, height, out, out_stride);
        default: return undo_filters<8>(in, row_bytes, height, out, out_stride);
    }
}

}  // namespace raster
