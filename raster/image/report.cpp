// report.cpp: gathers comparisons and writes the folder that a failed run leaves behind.
#include <raster/image/report.h>

#include <libdeflate.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <functional>
#include <new>
#include <set>
#include <system_error>

#include <raster/image/diff_picture.h>
#include <raster/image/diff_steps.h>
#include <raster/image/png.h>
#include <raster/image/pnm.h>
#include <raster/image/report_json.h>
#include <raster/image/report_page.h>
#include <raster/tiles/parallel.h>

namespace raster {
namespace {

namespace fs = std::filesystem;

/// Beyond, browsers get slow; the pictures are in the folder all the same.
constexpr std::size_t most_embedded_bytes = std::size_t(192) << 20;

std::string hexadecimal(std::uint32_t value) {
    std::string digits(8, '0');
    for (std::size_t i = 8; i-- > 0; value >>= 4) digits[i] = "0123456789abcdef"[value & 15];
    return digits;
}

std::string crc_of(const Bytes& file) {
    return file.empty() ? "" : hexadecimal(libdeflate_crc32(0, file.data(), file.size()));
}

std::string shape_in_words(const std::optional<AnyImage>& image) {
    if (!image) return "";
    const diff_steps::Shape shape = diff_steps::shape_of(*image);
    constexpr const char* channels[] = {"grey", "grey and alpha", "RGB", "RGBA"};
    return shape.size() + " " + channels[shape.channels - 1] +
           (shape.bits == 32 ? ", floats" : ", " + std::to_string(shape.bits) + " bits");
}

Result<Bytes> encode(const AnyImage& image) {
    if (const auto* deep = std::get_if<Image16>(&image)) return encode_png(*deep);
    if (const auto* bytes = std::get_if<Image8>(&image)) return encode_png(*bytes);
    return encode_png(displayed(image));
}

/// The file itself, which is taken away, where browsers know its format, else a PNG of what it shows.
Result<Bytes> picture_for_page(ComparedPicture& picture) {
    if (!picture.image) return Bytes();
    return picture_type(picture.file) != nullptr ? std::move(picture.file) : encode(*picture.image);
}

Status make_folder(const fs::path& folder) {
    std::error_code failed;
    fs::create_directories(folder, failed);
    if (failed)
        return Error{ErrorKind::input_output, folder.string() + ": cannot make the folder: " + failed.message()};
    return Done{};
}

/// How the files about a comparison begin: "teapot" for teapot.png; other endings stay, lest two be one.
std::string stem_of(const std::string& name) { return name.ends_with(".png") ? name.substr(0, name.size() - 4) : name; }

std::string actual_name(const Comparison& pair) {
    std::string ending = fs::path(pair.actual.path).extension().string();
    if (ending.empty())
        ending = pair.actual.image && std::holds_alternative<ImageF>(*pair.actual.image) ? ".pfm" : ".png";
    return stem_of(pair.name) + ".actual" + ending;
}

bool has_nan(const AnyImage& image) {
    const auto* floats = std::get_if<ImageF>(&image);
    return floats && std::any_of(floats->samples.begin(), floats->samples.end(), [](float v) { return std::isnan(v); });
}

void remove_if_there(const fs::path& file) {
    std::error_code ignored;
    fs::remove(file, ignored);
}

}  // namespace

Status DiffReport::add(Comparison pair, const Gates& gates) try {
    const Diff& diff = pair.diff;
    ReportEntry entry;
    entry.name = pair.name;
    std::error_code failed;
    const fs::path golden = fs::absolute(pair.golden, failed);
    entry.golden = pair.golden.empty() || failed ? "" : golden.lexically_normal().string();
    entry.verdict = diff.verdict;
    entry.reason = diff.reason;
    entry.expected_path = pair.expected.path, entry.actual_path = pair.actual.path;
    entry.expected_shape = shape_in_words(pair.expected.image), entry.actual_shape = shape_in_words(pair.actual.image);
    entry.expected_crc = crc_of(pair.expected.file), entry.actual_crc = crc_of(pair.actual.file);
    entry.figures = diff.figures;
    entry.gates = gates;
    entry.would_pass = diff.would_pass;
    entry.warnings = diff.warnings, entry.notes = diff.notes;
    entry.regions = diff.regions, entry.region_count = diff.region_count;
    if (const auto& either = pair.expected.image ? pair.expected.image : pair.actual.image; either) {
        const diff_steps::Shape shape = diff_steps::shape_of(*either);
        entry.width = shape.width, entry.height = shape.height;
    }
    remove_earlier(pair);
    Status written = Done{};
    if (!passes(diff.verdict))
        written = difference_only_.empty() ? write_pictures(pair, entry) : write_difference(pair, entry);
    entries_.push_back(std::move(entry));
    return written;
} catch (const std::bad_alloc&) {
    return Error{ErrorKind::input_output, folder_ + ": not enough memory for the report"};
}

DiffReport DiffReport::of_difference_only(const std::string& path) {
    const fs::path file(path);
    DiffReport report(file.has_parent_path() ? file.parent_path().string() : ".");
    report.difference_only_ = file.filename().string();
    return report;
}

/// What an earlier run left about this picture is not true any more.
void DiffReport::remove_earlier(const Comparison& pair) const {
    const fs::path folder(folder_);
    if (!difference_only_.empty()) return remove_if_there(folder / difference_only_);
    const fs::path stem = folder / stem_of(pair.name);
    for (const char* ending : {".diff.png", ".triptych.png"}) remove_if_there(stem.string() + ending);
    remove_if_there(folder / actual_name(pair));
}

Status DiffReport::write_difference(const Comparison& pair, ReportEntry& entry) const {
    if (!pair.diff.figures) return Done{};
    const Result<Bytes> png = encode_png(indexed_difference(*pair.expected.image, pair.diff));
    if (!png) return png.error();
    entry.difference_file = difference_only_;
    return write_file((fs::path(folder_) / difference_only_).string(), *png, Keep::until_power_fails);
}

Status DiffReport::write_pictures(Comparison& pair, ReportEntry& entry) {
    const fs::path folder = fs::path(folder_) / fs::path(pair.name).parent_path();
    if (const Status made = make_folder(folder); !made) return made;
    const std::string stem = stem_of(pair.name);
    const bool embed = embedded_bytes_ < most_embedded_bytes;

    IndexedImage difference;
    if (pair.diff.figures) difference = indexed_difference(*pair.expected.image, pair.diff);
    // Independent of each other, and each takes its time.
    using Job = std::function<Status()>;
    const auto write_picture = [&](const Result<Bytes>& png, const std::string& file) -> Status {
        return png ? write_file((fs::path(folder_) / file).string(), *png, Keep::until_power_fails)
                   : Status(png.error());
    };
    const auto keep = [](Result<Bytes> made, Bytes& bytes) -> Status {
        if (!made) return made.error();
        bytes = std::move(*made);
        return Done{};
    };
    std::vector<Job> jobs;
    if (!difference.empty()) {
        entry.difference_file = stem + ".diff.png";
        jobs.push_back([&]() -> Status {
            Result<Bytes> png = encode_png(difference);
            const Status written = write_picture(png, entry.difference_file);
            return written && embed ? keep(std::move(png), entry.difference_picture) : written;
        });
    }
    if (!(pair.diff.flip_map.empty() && pair.diff.flip_steps.empty()) && embed)
        jobs.push_back([&] { return keep(encode_png(flip_picture(std::move(pair.diff))), entry.flip_picture); });
    if (pair.expected.image && pair.actual.image) {
        entry.triptych_file = stem + ".triptych.png";
        jobs.push_back([&] {
            return write_picture(encode_png_fast(triptych(*pair.expected.image, *pair.actual.image, difference)),
                                 entry.triptych_file);
        });
    }
    if (!pair.actual.file.empty() && pair.actual.image) {
        entry.actual_file = actual_name(pair);
        entry.approvable = !has_nan(*pair.actual.image);
    }
    jobs.push_back([&] { return embed ? keep(picture_for_page(pair.expected), entry.expected_picture) : Done{}; });
    jobs.push_back([&]() -> Status {
        const std::string copy = (fs::path(folder_) / entry.actual_file).string();
        if (!entry.actual_file.empty())
            if (Status copied = write_file(copy, pair.actual.file, Keep::until_power_fails); !copied) return copied;
        return embed ? keep(picture_for_page(pair.actual), entry.actual_picture) : Done{};
    });
    std::vector<Status> results(jobs.size(), Status(Done{}));
    tiles::parallel_for(jobs.size(), [&](std::size_t i) { results[i] = jobs[i](); });
    for (const Bytes* bytes :
         {&entry.expected_picture, &entry.actual_picture, &entry.difference_picture, &entry.flip_picture})
        embedded_bytes_ += bytes->size();
    for (Status& result : results)
        if (!result) return std::move(result);
    return Done{};
}

Status DiffReport::finish() try {
    if (!difference_only_.empty()) return Done{};
    const fs::path folder(folder_), page = folder / "report.html", data = folder / "diff.json";
    if (!all_pass()) {
        if (const Status made = make_folder(folder); !made) return made;
        const auto produce = [&](const Sink& sink) { write_report_page(entries_, folder_, sink); };
        if (Status written = write_file_in_pieces(page.string(), produce, Keep::until_power_fails); !written)
            return written;
        const std::string facts = json();
        return write_file(data.string(), std::as_bytes(std::span(facts)), Keep::until_power_fails);
    }
    // An earlier failure stays if it was about other pictures.
    const Result<Bytes> earlier = read_file(data.string(), std::size_t(1) << 30);
    if (!earlier) return Done{};
    const auto* text = reinterpret_cast<const char*>(earlier->data());
    const std::optional<JsonValue> report = parse_json({text, earlier->size()});
    if (!report) return Done{};
    std::set<std::string> passing;
    for (const ReportEntry& entry : entries_) passing.insert(entry.golden);
    if (const auto pairs = report->members.find("pairs"); pairs != report->members.end())
        for (const JsonValue& pair : pairs->second.items)
            if (pair.member_text("passes") != "true" && passing.count(pair.member_text("golden")) == 0) return Done{};
    remove_if_there(page);
    remove_if_there(data);
    remove_if_there(folder);  // if it is empty
    return Done{};
} catch (const std::bad_alloc&) {
    return Error{ErrorKind::input_output, folder_ + ": not enough memory for the report"};
}

bool DiffReport::all_pass() const {
    return std::all_of(entries_.begin(), entries_.end(),
                       [](const ReportEntry& entry) { return passes(entry.verdict); });
}

int DiffReport::exit_code() const {
    const bool trouble = std::any_of(entries_.begin(), entries_.end(),
                                     [](const ReportEntry& entry) { return entry.verdict == Verdict::unreadable; });
    return trouble ? 2 : all_pass() ? 0 : 1;
}

}  // namespace raster
