// approve.cpp: `raster approve`: makes the actual pictures of a failed comparison the expected ones.
#include <raster/testing/approve.h>

#include "commands.h"
#include "flags.h"
#include "report.h"

namespace raster::tool {
namespace {

struct ApproveArguments {
    std::string folder = "diff-out";
    testing::ApproveOptions options;
};

Result<int> run_approve(ApproveArguments& a) {
    a.options.in_ci = testing::running_in_ci() && !a.options.only_list;
    const Result<testing::Approval> approval = testing::approve(a.folder, a.options);
    if (!approval) return approval.error();
    std::string text;
    for (const std::string& golden : approval->approved)
        text += (a.options.only_list ? "would approve " : "approved ") + golden + "\n";
    for (const std::string& golden : approval->unchanged) text += "unchanged " + golden + "\n";
    if (approval->approved.empty() && approval->unchanged.empty() && approval->refused.empty())
        text += "nothing to approve\n";
    for (const std::string& refused : approval->refused) say("refused " + refused);
    if (const Status printed = print(text); !printed) return printed.error();
    return int(approval->refused.empty() ? exit_done : exit_bad_input);
}

}  // namespace

Run add_approve(CLI::App& app) {
    const auto a = std::make_shared<ApproveArguments>();
    app.add_option("FOLDER", a->folder, "What `raster diff` or failed golden tests left behind (default: diff-out).");
    add_switch(app, "--list", a->options.only_list, "Say what would be approved and change nothing.")
        ->group("Other flags");
    add_value(app, "--goldens", "FOLDER", a->options.goldens, parse_path,
              "Write there, by name, wherever the expected pictures were: for a report that another machine made.")
        ->group("Other flags");
    app.footer(
        "Look at report.html first. Refused are pictures that changed since they were compared, files that are no\n"
        "pictures, NaN; and everything where the variable CI is set.\n"
        "Exit codes: 0 done, 1 some were refused, 2 wrong usage or CI, 3 a file cannot be written.");
    return [a] { return run_approve(*a); };
}

}  // namespace raster::tool
