// approve.h: makes the actual pictures of a failed comparison the expected ones.
#pragma once

#include <string>
#include <vector>

#include <raster/result.h>

namespace raster::testing {

struct ApproveOptions {
    bool in_ci = false;        ///< refuse: a machine that checks pictures must not decide that they are right
    bool only_list = false;    ///< change nothing
    std::string goldens = "";  ///< if not empty, write here by name, wherever the goldens were when they were compared
};

/// Whether the environment says CI (the variable CI is set, and neither empty, "0" nor "false").
bool running_in_ci();

struct Approval {
    std::vector<std::string> approved;  ///< goldens that were written (or would be)
    std::vector<std::string> unchanged; ///< goldens that hold the actual picture already
    std::vector<std::string> refused;   ///< path and reason: the rest
};

/// Reads FOLDER/diff.json and those in folders below, and copies the actual picture of each failed comparison over its
/// golden. Refused are: files that are no pictures or hold a NaN; goldens and actual pictures that changed since they
/// were compared; goldens with another ending than the picture. Comparisons without an actual picture are left out.
/// Errors: usage in CI; bad_input if there is no diff.json or it cannot be understood; input_output if a golden cannot
/// be written, with earlier ones written already.
Result<Approval> approve(const std::string& folder, const ApproveOptions& options = {});

}  // namespace raster::testing
