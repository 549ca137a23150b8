// report_page.cpp: puts the report page together: markup, style, script, and the comparisons as JSON.
#include <raster/image/report_page.h>

#include <algorithm>
#include <string_view>

#include <raster/image/data_url.h>
#include <raster/image/report.h>
#include <raster/image/report_json.h>
#include <raster/tiles/parallel.h>

namespace raster {
namespace {

void write_text(std::string_view text, const Sink& sink) { sink(std::as_bytes(std::span(text))); }

/// A data URL, in pieces: pictures have megabytes. One is encoded while the last is written; they are large enough that
/// another thread has time to join in.
void write_url(const Bytes& picture, const Sink& sink) {
    const char* type = picture_type(picture);
    if (type == nullptr) return;
    write_text(std::string("data:") + type + ";base64,", sink);
    constexpr std::size_t piece = 3 << 19;
    std::string written, next;
    for (std::size_t start = 0; start < picture.size() + piece; start += piece) {
        std::swap(written, next);
        tiles::parallel_for(2, [&](std::size_t i) {
            if (i == 0)
                write_text(written, sink);
            else if (start >= picture.size())
                next.clear();
            else
                base64(std::span(picture).subspan(start, std::min(piece, picture.size() - start)), next);
        });
    }
}

}  // namespace

const char* picture_type(const Bytes& file) {
    const auto starts = [&](std::string_view magic) {
        const auto bytes = std::as_bytes(std::span(magic));
        return file.size() > magic.size() && std::equal(bytes.begin(), bytes.end(), file.begin());
    };
    if (starts("\x89PNG")) return "image/png";
    if (starts("\xff\xd8\xff")) return "image/jpeg";
    if (starts("BM")) return "image/bmp";
    return nullptr;
}

void write_report_page(const std::vector<ReportEntry>& entries, const std::string& folder, const Sink& sink) {
    const auto write = [&](std::string_view text) { write_text(text, sink); };
    // The policy forbids the page every connection, whatever a picture's name says.
    write(
        "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
        "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
        "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; img-src data:; "
        "style-src 'unsafe-inline'; script-src 'unsafe-inline'\">\n<title>raster diff</title>\n<style>\n");
    write(report_parts::style);
    write("</style>\n</head>\n<body>\n");
    write(report_parts::body);
    write("<script type=\"application/json\" id=\"data\">");
    write("{\"folder\":" + json_string(folder) + ",\"pairs\":[");
    for (const ReportEntry& entry : entries) {
        write(&entry == entries.data() ? "\n{\"facts\":" : ",\n{\"facts\":");
        write(to_json(entry));
        // Of letters that need no escaping.
        write(",\"expected\":\"");
        write_url(entry.expected_picture, sink);
        write("\",\"actual\":\"");
        write_url(entry.actual_picture, sink);
        write("\",\"difference\":\"");
        write_url(entry.difference_picture, sink);
        write("\",\"flip\":\"");
        write_url(entry.flip_picture, sink);
        write("\"}");
    }
    write("]}");
    write("</script>\n<script>\n");
    write(report_parts::script_panes);
    write(report_parts::script_view);
    write("</script>\n</body>\n</html>\n");
}

}  // namespace raster
