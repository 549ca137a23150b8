// diff.cpp: the comparison from two pictures to a verdict, step by step.
#include <raster/image/diff.h>

#include <algorithm>
#include <cmath>
#include <new>
#include <utility>

#include <raster/image/diff_steps.h>

namespace raster {
namespace {

using namespace diff_steps;

Error usage(const std::string& message) { return {ErrorKind::usage, "diff: " + message}; }

Status check(const DiffOptions& options) {
    const Gates& gates = options.gates;
    // Written so that NaN is refused too.
    if (gates.max_delta && !(*gates.max_delta >= 0)) return usage("max-delta is at least 0");
    if (gates.max_pixels && *gates.max_pixels < 0) return usage("max-pixels is at least 0");
    if (gates.max_shift && (*gates.max_shift < 0 || *gates.max_shift > 16)) return usage("max-shift is 0 to 16");
    if (gates.flip && !(*gates.flip >= 0 && *gates.flip <= 1)) return usage("flip is 0 to 1");
    if (!(options.pixels_per_degree >= 5 && options.pixels_per_degree <= 500))
        return usage("pixels per degree are 5 to 500");
    for (const PixelRect& rect : options.ignored)
        if (rect.width < 1 || rect.height < 1) return usage("an ignored rectangle has at least one pixel");
    return Done{};
}

std::string bits_in_words(int bits) { return bits == 32 ? "floats" : std::to_string(bits) + " bits"; }

std::string channels_in_words(int channels) {
    constexpr const char* words[] = {"grey", "grey and alpha", "RGB", "RGBA"};
    return words[channels - 1];
}

Diff named_failure(Verdict verdict, std::string reason) {
    Diff diff;
    diff.verdict = verdict;
    diff.reason = std::move(reason);
    return diff;
}

Result<Diff> compare(const AnyImage& expected_as_read, const AnyImage& actual_as_read, const DiffOptions& options,
                     std::vector<float> zeros) {
    const Shape e = shape_of(expected_as_read), a = shape_of(actual_as_read);
    for (const Shape& shape : {e, a})
        if (shape.width < 1 || shape.height < 1 || shape.channels < 1 || shape.channels > 4)
            return usage("a picture has at least one pixel and 1 to 4 channels");
    if (e.width != a.width || e.height != a.height)
        return named_failure(Verdict::size_mismatch, "expected " + e.size() + ", actual " + a.size() + " pixels");
    if ((e.bits == 32) != (a.bits == 32))
        return named_failure(Verdict::type_mismatch, "expected " + bits_in_words(e.bits) + ", actual " +
                                                         bits_in_words(a.bits) + ": their scales are unrelated");
    Result<Image8> compared = pixels_that_count(e, options);
    if (!compared) return compared.error();
    std::string nan = nan_report(expected_as_read, *compared, "expected");
    const std::string actual_nan = nan_report(actual_as_read, *compared, "actual");
    nan += (nan.empty() || actual_nan.empty() ? "" : "; ") + actual_nan;
    if (!nan.empty()) return named_failure(Verdict::not_a_number, nan);

    Diff diff;
    diff.compared = std::move(*compared);
    // Copies are made only where something has to be adapted.
    const AnyImage *expected = &expected_as_read, *actual = &actual_as_read;
    AnyImage adapted_expected, adapted_actual;
    if (e.bits != a.bits || e.channels != a.channels) {
        const int bits = std::max(e.bits, a.bits);
        const bool color = e.channels >= 3 || a.channels >= 3, alpha = e.channels % 2 == 0 || a.channels % 2 == 0;
        const int channels = (color ? 3 : 1) + (alpha ? 1 : 0);
        if (e.bits != a.bits)
            diff.notes.push_back("expected " + bits_in_words(e.bits) + ", actual " + bits_in_words(a.bits) +
                                 ": compared as 16 bits");
        if (e.channels != a.channels)
            diff.notes.push_back("expected " + channels_in_words(e.channels) + ", actual " +
                                 channels_in_words(a.channels) + ": compared as " + channels_in_words(channels));
        adapted_expected = adapted(*expected, bits, channels);
        adapted_actual = adapted(*actual, bits, channels);
        expected = &adapted_expected, actual = &adapted_actual;
    }
    Figures figures;
    figures.compared = std::int64_t(e.width) * e.height;
    if (!diff.compared.empty()) {
        figures.compared = std::count(diff.compared.samples.begin(), diff.compared.samples.end(), 1);
        adapted_actual = with_ignored_equal(*expected, *actual, diff.compared);
        actual = &adapted_actual;
    }

    PlainMetrics plain_figures = plain(*expected, *actual, figures.compared, std::move(zeros));
    figures.differing = plain_figures.differing;
    figures.max = plain_figures.max, figures.max_x = plain_figures.max_x, figures.max_y = plain_figures.max_y;
    figures.mean = plain_figures.mean, figures.rms = plain_figures.rms, figures.psnr = plain_figures.psnr;
    diff.deltas = std::move(plain_figures.deltas);
    if (figures.differing > 0) {
        const DifferingCells cells(diff.deltas);
        figures.ssim = mean_ssim(*expected, *actual, cells, diff.compared);
        std::optional<double> mean;
        if (options.flip_detail != FlipDetail::errors && diff.compared.empty()) {
            Image8* const steps = options.flip_detail == FlipDetail::steps ? &diff.flip_steps : nullptr;
            mean = flip_mean(*expected, *actual, cells, options.pixels_per_degree, steps);
        }
        if (!mean) {
            diff.flip_steps = {};
            diff.flip_map = flip_map(*expected, *actual, cells, options.pixels_per_degree);
            mean = mean_of(diff.flip_map, diff.compared);
        }
        figures.flip = *mean;
    }
    diff.figures = figures;
    const double peak = std::max(e.bits, a.bits) == 8 ? 255 : std::max(e.bits, a.bits) == 16 ? 65535 : 1;
    judge(*expected, *actual, options.gates, peak, diff);
    find_regions(diff);
    return diff;
}

}  // namespace

const char* to_string(Verdict verdict) {
    switch (verdict) {
        case Verdict::same: return "same";
        case Verdict::tolerated: return "tolerated";
        case Verdict::different: return "different";
        case Verdict::size_mismatch: return "size mismatch";
        case Verdict::type_mismatch: return "type mismatch";
        case Verdict::not_a_number: return "not a number";
        case Verdict::unreadable: return "unreadable";
        case Verdict::missing: return "missing";
        case Verdict::added: return "added";
    }
    return "";
}

Result<Diff> diff_images(const AnyImage& expected, const AnyImage& actual, const DiffOptions& options) {
    return diff_steps::diff_images(expected, actual, options, {});
}

Result<Diff> diff_steps::diff_images(const AnyImage& expected, const AnyImage& actual, const DiffOptions& options,
                                     std::vector<float> zeros) {
    if (const Status status = check(options); !status) return status.error();
    try {
        return compare(expected, actual, options, std::move(zeros));
    } catch (const std::bad_alloc&) {
        return Error{ErrorKind::input_output, "diff: not enough memory"};
    }
}

}  // namespace raster
