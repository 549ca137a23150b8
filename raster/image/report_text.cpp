// report_text.cpp: comparisons in words, as JSON and as JUnit XML.
#include <raster/image/report.h>

#include <algorithm>

#include <raster/image/diff_words.h>
#include <raster/image/report_json.h>

namespace raster {
namespace {

std::string plural(std::int64_t count, const std::string& thing) {
    return grouped(count) + " " + thing + (count == 1 ? "" : "s");
}

std::string at(int x, int y) { return "(" + std::to_string(x) + "," + std::to_string(y) + ")"; }

std::string alternatives(const std::vector<Gates>& gates) {
    std::string words;
    for (const Gates& g : gates) words += (words.empty() ? "" : ", or ") + to_string(g);
    return words;
}

std::string figures_in_words(const ReportEntry& entry) {
    const Figures& f = *entry.figures;
    std::string words = "  " + grouped(f.differing) + " of " + plural(f.compared, "pixel") + " differ (" +
                        significant_number(100.0 * double(f.differing) / double(f.compared)) + " %)";
    if (f.failing != f.differing) words += ", " + grouped(f.failing) + " of them beyond the gates";
    if (!entry.regions.empty()) {
        const PixelRect& box = entry.regions[0].box;
        words += "; in " + plural(entry.region_count, "place") + (entry.region_count > 1 ? ", most of it" : "") +
                 " at " + at(box.x, box.y) + ", " + std::to_string(box.width) + "x" + std::to_string(box.height);
    }
    words += "\n  max " + exact_number(f.max) + " at " + at(f.max_x, f.max_y) + "  mean " + significant_number(f.mean) +
             "  RMS " + significant_number(f.rms) + "  PSNR " + psnr_number(f.psnr) + " dB  SSIM " +
             ssim_number(f.ssim) + "  FLIP " + flip_number(f.flip) + "\n";
    return words;
}

std::string json_of(const Gates& gates) {
    JsonObject object;
    if (gates.max_delta) object.number("max_delta", *gates.max_delta);
    if (gates.max_pixels) object.add("max_pixels", std::to_string(*gates.max_pixels));
    if (gates.max_shift) object.add("max_shift", std::to_string(*gates.max_shift));
    if (gates.flip) object.number("flip", *gates.flip);
    return object.text("options", to_string(gates)).str();
}

std::string json_of(const Figures& f) {
    return JsonObject()
        .add("compared", std::to_string(f.compared))
        .add("differing", std::to_string(f.differing))
        .add("failing", std::to_string(f.failing))
        .number("max", f.max)
        .add("max_at", "[" + std::to_string(f.max_x) + "," + std::to_string(f.max_y) + "]")
        .number("mean", f.mean)
        .number("rms", f.rms)
        .number("psnr", f.psnr)
        .number("ssim", f.ssim)
        .add("flip", flip_number(f.flip))
        .str();
}

std::string json_of(const DiffRegion& r) {
    return JsonObject()
        .add("x", std::to_string(r.box.x))
        .add("y", std::to_string(r.box.y))
        .add("width", std::to_string(r.box.width))
        .add("height", std::to_string(r.box.height))
        .add("pixels", std::to_string(r.pixels))
        .number("max", double(r.max_delta))
        .add("max_at", "[" + std::to_string(r.max_x) + "," + std::to_string(r.max_y) + "]")
        .str();
}

std::string json_of(const std::string& path, const std::string& shape, const std::string& crc) {
    return JsonObject().text("path", path).text("shape", shape).text("crc32", crc).str();
}

template <class T, class Write>
std::string array_of(const std::vector<T>& values, const Write& write) {
    std::vector<std::string> written;
    for (const T& value : values) written.push_back(write(value));
    return json_array(written);
}

std::string xml(const std::string& text) {
    std::string out;
    for (const char c : text) {
        switch (c) {
            case '&': out += "&amp;"; break;
            case '<': out += "&lt;"; break;
            case '>': out += "&gt;"; break;
            case '"': out += "&quot;"; break;
            case '\n': out += "&#10;"; break;
            // Other control characters may not stand in XML, not even escaped.
            default: out += static_cast<unsigned char>(c) < 0x20 && c != '\t' ? '?' : c;
        }
    }
    return out;
}

}  // namespace

std::string to_string(const ReportEntry& entry, const std::string& folder) {
    std::string words = std::string(to_string(entry.verdict)) + ": " + entry.name + "\n";
    const auto line = [&](const std::string& label, const std::string& text) {
        if (!text.empty())
            words += "  " + label + std::string(12 - std::min<std::size_t>(label.size(), 11), ' ') + text + "\n";
    };
    if (!entry.reason.empty()) words += "  " + entry.reason + "\n";
    if (entry.figures && entry.verdict != Verdict::same) words += figures_in_words(entry);
    if (entry.figures) line("gates", to_string(entry.gates));
    line("would pass", alternatives(entry.would_pass));
    for (const std::string& warning : entry.warnings) line("warning", warning);
    for (const std::string& note : entry.notes) line("note", note);
    if (!passes(entry.verdict)) {
        line("expected", entry.expected_path);
        // A picture that was no file is one now.
        const bool made = entry.actual_path.empty() && !entry.actual_file.empty();
        line("actual", made ? folder + "/" + entry.actual_file : entry.actual_path);
        for (const std::string* file : {&entry.difference_file, &entry.triptych_file})
            if (!file->empty()) line("written", folder + "/" + *file);
    }
    return words;
}

std::string DiffReport::text() const {
    std::string words;
    std::size_t failed = 0, approvable = 0, tolerated = 0;
    for (const ReportEntry& entry : entries_) {
        const bool passed = passes(entry.verdict);
        failed += passed ? 0 : 1;
        approvable += entry.approvable ? 1 : 0;
        tolerated += entry.verdict == Verdict::tolerated ? 1 : 0;
        if (entry.verdict != Verdict::same || !entry.warnings.empty() || !entry.notes.empty())
            words += to_string(entry, folder_);
    }
    if (failed == 0)
        return words + (tolerated > 0 ? "all pass: " : "all same: ") +
               plural(std::int64_t(entries_.size()), "picture") +
               (tolerated > 0 ? ", " + grouped((long long)tolerated) + " within the gates" : "") + "\n";
    words += grouped((long long)failed) + " of " + plural(std::int64_t(entries_.size()), "picture") + " failed" +
             (difference_only_.empty() ? "; see " + folder_ + "/report.html\n" : "\n");
    if (approvable > 0) words += "If the actual pictures are right: raster approve " + folder_ + "\n";
    return words;
}

std::string to_json(const ReportEntry& e) {
    JsonObject object;
    object.text("name", e.name)
        .text("verdict", to_string(e.verdict))
        .add("passes", passes(e.verdict) ? "true" : "false");
    object.add("approvable", e.approvable ? "true" : "false").text("reason", e.reason).text("golden", e.golden);
    object.add("expected", json_of(e.expected_path, e.expected_shape, e.expected_crc));
    object.add("actual", json_of(e.actual_path, e.actual_shape, e.actual_crc));
    object.add("width", std::to_string(e.width)).add("height", std::to_string(e.height));
    object.add("figures", e.figures ? json_of(*e.figures) : "null");
    object.add("gates", json_of(e.gates)).add("would_pass", array_of(e.would_pass, [](const Gates& g) {
                                                  return json_of(g);
                                              }));
    object.add("warnings", array_of(e.warnings, json_string)).add("notes", array_of(e.notes, json_string));
    object.add("regions", array_of(e.regions, [](const DiffRegion& r) { return json_of(r); }));
    object.add("region_count", std::to_string(e.region_count));
    object.add("files", JsonObject()
                            .text("actual", e.actual_file)
                            .text("difference", e.difference_file)
                            .text("triptych", e.triptych_file)
                            .str());
    return object.str();
}

std::string DiffReport::json() const {
    std::string out = "{\"schema\":\"raster-diff\",\"version\":1,\"pairs\":[";
    for (const ReportEntry& entry : entries_) out += (&entry == entries_.data() ? "\n" : ",\n") + to_json(entry);
    return out + "\n]}\n";
}

std::string DiffReport::junit() const {
    std::size_t failures = 0, errors = 0;
    std::string cases;
    for (const ReportEntry& entry : entries_) {
        cases += "    <testcase classname=\"raster.diff\" name=\"" + xml(entry.name) + "\"";
        if (passes(entry.verdict)) {
            cases += "/>\n";
            continue;
        }
        const bool error = entry.verdict == Verdict::unreadable;
        (error ? errors : failures) += 1;
        const std::string kind = error ? "error" : "failure";
        cases += ">\n      <" + kind + " type=\"" + to_string(entry.verdict) + "\" message=\"" +
                 xml(entry.reason.empty() ? to_string(entry.verdict) : entry.reason) + "\">" +
                 xml(to_string(entry, folder_)) + "</" + kind + ">\n    </testcase>\n";
    }
    const std::string counts = "tests=\"" + std::to_string(entries_.size()) + "\" failures=\"" +
                               std::to_string(failures) + "\" errors=\"" + std::to_string(errors) + "\"";
    return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites " + counts +
           ">\n  <testsuite name=\"raster diff\" " + counts + ">\n" + cases + "  </testsuite>\n</testsuites>\n";
}

}  // namespace raster
