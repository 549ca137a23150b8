// diff_gates.cpp: the verdict, the tightest gates that would pass, and which given ones are far too loose.
#include <raster/image/diff_steps.h>

#include <algorithm>
#include <functional>

#include <raster/image/diff_words.h>
#include <raster/tiles/parallel.h>

namespace raster {

std::string to_string(const Gates& gates) {
    std::string words;
    const auto add = [&](const std::string& option, const std::string& value) {
        words += (words.empty() ? "" : " ") + option + " " + value;
    };
    if (gates.max_delta) add("--max-delta", exact_number(*gates.max_delta));
    if (gates.max_pixels) add("--max-pixels", std::to_string(*gates.max_pixels));
    if (gates.max_shift) add("--max-shift", std::to_string(*gates.max_shift));
    if (gates.flip) add("--flip", exact_number(*gates.flip));
    return words.empty() ? "exact" : words;
}

namespace diff_steps {
namespace {

/// How many pixels have which delta.
class Deltas {
public:
    /// Deltas of whole numbers, 0 to `most`, are counted when first asked for; those of floats are looked through again
    /// for each question. `figures`, if given, tell how many are above 0, and the largest: what is most often asked.
    Deltas(const ImageF& deltas, double most, bool whole_numbers, const Figures* figures)
        : deltas_(&deltas), most_(most), whole_numbers_(whole_numbers), figures_(figures) {}

    std::int64_t count_above(float limit) {
        if (figures_ != nullptr && limit == 0) return figures_->differing;
        count();
        if (counts_.empty())
            return std::count_if(deltas_->samples.begin(), deltas_->samples.end(), [=](float d) { return d > limit; });
        std::int64_t count = 0;
        for (std::size_t delta = counts_.size(); delta-- > 0 && float(delta) > limit;) count += counts_[delta];
        return count;
    }

    /// The smallest max_delta with which at most `allowed` pixels fail: the largest but `allowed`.
    float tightest(std::int64_t allowed) {
        if (figures_ != nullptr && allowed == 0) return float(figures_->max);
        count();
        if (!counts_.empty()) {
            std::int64_t above = 0;
            for (std::size_t delta = counts_.size(); delta-- > 1;)
                if ((above += counts_[delta]) > allowed) return float(delta);
            return 0;
        }
        std::vector<float> sorted;
        for (const float d : deltas_->samples)
            if (d > 0) sorted.push_back(d);
        if (std::int64_t(sorted.size()) <= allowed) return 0;
        const auto nth = sorted.begin() + std::ptrdiff_t(allowed);
        std::nth_element(sorted.begin(), nth, sorted.end(), std::greater<>());
        return *nth;
    }

private:
    void count() {
        const ImageF& deltas = *deltas_;
        if (!whole_numbers_ || deltas.empty() || !counts_.empty()) return;
        counts_.resize(std::size_t(most_) + 1);
        constexpr int bands = 16;
        std::vector<std::vector<std::uint32_t>> counts_of(bands);
        const auto first_row = [&](std::size_t band) {
            return int(std::int64_t(deltas.height) * std::int64_t(band) / bands);
        };
        tiles::parallel_for(bands, [&](std::size_t band) {
            std::vector<std::uint32_t>& counts = counts_of[band];
            counts.resize(counts_.size());
            const float* const end = deltas.pixel(0, 0) + std::ptrdiff_t(first_row(band + 1)) * deltas.width;
            for (const float* d = deltas.pixel(0, 0) + std::ptrdiff_t(first_row(band)) * deltas.width; d < end; ++d)
                ++counts[std::size_t(std::int32_t(*d))];
        });
        for (const auto& counts : counts_of)
            for (std::size_t delta = 0; delta < counts.size(); ++delta) counts_[delta] += counts[delta];
    }

