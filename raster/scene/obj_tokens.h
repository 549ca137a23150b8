// obj_tokens.h: the words of an OBJ or MTL statement as numbers.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

namespace raster::obj {

/// The float nearest to a decimal number such as -1, +.5, 2. or 1.5e-3. A number too large gives infinity, one too
/// small 0; anything else NaN, "nan" and "inf" included: what is not finite is no number.
///
/// tinyobjloader's own numbers are not used: it takes "nan" for 0 and 1e999 for a number, and rounds by way of the
/// C library's pow, whose last bits differ between machines.
float parse_number(std::string_view word);

/// Up to 8 numbers from the words of a statement, and how many words there were.
struct Numbers {
    float value[8] = {};
    int count = 0;
    std::string_view first_bad;  ///< the first word that gave no finite number

    bool finite() const { return first_bad.empty(); }
};
Numbers parse_numbers(std::string_view words);

/// Reads the words up to the end of the line into `numbers`, which is empty. The end, or null if one of them has to be
/// read by parse_number: more than 15 digits, an exponent, or no number. Quick, for most numbers are so.
const char* read_plain_numbers(const char* at, const char* end, Numbers& numbers);

/// The indices of a face's corner. As they are written: from 1 on, or counting back from -1; 0 is missing.
struct Corner {
    std::int32_t position, uv, normal;
};

/// The parts of a face's corner: 7, 7/2, 7//3 or 7/2/3.
struct CornerWord {
    enum class Index { missing, good, bad };  ///< bad: no integer, 0, or beyond 31 bits
    std::string_view part[3];                 ///< position, texture coordinate, normal
    Index state[3] = {};
    std::int32_t index[3] = {};  ///< 0 for one that is not good
    bool well_formed = false;    ///< at most three parts, the first not empty
};
CornerWord parse_corner(std::string_view word);

/// Appends the corners in the words up to the end of the line. The end, or null, and some corners, if they are not such
/// that parse_corner finds nothing to say about them: well-formed, with good indices of at most 9 digits without leading
/// zeros, and no slash at their ends. Quick, for most faces are so. The first word starts at once.
const char* read_plain_corners(const char* at, const char* end, std::vector<Corner>& corners);

/// A statement without the comment at its end, which starts with # after a blank.
std::string_view without_comment(std::string_view text);

}  // namespace raster::obj
