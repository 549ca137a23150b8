// golden.cpp: finds the golden of a name, compares, and reports into a folder of that name alone, so that tests which
// run at the same time do not write over each other's reports.
#include <raster/testing/golden.h>

#include <filesystem>
#include <new>
#include <system_error>

#include <raster/image/diff_steps.h>
#include <raster/image/png.h>
#include <raster/image/pnm.h>
#include <raster/image/report.h>

namespace raster::testing {
namespace {

namespace fs = std::filesystem;

GoldenResult failure(const std::string& message) { return {false, message}; }

/// What is wrong with a name, or "".
std::string name_problem(const std::string& name) {
    const fs::path path(name);
    if (name.empty() || path.filename().empty()) return "a golden needs a name";
    if (path.is_absolute()) return "the name of a golden is no absolute path: " + name;
    for (const fs::path& part : path)
        if (part == "..") return "the name of a golden must not lead out of its folder: " + name;
    return "";
}

std::string with_ending(const std::string& name, const char* ending) {
    return name.ends_with(ending) ? name : name + ending;
}

Result<Bytes> encode(const AnyImage& image) {
    if (const auto* floats = std::get_if<ImageF>(&image)) return encode_pfm(*floats);
    if (const auto* deep = std::get_if<Image16>(&image)) return encode_png(*deep);
    return encode_png(std::get<Image8>(image));
}

GoldenResult check(const std::string& name, const AnyImage& image, const DiffOptions& options,
                   const GoldenFolders& folders) {
    if (const std::string problem = name_problem(name); !problem.empty()) return failure(problem);
    const diff_steps::Shape shape = diff_steps::shape_of(image);
    const bool floats = shape.bits == 32;
    if (floats && shape.channels % 2 == 0)
        return failure(name + ": a PFM file keeps no alpha: compare 1 or 3 channels");
    if (shape.width < 1 || shape.height < 1) return failure(name + ": the actual picture is empty");
    const std::string file_name = with_ending(name, floats ? ".pfm" : ".png");

    Comparison pair;
    pair.name = fs::path(file_name).filename().string();
    pair.golden = (fs::path(folders.goldens) / file_name).string();
    std::error_code ignored;
    if (fs::exists(pair.golden, ignored)) {
        Result<Comparison> read = diff_files(pair.golden, "", options);
        if (!read) return failure(read.error().message);
        pair.expected = std::move(read->expected);
        if (!pair.expected.image) {
            pair.diff = std::move(read->diff);
        } else {
            Result<Diff> diff = diff_images(*pair.expected.image, image, options);
            if (!diff) return failure(diff.error().message);
            pair.diff = std::move(*diff);
        }
    } else {
        pair.diff.verdict = Verdict::added;
        pair.diff.reason = "there is no golden " + pair.golden + " yet";
    }
    const std::string folder = (fs::path(folders.reports) / name).string();
    if (!passes(pair.diff.verdict)) {
        Result<Bytes> file = encode(image);
        if (!file) return failure(file.error().message);
        pair.actual.file = std::move(*file);
        pair.actual.image = image;
    }
    DiffReport report(folder);
    std::string trouble;
    const std::vector<std::string> pair_warnings = pair.diff.warnings;
    if (const Status added = report.add(std::move(pair), options.gates); !added) trouble = added.error().message + "\n";
    if (const Status finished = report.finish(); !finished) trouble += finished.error().message + "\n";
    if (report.all_pass()) {
        std::string warnings;
        for (const std::string& warning : pair_warnings) warnings += name + ": " + warning + "\n";
        return {true, warnings};
    }
    std::string message = to_string(report.entries().front(), folder);
    if (!trouble.empty()) return failure(message + trouble);
    message += "  report      " + folder + "/report.html\n";
    if (report.entries().front().approvable) message += "  if it is right: raster approve " + folder + "\n";
    return failure(message);
}

}  // namespace

GoldenResult check_golden(const std::string& name, const AnyImage& image, const DiffOptions& options,
                          const GoldenFolders& folders) {
    try {
        return check(name, image, options, folders);
    } catch (const std::bad_alloc&) {
        return failure(name + ": not enough memory");
    } catch (const std::exception& error) {  // names that no file system can hold
        return failure(name + ": " + error.what());
    }
}

}  // namespace raster::testing
