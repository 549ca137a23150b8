// approve.cpp: trusts nothing in diff.json further than it can be checked: it may come from another machine.
#include <raster/testing/approve.h>

#include <libdeflate.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <new>
#include <optional>
#include <system_error>

#include <raster/image/decode.h>
#include <raster/image/file.h>
#include <raster/image/report_json.h>

namespace raster::testing {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t most_bytes = std::size_t(1) << 31;

bool has_crc(const Bytes& file, const std::string& hexadecimal) {
    std::uint32_t crc = 0;
    const char* end = hexadecimal.data() + hexadecimal.size();
    const auto read = std::from_chars(hexadecimal.data(), end, crc, 16);
    return read.ptr == end && read.ec == std::errc() && libdeflate_crc32(0, file.data(), file.size()) == crc;
}

std::string lower_ending(const fs::path& path) {
    std::string ending = path.extension().string();
    for (char& c : ending) c = c >= 'A' && c <= 'Z' ? char(c - 'A' + 'a') : c;
    return ending;
}

bool leads_out(const fs::path& path) {
    return path.is_absolute() || std::find(path.begin(), path.end(), fs::path("..")) != path.end();
}

std::string picture_problem(const Bytes& file, const std::string& path) {
    const Result<AnyImage> image = decode_image(file, path);
    if (!image) return image.error().message;
    if (const auto* floats = std::get_if<ImageF>(&*image))
        if (std::any_of(floats->samples.begin(), floats->samples.end(), [](float v) { return std::isnan(v); }))
            return path + ": has NaN, with which no comparison passes";
    return "";
}

std::string side_text(const JsonValue& pair, const char* side, const char* name) {
    const auto found = pair.members.find(side);
    return found == pair.members.end() ? "" : found->second.member_text(name);
}

/// One comparison that failed. Refusals are kept, not returned.
Status approve_pair(const JsonValue& pair, const fs::path& folder, const ApproveOptions& options, Approval& approval) {
    const std::string actual_name = side_text(pair, "files", "actual"), name = pair.member_text("name");
    if (pair.member_text("passes") != "false" || actual_name.empty()) return Done{};
    fs::path golden = pair.member_text("golden");
    const auto refuse = [&](const std::string& why) {
        approval.refused.push_back((golden.empty() ? fs::path(name) : golden).string() + ": " + why);
        return Status(Done{});
    };
    if (leads_out(actual_name) || leads_out(name)) return refuse("diff.json names a file outside of its folder");
    if (!options.goldens.empty()) golden = fs::path(options.goldens) / name;
    if (golden.empty()) return refuse("the comparison was with no file");

    const fs::path actual = folder / actual_name;
    const Result<Bytes> file = read_file(actual.string(), most_bytes);
    if (!file) return refuse(file.error().message);
    if (!has_crc(*file, side_text(pair, "actual", "crc32")))
        return refuse(actual.string() + " changed since it was compared");
    if (const std::string problem = picture_problem(*file, actual.string()); !problem.empty()) return refuse(problem);
    if (lower_ending(golden) != lower_ending(actual))
        return refuse("is not of the kind of the actual picture, " + actual.string());

    std::error_code ignored;
    if (fs::exists(golden, ignored)) {
        const Result<Bytes> now = read_file(golden.string(), most_bytes);
        if (!now) return refuse(now.error().message);
        if (*now == *file) {
            approval.unchanged.push_back(golden.string());
            return Done{};
        }
        // Elsewhere than it was, it is whatever a checkout brought there.
        if (options.goldens.empty() && !has_crc(*now, side_text(pair, "expected", "crc32")))
            return refuse("changed since it was compared; run the comparison again");
    }
    if (!options.only_list) {
        std::error_code failed;
        if (golden.has_parent_path()) fs::create_directories(golden.parent_path(), failed);
        if (failed)
            return Error{ErrorKind::input_output,
                         golden.parent_path().string() + ": cannot make the folder: " + failed.message()};
        if (const Status written = write_file(golden.string(), *file); !written) return written;
    }
    approval.approved.push_back(golden.string());
    return Done{};
}

Status approve_report(const fs::path& data, const ApproveOptions& options, Approval& approval) {
    const Result<Bytes> file = read_file(data.string(), most_bytes);
    if (!file) return file.error();
    const std::optional<JsonValue> report = parse_json({reinterpret_cast<const char*>(file->data()), file->size()});
    if (!report || report->member_text("schema") != "raster-diff" || report->member_text("version") != "1")
        return Error{ErrorKind::bad_input, data.string() + ": not a report that this version of raster diff writes"};
    const auto pairs = report->members.find("pairs");
    if (pairs == report->members.end()) return Done{};
    for (const JsonValue& pair : pairs->second.items)
        if (const Status approved = approve_pair(pair, data.parent_path(), options, approval); !approved)
            return approved;
    return Done{};
}

Result<Approval> approve_all(const std::string& folder, const ApproveOptions& options) {
    std::error_code failed;
    std::vector<fs::path> reports;
    for (auto entry = fs::recursive_directory_iterator(folder, failed);
         !failed && entry != fs::recursive_directory_iterator(); entry.increment(failed))
        if (entry->path().filename() == "diff.json") reports.push_back(entry->path());
    if (failed) return Error{ErrorKind::input_output, folder + ": cannot read: " + failed.message()};
    if (reports.empty()) return Error{ErrorKind::bad_input, folder + ": no diff.json there: no comparison has failed"};
    std::sort(reports.begin(), reports.end());
    Approval approval;
    for (const fs::path& report : reports)
        if (const Status done = approve_report(report, options, approval); !done) return done.error();
    return approval;
}

}  // namespace

bool running_in_ci() {
    const char* set = std::getenv("CI");
    const std::string value = set == nullptr ? "" : set;
    return !value.empty() && value != "0" && value != "false";
}

Result<Approval> approve(const std::string& folder, const ApproveOptions& options) {
    if (options.in_ci)
        return Error{ErrorKind::usage, "refused, because CI is set: pictures are approved by people, who look at them"};
    try {
        return approve_all(folder, options);
    } catch (const std::bad_alloc&) {
        return Error{ErrorKind::input_output, folder + ": not enough memory"};
    } catch (const fs::filesystem_error& error) {
        return Error{ErrorKind::input_output, error.path1().string() + ": " + error.code().message()};
    }
}

}  // namespace raster::testing
