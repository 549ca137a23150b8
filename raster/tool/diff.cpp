// diff.cpp: `raster diff`: compares a picture with the one it should be, or a folder of them. See docs/diff.md.
#include <charconv>
#include <filesystem>
#include <limits>

#include <raster/image/file.h>
#include <raster/image/report.h>

#include "commands.h"
#include "explain.h"
#include "flags.h"
#include "report.h"

namespace raster::tool {
namespace {

struct DiffArguments {
    std::string expected, actual;
    DiffOptions options;
    std::string mask, out = "diff-out", junit;
    bool json = false;
    ExplainFlags explain;
    Explained explained;
};

/// As POSIX diff: 0 and 1 are answers, all else is trouble.
constexpr int exit_trouble = 2;

Result<std::int64_t> parse_pixels(std::string_view text) {
    const Result<int> count = parse_count(text, 0, std::numeric_limits<int>::max());
    if (!count) return count.error();
    return std::int64_t(*count);
}

/// A double, unlike parse_number: FLIP values and floats come with all their digits.
Result<double> parse_limit(std::string_view text, double most) {
    const Result<float> number = parse_number(text);
    if (!number) return number.error();
    if (*number < 0 || double(*number) > most)
        return Error{ErrorKind::usage, in_quotes(text) + " is not within 0 to " + to_text(float(most))};
    double value = 0;
    if (text.front() == '+') text.remove_prefix(1);
    std::from_chars(text.data(), text.data() + text.size(), value);
    return value;
}

/// Compares one pair and keeps it in the report.
Status compare(const FilePair& pair, DiffArguments& a, DiffReport& report) {
    Result<Comparison> comparison = diff_files(pair.expected_path, pair.actual_path, a.options);
    if (!comparison) return comparison.error();
    comparison->name = pair.name;
    comparison->golden = pair.golden;
    if (!a.explain.load.model.empty()) {
        Result<Explained> explained = explain(a.explain, *comparison);
        if (!explained) return explained.error();
        a.explained = std::move(*explained);
    }
    return report.add(std::move(*comparison), a.options.gates);
}

/// The report's JSON with the explanation as one more member. Its other members stay as they are written.
std::string json_with(std::string report, const std::string& explained) {
    const std::size_t end = report.rfind('}');
    if (explained.empty() || end == std::string::npos) return report;
    const std::size_t last = report.find_last_not_of(" \n", end - 1) + 1;
    return report.substr(0, last) + ",\n  \"explanations\": " + explained + "\n" + report.substr(end);
}

Result<std::vector<FilePair>> find_pairs(const DiffArguments& a) {
    std::error_code ignored;
    const bool folders = std::filesystem::is_directory(a.expected, ignored);
    if (folders != std::filesystem::is_directory(a.actual, ignored))
        return Error{ErrorKind::usage, (folders ? a.expected : a.actual) + " is a folder and " +
                                           (folders ? a.actual : a.expected) +
                                           " is not; compare two files or two folders"};
    if (!folders) {
        // A name that is not there is a mistake of the command line, not a finding.
        for (const std::string& path : {a.expected, a.actual})
            if (!std::filesystem::exists(path, ignored))
                return Error{ErrorKind::input_output, path + ": there is no such file"};
        const std::string name = std::filesystem::path(a.expected).filename().string();
        return std::vector<FilePair>{{name, a.expected, a.expected, a.actual}};
    }
    Result<std::vector<FilePair>> pairs = match_folders(a.expected, a.actual);
    if (pairs && pairs->empty())
        return Error{ErrorKind::bad_input, "there are no pictures in " + a.expected + " and none in " + a.actual};
    return pairs;
}

Result<int> compare_all(DiffArguments& a) {
    if (!a.mask.empty()) {
        Result<Image8> mask = load_image8(a.mask);
        if (!mask) return mask.error();
        a.options.mask = std::move(*mask);
    }
    const Result<std::vector<FilePair>> pairs = find_pairs(a);
    if (!pairs) return pairs.error();
    std::error_code ignored;
    if (!a.explain.load.model.empty() && std::filesystem::is_directory(a.expected, ignored))
        return Error{ErrorKind::usage, "--explain: compare two files, not folders"};
    if (!a.junit.empty())
        if (const Status writable = check_writable(a.junit); !writable) return writable.error();

    const bool difference_only = a.out.ends_with(".png");
    if (difference_only && std::filesystem::is_directory(a.expected, ignored))
        return Error{ErrorKind::usage, "--out " + a.out + ": the differences of two folders want a folder"};
    if (difference_only)
        if (const Status writable = check_writable(a.out); !writable) return writable.error();
    // The report shows FLIP; the difference alone does not.
    a.options.flip_detail = difference_only ? FlipDetail::none : FlipDetail::steps;
    DiffReport report = difference_only ? DiffReport::of_difference_only(a.out) : DiffReport(a.out);
    for (const FilePair& pair : *pairs)
        if (const Status done = compare(pair, a, report); !done) return done.error();
    if (const Status finished = report.finish(); !finished) return finished.error();
    if (!a.junit.empty()) {
        const std::string xml = report.junit();
        if (const Status written = write_file(a.junit, std::as_bytes(std::span(xml))); !written) return written.error();
    }
    const std::string answer =
        a.json ? json_with(report.json(), a.explained.json) : report.text() + a.explained.text;
    if (const Status printed = print(answer); !printed) return printed.error();
    return report.exit_code();
}

Result<int> run_diff(DiffArguments& a) {
    const Result<int> result = compare_all(a);
    if (result) return result;
    fail(result.error());
    return exit_trouble;
}

}  // namespace

Run add_diff(CLI::App& app) {
    const auto a = std::make_shared<DiffArguments>();
    Gates& gates = a->options.gates;
    app.add_option("EXPECTED", a->expected, "The picture as it should be, or a folder of such pictures.")->required();
    app.add_option("ACTUAL", a->actual, "The picture to judge, or a folder; there, files are matched by their names.")
        ->required();

    const char* group = "What may differ (without these: nothing)";
    add_value(app, "--max-delta", "N", gates.max_delta,
              [](std::string_view text) { return parse_limit(text, double(std::numeric_limits<float>::max())); },
              "Samples may differ by N: of 255 in 8 bits, of 65535 in 16 bits, of floats as they are.")
        ->group(group);
    add_value(app, "--max-pixels", "N", gates.max_pixels, parse_pixels, "N pixels may differ by more.")->group(group);
    add_value(app, "--max-shift", "N", gates.max_shift, [](std::string_view text) { return parse_count(text, 0, 16); },
              "Pixels may lie up to N pixels elsewhere, 0 to 16: for noise at edges.")
        ->group(group);
    add_value(app, "--flip", "X", gates.flip, [](std::string_view text) { return parse_limit(text, 1); },
              "The mean FLIP error may be X, 0 to 1. Given alone, nothing else is asked.")
        ->group(group);
    group = "What counts";
    add_values(app, "--ignore", "X,Y,W,H", a->options.ignored, parse_rect, "Ignore a rectangle; may be given again.")
        ->group(group);
    add_value(app, "--mask", "FILE", a->mask, parse_path,
              "Compare where this picture is white, ignore where it is black.")
        ->group(group);
    add_value(app, "--pixels-per-degree", "X", a->options.pixels_per_degree,
              [](std::string_view text) { return parse_number_within(text, 5, 500); },
              "How FLIP's viewer sees the picture, 5 to 500; 67 is a wide screen at arm's length.")
        ->group(group);
    group = "What is written";
    add_value(app, "-o,--out", "PATH", a->out, parse_path,
              "On failure: a folder with report.html, diff.json, and for each picture its difference, a triptych and a"
              " copy of the actual one (default: diff-out); or NAME.png: the difference alone. When all pass, nothing.")
        ->group(group);
    add_switch(app, "--json", a->json, "Print diff.json instead of text.")->group(group);
    add_value(app, "--junit", "FILE", a->junit, parse_path, "Write the results as JUnit XML, also when all pass.")
        ->group(group);
    add_explain_flags(app, a->explain);
    app.footer("All figures are always told: count, max, mean, RMS, PSNR, SSIM, FLIP; and the tightest flags that would pass.\n"
               "Exit codes: 0 same or within the flags, 1 different, 2 trouble.");
    return [a] { return run_diff(*a); };
}

}  // namespace raster::tool
