// metrics_rows.h: weighted sums of rows of floats, the one loop in which image metrics spend their time.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace raster {

/// Rows are summed in pieces of so many floats; buffers are padded to a multiple.
inline constexpr int row_block = 32;

/// Zeros at an address that is a multiple of the widest register: a load or store that spans two cache lines takes
/// twice the time.
class AlignedFloats {
public:
    static constexpr std::size_t alignment = 64;
    explicit AlignedFloats(std::size_t count) : values_(count + alignment / sizeof(float)) {
        void* first = values_.data();
        std::size_t room = values_.size() * sizeof(float);
        first_ = static_cast<float*>(std::align(alignment, count * sizeof(float), first, room));
    }
    AlignedFloats(AlignedFloats&&) = default;
    float* data() { return first_; }

private:
    std::vector<float> values_;
    float* first_;  ///< stays where it is when the vector moves
};

/// A filter along x or y by one half of its weights: weights[0] is for the middle, weights[k] for k steps away.
enum class FilterSymmetry {
    even,  ///< both sides have the same weight
    odd,   ///< what lies before counts negative; weights[0] is not used
};

/// out[i] = the weighted sum of rows[radius + k][i] over k = -radius to radius, for i = 0 to count - 1 rounded up to
/// whole blocks; with `add`, out[i] is added to. radius = weights.size() - 1 and `rows` has 2 radius + 1 pointers:
/// rows of a picture, or one row at different places. Uses the processor's widest registers, whatever the
/// program was compiled for; the sums are made in one order and have the same bits everywhere.
void filter_rows(FilterSymmetry symmetry, const std::vector<float>& weights, const float* const* rows, int count,
                 float* out, bool add = false);

/// An even filter along y for rows_at_once rows of the picture at once, so that each row is loaded once for all of
/// them: out[o][i] = the weighted sum of rows[o + radius + k][i]. `rows` has 2 radius + rows_at_once pointers; at most
/// most_weights weights.
inline constexpr int rows_at_once = 4, most_weights = 128;
void filter_columns(const std::vector<float>& weights, const float* const* rows, int count, float* const* out,
                    bool add = false);

/// Several sums of filter_rows over the same rows at once, which saves loads: of two even filters; an odd and an even
/// one; an even, an odd and an even one. The same bits as one after the other. All have as many weights.
void filter_rows_even_even(const std::vector<float>& weights_1, const std::vector<float>& weights_2,
                           const float* const* rows, int count, float* out_1, float* out_2);
void filter_rows_odd_even(const std::vector<float>& odd, const std::vector<float>& even, const float* const* rows,
                          int count, float* out_odd, float* out_even);
void filter_rows_even_odd_even(const std::vector<float>& even_1, const std::vector<float>& odd,
                               const std::vector<float>& even_2, const float* const* rows, int count, float* out_1,
                               float* out_odd, float* out_2);

/// Adds values[i] to sums[i % sum_parts]: sums side by side need not wait for each other. False if a value is above 0
/// and below `least`. `values` has room for a multiple of sum_parts, and what it has there is lost.
inline constexpr int sum_parts = 8;
bool add_in_parts(float* values, int count, float least, double* sums);

/// Luma (ITU-R BT.601), 0 to 1, of pixels of three bytes.
void luma_of_bytes(const std::uint8_t* rgb, int count, float* luma);

}  // namespace raster
