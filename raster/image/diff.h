// diff.h: whether an actual picture may stand for an expected one: figures, gates, verdict, and what would pass.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <raster/image/decode.h>
#include <raster/image/flip.h>
#include <raster/image/image.h>
#include <raster/result.h>

namespace raster {

/// Pixels x to x + width - 1 of rows y to y + height - 1.
struct PixelRect {
    int x = 0, y = 0, width = 0, height = 0;
    friend bool operator==(const PixelRect&, const PixelRect&) = default;
};

/// How far pictures may be apart and still pass. Without any, not at all. All that are given must be met.
struct Gates {
    /// Largest difference of a sample, in its own steps: of 255 for 8 bits, of 65535 for 16 bits; floats as they are.
    std::optional<double> max_delta = {};
    /// How many pixels may differ by more than that.
    std::optional<std::int64_t> max_pixels = {};
    /// Edge noise: a pixel also passes if within so many pixels (a square around it, at most 16) the expected picture
    /// has the actual colour, and the actual picture the expected one; up to max_delta.
    std::optional<int> max_shift = {};
    /// Largest mean FLIP, 0 to 1. Given alone, it is all that is asked.
    std::optional<double> flip = {};

    friend bool operator==(const Gates&, const Gates&) = default;
};

/// As options of the command: "--max-delta 2 --max-pixels 10"; "exact" if there are none.
std::string to_string(const Gates& gates);

enum class FlipDetail {
    none,    ///< at most what the mean needs
    steps,   ///< what flip_picture shows
    errors,  ///< Diff::flip_map
};

struct DiffOptions {
    Gates gates;
    /// Pixels that do not count; they may reach beyond the picture.
    std::vector<PixelRect> ignored;
    /// Empty, or of the pictures' size: a pixel counts where it is at least half bright (and, where there is alpha, half
    /// opaque). Draw black what is to be ignored.
    Image8 mask;
    float pixels_per_degree = default_pixels_per_degree;  ///< for FLIP, 5 to 500
    /// What is kept of FLIP beside its mean: less takes less time.
    FlipDetail flip_detail = FlipDetail::errors;
};

enum class Verdict {
    same,           ///< every sample that counts is equal
    tolerated,      ///< there are differences, within the gates
    different,      ///< beyond the gates
    size_mismatch,  ///< width or height differ
    type_mismatch,  ///< whole numbers against floats
    not_a_number,   ///< one of the pictures has a NaN
    unreadable,     ///< one of the files is no picture, or cannot be read
    missing,        ///< there is an expected picture and no actual one
    added,          ///< there is an actual picture and no expected one
};

/// In words, for people and files: "same", "size mismatch", ...
const char* to_string(Verdict verdict);
inline bool passes(Verdict verdict) { return verdict == Verdict::same || verdict == Verdict::tolerated; }

/// All figures, always together. Differences are in the samples' own steps; see metrics.h and flip.h.
struct Figures {
    std::int64_t compared = 0;   ///< pixels that count
    std::int64_t differing = 0;  ///< of these, pixels with any difference
    std::int64_t failing = 0;    ///< of these, pixels beyond max_delta that no shift explains
    double max = 0;
    int max_x = 0, max_y = 0;
    double mean = 0, rms = 0, psnr = 0, ssim = 1, flip = 0;
};

/// Pixels that fail (or, if none does, differ) near each other.
struct DiffRegion {
    PixelRect box;
    std::int64_t pixels = 0;
    float max_delta = 0;
    int max_x = 0, max_y = 0;
};

struct Diff {
    Verdict verdict = Verdict::same;
    std::string reason;              ///< of a verdict that is about the whole picture, in words
    std::optional<Figures> figures;  ///< where pixels could be compared
    /// The tightest gates that would pass, as alternatives; if the verdict is `different`.
    std::vector<Gates> would_pass;
    std::vector<std::string> warnings;  ///< gates far looser than needed
    std::vector<std::string> notes;     ///< what was adapted in order to compare: channels, bits
    std::vector<DiffRegion> regions;    ///< those with most pixels first, at most 64
    std::int64_t region_count = 0;      ///< all of them

    /// For pictures of the differences. One channel each, empty where nothing differs or all pixels count.
    ImageF deltas;    ///< the difference of each pixel after shifting, largest over its channels
    ImageF flip_map;   ///< the FLIP error of each pixel; may be empty unless FlipDetail::errors is asked for
    Image8 flip_steps;  ///< FlipDetail::steps: the same in steps of 1/31, rounded up, if there is no flip_map
    Image8 compared;  ///< 0 where a pixel does not count, else 1
    float allowed_delta = 0;  ///< pixels above this fail
};

/// Compares two pictures. Grey is compared with colour as colour, a picture without alpha counts as opaque, 8 bits
/// against 16 are widened by 257; notes tell of it. Colours under ignored pixels are not looked at at all.
/// Errors: usage for options out of their range, a mask of another size, or when no pixel is left to compare;
/// input_output if memory runs out. The same result for every number of threads.
Result<Diff> diff_images(const AnyImage& expected, const AnyImage& actual, const DiffOptions& options = {});

}  // namespace raster
