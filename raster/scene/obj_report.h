// obj_report.h: collects the faults that loading meets, counted by kind.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>

#include <raster/result.h>
#include <raster/scene/obj.h>

namespace raster::obj {

/// Where something stands.
struct Place {
    std::string_view file;
    std::size_t line = 0;  ///< from 1; 0 for the file as a whole
};

/// Text from a file, made fit for a message: control characters and broken UTF-8 as \\xNN, cut when long.
std::string printable(std::string_view text);
/// The same between quotes.
std::string in_quotes(std::string_view text);

class Log {
public:
    Log(LoadReport& report, bool strict) : report_(report), strict_(strict) {}

    /// A fault in the data, of a kind that is counted: "face dropped: zero area", "faces dropped: zero area".
    void count(const Place& place, std::string_view singular, std::string_view plural, std::size_t times = 1);
    /// A fault in the data that has a name in its text.
    void warn(const Place& place, const std::string& text);
    /// The file is right, but this library leaves out what it says. Never an error.
    void note(const Place& place, const std::string& text);
    /// Ends the loading. The first error counts.
    void fail(const Place& place, const std::string& text);

    /// Whether take_over() leaves the report as if all that is in `next` had come here one by one.
    bool can_take_over(const LoadReport& next) const;
    /// Appends what was found in a later piece of the file; its lines come after the first `lines_before`.
    void take_over(const LoadReport& next, std::size_t lines_before);

    bool is_strict() const { return strict_; }
    bool failed() const { return error_.has_value(); }
    const Error& error() const { return *error_; }
    LoadReport& report() { return report_; }

private:
    void add(const Place& place, std::string_view text, std::string_view plural, std::size_t times);

    LoadReport& report_;
    bool strict_;
    std::optional<Error> error_;
    std::unordered_map<std::string, std::size_t> known_;  ///< text and file to the index of the warning
};

}  // namespace raster::obj
