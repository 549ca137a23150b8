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

constexpr const char* page_name = "report.html";

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
    else if (page_)
        add_without_pictures(entry, entries_.empty());
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
    if (!page_)
        if (Status opened = open_page(); !opened) return opened;
    const std::string stem = stem_of(pair.name);
    const bool embed = embedded_bytes_ < most_embedded_bytes;

    IndexedImage difference;
    if (pair.diff.figures) difference = indexed_difference(*pair.expected.image, pair.diff);
    if (!difference.empty()) entry.difference_file = stem + ".diff.png";
    if (pair.expected.image && pair.actual.image) entry.triptych_file = stem + ".triptych.png";
    if (!pair.actual.file.empty() && pair.actual.image) {
        entry.actual_file = actual_name(pair);
        entry.approvable = !has_nan(*pair.actual.image);
    }
    const bool is_first = entries_.empty();
    const Sink page = [&](std::span<const std::byte> piece) { return page_->append(piece); };
    const auto write_picture = [&](const Bytes& picture, const std::string& file) {
        return write_file((fs::path(folder_) / file).string(), picture, Keep::until_power_fails);
    };
    const auto add_to_page = [&](const char* name, ComparedPicture& picture) -> Status {
        const Result<Bytes> shown = embed ? picture_for_page(picture) : Bytes();
        if (!shown) return shown.error();
        embedded_bytes_ += shown->size();
        write_page_picture(name, *shown, page);
        return Done{};
    };
    Bytes difference_picture, flip_shown;
    // Independent of each other, and each takes its time: what is there already is written while the rest is made.
    const std::function<Status()> jobs[] = {
        [&]() -> Status {
            write_page_entry_start(to_json(entry), is_first, page);
            if (!entry.actual_file.empty())
                if (Status copied = write_picture(pair.actual.file, entry.actual_file); !copied) return copied;
            if (Status added = add_to_page("expected", pair.expected); !added) return added;
            return add_to_page("actual", pair.actual);
        },
        [&]() -> Status {
            if (difference.empty()) return Done{};
            Result<Bytes> png = encode_png(difference);
            if (!png) return png.error();
            difference_picture = std::move(*png);
            return write_picture(difference_picture, entry.difference_file);
        },
        [&]() -> Status {
            if (entry.triptych_file.empty()) return Done{};
            const Result<Bytes> png = encode_png_fast(triptych(*pair.expected.image, *pair.actual.image, difference));
            return png ? write_picture(*png, entry.triptych_file) : Status(png.error());
        },
        [&]() -> Status {
            if ((pair.diff.flip_map.empty() && pair.diff.flip_steps.empty()) || !embed) return Done{};
            Result<Bytes> png = encode_png(flip_picture(std::move(pair.diff)));
            if (!png) return png.error();
            flip_shown = std::move(*png);
            return Done{};
        },
    };
    std::vector<Status> results(std::size(jobs), Status(Done{}));
    tiles::parallel_for(results.size(), [&](std::size_t i) { results[i] = jobs[i](); });
    if (!embed) difference_picture.clear();
    embedded_bytes_ += difference_picture.size() + flip_shown.size();
    write_page_picture("difference", difference_picture, page);
    write_page_picture("flip", flip_shown, page);
    write_page_entry_end(page);
    for (Status& result : results)
        if (!result) return std::move(result);
    return Done{};
}

void DiffReport::add_without_pictures(const ReportEntry& entry, bool is_first) {
    const Sink page = [&](std::span<const std::byte> piece) { return page_->append(piece); };
    write_page_entry_start(to_json(entry), is_first, page);
    for (const char* name : {"expected", "actual", "difference", "flip"}) write_page_picture(name, {}, page);
    write_page_entry_end(page);
}

Status DiffReport::open_page() {
    if (const Status made = make_folder(folder_); !made) return made;
    Result<FileInPieces> opened = FileInPieces::open((fs::path(folder_) / page_name).string(), Keep::until_power_fails);
    if (!opened) return opened.error();
    page_ = std::move(*opened);
    write_page_start(folder_, [&](std::span<const std::byte> piece) { return page_->append(piece); });
    for (const ReportEntry& entry : entries_) add_without_pictures(entry, &entry == entries_.data());
    return Done{};
}

Status DiffReport::finish() try {
    if (!difference_only_.empty()) return Done{};
    const fs::path folder(folder_), page = folder / page_name, data = folder / "diff.json";
    if (!all_pass()) {
        if (!page_ && !page_is_finished_)
            if (Status opened = open_page(); !opened) return opened;
        if (page_) {
            FileInPieces file = std::move(*page_);
            page_.reset();
            page_is_finished_ = true;
            write_page_end([&](std::span<const std::byte> piece) { return file.append(piece); });
            if (Status written = file.finish(); !written) return written;
        }
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