    const ImageF* deltas_;
    double most_;
    bool whole_numbers_;
    const Figures* figures_;
    std::vector<std::int64_t> counts_;  ///< by delta; empty for floats
};

/// What each gate would have to be at the least, the others as given.
struct Needed {
    float max_delta;
    std::int64_t max_pixels;
    double flip;
};

std::vector<Gates> passing_alternatives(const AnyImage& expected, const AnyImage& actual, const Gates& given,
                                        const Needed& needed, bool pixels_pass, bool flip_passes, const Diff& diff) {
    Gates base = given;
    if (!flip_passes) base.flip = needed.flip;
    if (pixels_pass) return {base};

    std::vector<Gates> alternatives;
    Gates delta = base, pixels = base;
    delta.max_delta = needed.max_delta;
    pixels.max_pixels = needed.max_pixels;
    alternatives.push_back(delta);
    alternatives.push_back(pixels);
    // Cheap: it ends at the first pixel that has another reason.
    for (int radius = 1; radius <= 3 && !given.max_shift; ++radius) {
        if (!shift_explains_all(expected, actual, radius, diff.allowed_delta, diff.deltas)) continue;
        Gates shift = base;
        shift.max_shift = radius;
        alternatives.push_back(shift);
        break;
    }
    if (given == Gates{}) {
        Gates flip;
        flip.flip = needed.flip;
        alternatives.push_back(flip);
    }
    return alternatives;
}

/// Loose tolerances let ruined pictures pass, so what is not needed is told. A few steps of slack are no matter.
std::vector<std::string> loose_gates(const Gates& given, const Needed& needed, double peak, const Figures& figures,
                                     bool passes_unshifted) {
    std::vector<std::string> warnings;
    const auto warn = [&](const std::string& option, const std::string& value, const std::string& enough) {
        warnings.push_back(option + " " + value + " is far looser than needed: " + enough + " would pass");
    };
    constexpr double factor = 4;
    // Of max_delta sooner: it lets every pixel of the picture be so wrong.
    const double delta_slack = 4 * (peak == 1 ? 1.0 / 255 : 1.0);
    if (given.max_delta && *given.max_delta > 2 * double(needed.max_delta) + delta_slack)
        warn("--max-delta", exact_number(*given.max_delta), exact_number(double(needed.max_delta)));
    const double pixel_slack = std::max(16.0, 1e-4 * double(figures.compared));
    if (given.max_pixels && double(*given.max_pixels) > factor * double(needed.max_pixels) + pixel_slack)
        warn("--max-pixels", std::to_string(*given.max_pixels), std::to_string(needed.max_pixels));
    if (given.flip && *given.flip > factor * needed.flip + 0.01)
        warn("--flip", exact_number(*given.flip), exact_number(needed.flip));
    if (given.max_shift && *given.max_shift > 1 && passes_unshifted)
        warn("--max-shift", std::to_string(*given.max_shift), "0");
    return warnings;
}

}  // namespace

void judge(const AnyImage& expected, const AnyImage& actual, const Gates& gates, double peak, Diff& diff) {
    Figures& figures = *diff.figures;
    diff.allowed_delta = float(gates.max_delta.value_or(0));
    const std::int64_t allowed_pixels = gates.max_pixels.value_or(0);
    const bool whole_numbers = !std::holds_alternative<ImageF>(expected);
    Deltas deltas(diff.deltas, peak, whole_numbers, &figures);
    const std::int64_t failing_unshifted = deltas.count_above(diff.allowed_delta);
    if (gates.max_shift && *gates.max_shift > 0 && figures.differing > 0) {
        allow_shift(expected, actual, *gates.max_shift, diff.deltas);
        deltas = Deltas(diff.deltas, peak, whole_numbers, nullptr);
    }
    figures.failing = deltas.count_above(diff.allowed_delta);

    const bool flip_only = gates.flip && !gates.max_delta && !gates.max_pixels && !gates.max_shift;
    const bool pixels_pass = flip_only || figures.failing <= allowed_pixels;
    const bool flip_passes = !gates.flip || figures.flip <= *gates.flip;
    const Needed needed = {deltas.tightest(allowed_pixels), figures.failing, rounded_up_flip(figures.flip)};
    if (figures.differing == 0) {
        diff.verdict = Verdict::same;
    } else if (pixels_pass && flip_passes) {
        diff.verdict = Verdict::tolerated;
    } else {
        diff.verdict = Verdict::different;
        diff.would_pass = passing_alternatives(expected, actual, gates, needed, pixels_pass, flip_passes, diff);
    }
    if (passes(diff.verdict))
        diff.warnings = loose_gates(gates, needed, peak, figures, failing_unshifted <= allowed_pixels);
}

}  // namespace diff_steps
}  // namespace raster
