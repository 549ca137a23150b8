// golden.h: tests that compare a picture with an approved one; a plain core for every test framework.
#pragma once

#include <cstdlib>
#include <string>

#include <raster/image/diff.h>

namespace raster::testing {

/// Where the approved pictures are and where failures are reported.
struct GoldenFolders {
    std::string goldens, reports;
};

/// From the environment (RASTER_GOLDEN_DIR, RASTER_DIFF_DIR), else from macros of these names, which the CMake function
/// raster_add_golden_tests defines, else "goldens" and "diff-out" in the working directory.
inline GoldenFolders default_folders() {
    GoldenFolders folders{"goldens", "diff-out"};
#if defined(RASTER_GOLDEN_DIR)
    folders.goldens = RASTER_GOLDEN_DIR;
#endif
#if defined(RASTER_DIFF_DIR)
    folders.reports = RASTER_DIFF_DIR;
#endif
    if (const char* set = std::getenv("RASTER_GOLDEN_DIR"); set != nullptr && *set != '\0') folders.goldens = set;
    if (const char* set = std::getenv("RASTER_DIFF_DIR"); set != nullptr && *set != '\0') folders.reports = set;
    return folders;
}

/// Whether a picture is the approved one, and what to tell if it is not.
struct GoldenResult {
    bool passed = false;
    /// On failure: what differs, all figures, the tightest gates that would pass, paths, and the command that approves.
    /// On success empty, or warnings of gates that are far looser than needed.
    std::string message;
    explicit operator bool() const { return passed; }
};

/// Compares `image` with FOLDER/NAME.png, or NAME.pfm for floats (which have 1 or 3 channels then). `name` may have
/// folders ("lines/wide") and must not lead out. Without gates every sample has to be equal. A failure, a missing golden
/// included, writes REPORTS/NAME/ with the actual picture, pictures of the difference, report.html and diff.json; a
/// success removes what an earlier failure left there. Never throws; whatever goes wrong is a failure with its reason.
///
/// With doctest: `auto golden = check_golden("teapot", image); CHECK_MESSAGE(golden.passed, golden.message);`
/// With Catch2: `INFO(golden.message); CHECK(golden.passed);`. With GoogleTest see matchers.h.
GoldenResult check_golden(const std::string& name, const AnyImage& image, const DiffOptions& options,
                          const GoldenFolders& folders);
inline GoldenResult check_golden(const std::string& name, const AnyImage& image, const DiffOptions& options = {}) {
    return check_golden(name, image, options, default_folders());
}
inline GoldenResult check_golden(const std::string& name, const AnyImage& image, const Gates& gates) {
    DiffOptions options;
    options.gates = gates;
    return check_golden(name, image, options);
}

}  // namespace raster::testing
