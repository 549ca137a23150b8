// bug.cpp: a bug's picture, its difference, and its first wrong number.
#include "bug.h"

#include <raster/bugs/render_bug.h>
#include <raster/image/diff_picture.h>
#include <raster/image/write.h>

#include "json.h"
#include "report.h"

namespace raster::tool {
namespace {

constexpr int most_members = 6;

std::string help() {
    std::string text =
        "Draws the picture with a classic mistake, writes NAME.difference.png (right, wrong and difference side by"
        " side), and says at which step the runs part. Of the list:";
    for (const BugInfo& info : bugs) text += "\n" + std::string(info.name) + ": " + std::string(info.mistake);
    return text;
}

/// "setup of triangle 7": where an event belongs.
std::string place_of(const Json& event) {
    std::string text = event["stage"].get<std::string>();
    if (event.contains("vertex")) text += " of vertex " + event["vertex"].dump();
    if (event.contains("triangle")) text += " of triangle " + event["triangle"].dump();
    if (event.contains("x")) text += " at pixel (" + event["x"].dump() + "," + event["y"].dump() + ")";
    return text;
}

/// The members that differ, one a line.
std::string members_that_differ(const Json& right, const Json& wrong) {
    const Json a = right.flatten(), b = wrong.flatten();
    std::string text;
    int count = 0;
    for (auto member = b.begin(); member != b.end(); ++member) {
        const auto same = a.find(member.key());
        if (same != a.end() && *same == *member) continue;
        if (++count > most_members) continue;
        text += "\n    " + member.key().substr(1) + ": " + member->dump();
        text += same == a.end() ? ", which is not there in the right one" : " instead of " + same->dump();
    }
    if (count > most_members) text += "\n    and " + std::to_string(count - most_members) + " more numbers";
    return text;
}

std::string describe(const std::optional<FirstDifference>& first) {
    if (!first) return "\nno step differs in this scene";
    const std::string after = " (after " + counted(first->event, "equal event") + ")";
    if (first->wrong.empty())
        return "\nfirst difference: the wrong run ends where the right one has " + place_of(Json::parse(first->right)) +
               after;
    const Json wrong = Json::parse(first->wrong);
    if (first->right.empty())
        return "\nfirst difference: " + place_of(wrong) + ", where the right run has ended" + after;
    const Json right = Json::parse(first->right);
    if (place_of(right) != place_of(wrong))
        return "\nfirst difference: " + place_of(wrong) + ", where the right run has " + place_of(right) + after;
    return "\nfirst difference: " + place_of(wrong) + after + members_that_differ(right, wrong);
}

}  // namespace

Result<std::optional<Bug>> parse_bug(std::string_view text) {
    if (const auto found = find_bug(text)) return found;
    std::string known;
    std::vector<std::string> names;
    for (const BugInfo& info : bugs) {
        names.emplace_back(info.name);
        known += (known.empty() ? "" : ", ") + std::string(info.name);
    }
    return Error{ErrorKind::usage, in_quotes(text) + " is none of " + known + did_you_mean(text, names)};
}

void add_bug_flag(CLI::App& app, std::optional<Bug>& bug) {
    add_value(app, "--bug", "NAME", bug, parse_bug, help())->group("Learning");
}

DrawCounts render_with_bug(Bug bug, Target& target, const Model& model, const View& view,
                           const RenderOptions& options) {
    return render_bug(bug, target, model, view.matrices, options);
}

Result<std::string> write_bug_difference(Bug bug, const Target& wrong, const Model& model, const View& view,
                                         const RenderOptions& options, const std::string& path) {
    Target right(wrong.width(), wrong.height(), wrong.color_format());
    render(right, model, view.matrices, options);
    const AnyImage expected = right.color_image(), actual = wrong.color_image();
    const Result<Diff> diff = diff_images(expected, actual);
    if (!diff) return diff.error();
    const Image8 pictures = triptych(expected, actual, indexed_difference(expected, *diff));
    if (const Status status = write_image(path, pictures); !status) return status.error();
    const BugInfo& info = info_of(bug);
    const std::int64_t pixels = diff->figures ? diff->figures->differing : 0;
    return std::string(info.name) + ": " + std::string(info.mistake) + "\nin general: " + std::string(info.symptom) +
           "\n" + path + ": " + counted(pixels, "pixel") + (pixels == 1 ? " differs" : " differ") +
           describe(first_difference(bug, wrong.width(), wrong.height(), model, view.matrices, options));
}

}  // namespace raster::tool
