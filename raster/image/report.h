// report.h: what is left behind of comparisons: text, diff.json, JUnit XML, pictures, and a page to look at them.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <raster/image/diff_files.h>

namespace raster {

/// A comparison without its pixels, as reports tell it.
struct ReportEntry {
    std::string name, golden;
    Verdict verdict = Verdict::same;
    std::string reason;
    std::string expected_path, actual_path;    ///< as given; "" when missing or no file
    std::string expected_shape, actual_shape;  ///< "800x600 RGB, 8 bits"; "" when there is no picture
    std::string expected_crc, actual_crc;      ///< CRC-32 of the files in hexadecimal, "" when missing
    std::optional<Figures> figures;
    Gates gates;
    std::vector<Gates> would_pass;
    std::vector<std::string> warnings, notes;
    std::vector<DiffRegion> regions;
    std::int64_t region_count = 0;
    int width = 0, height = 0;                           ///< of the expected picture, or the actual one
    std::string actual_file, difference_file, triptych_file;  ///< names in the report's folder, "" when not written
    bool approvable = false;                                   ///< it failed, and the actual picture could be the expected one
};

/// Gathers comparisons and writes about those that fail. Nothing is written, and no folder made, as long as all
/// pass; but what an earlier report left in the folder about pictures that now pass is removed, so that it cannot
/// be approved any more.
class DiffReport {
public:
    explicit DiffReport(std::string folder = "diff-out") : folder_(std::move(folder)) {}

    /// A report of one comparison that writes nothing but its difference, as the PNG file `path`.
    static DiffReport of_difference_only(const std::string& path);

    /// Takes in a comparison. If it fails, writes FOLDER/NAME.actual.* (a copy, for approving), NAME.diff.png and
    /// NAME.triptych.png. Errors: input_output.
    Status add(Comparison comparison, const Gates& gates);

    /// Once, after the last add: writes report.html and diff.json if anything failed. Errors: input_output.
    Status finish();

    const std::vector<ReportEntry>& entries() const { return entries_; }
    bool all_pass() const;
    /// 0 all pass, 1 some differ, 2 trouble: a file could not be read. As POSIX diff has it.
    int exit_code() const;

    /// For people: each comparison that fails or has something to say, then what to do.
    std::string text() const;
    std::string json() const;
    /// One test case a comparison (the format as Jenkins, GitLab and others read it).
    std::string junit() const;

private:
    Status write_pictures(Comparison& comparison, ReportEntry& entry);
    Status open_page();
    void add_without_pictures(const ReportEntry& entry, bool is_first);
    Status write_difference(const Comparison& comparison, ReportEntry& entry) const;
    void remove_earlier(const Comparison& comparison) const;

    std::string folder_;
    std::string difference_only_;  ///< the one file to write in the folder; empty: all
    std::vector<ReportEntry> entries_;
    std::optional<FileInPieces> page_;  ///< grows as comparisons come in; opened by the first that fails
    bool page_is_finished_ = false;
    std::size_t embedded_bytes_ = 0;    ///< of pictures in the page so far
};

/// One comparison in words: verdict, figures, gates, the tightest that would pass, paths.
std::string to_string(const ReportEntry& entry, const std::string& folder);

/// An entry as JSON, without its pictures.
std::string to_json(const ReportEntry& entry);

}  // namespace raster
