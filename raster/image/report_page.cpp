// report_page.cpp: puts the report page together: markup, style, script, and the comparisons as JSON.
#include <raster/image/report_page.h>

#include <algorithm>
#include <string_view>

#include <raster/image/data_url.h>
#include <raster/image/report_json.h>

namespace raster {
namespace {

void write_text(std::string_view text, const Sink& sink) { sink(std::as_bytes(std::span(text))); }

/// A data URL, in pieces that stay near the processor: pictures have megabytes.
void write_url(const Bytes& picture, const Sink& sink) {
    const char* type = picture_type(picture);
    if (type == nullptr) return;
    write_text(std::string("data:") + type + ";base64,", sink);
    constexpr std::size_t piece = 3 << 16;
    std::string digits;
    for (std::size_t start = 0; start < picture.size(); start += piece) {
        base64(std::span(picture).subspan(start, std::min(piece, picture.size() - start)), digits);
        write_text(digits, sink);
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

void write_page_start(const std::string& folder, const Sink& sink) {
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
}

void write_page_entry_start(const std::string& facts, bool is_first, const Sink& sink) {
    write_text(is_first ? "\n{\"facts\":" : ",\n{\"facts\":", sink);
    write_text(facts, sink);
}

void write_page_picture(const char* name, const Bytes& picture, const Sink& sink) {
    // Of letters that need no escaping.
    write_text(std::string(",\"") + name + "\":\"", sink);
    write_url(picture, sink);
    write_text("\"", sink);
}

void write_page_entry_end(const Sink& sink) { write_text("}", sink); }

void write_page_end(const Sink& sink) {
    const auto write = [&](std::string_view text) { write_text(text, sink); };
    write("]}");
    write("</script>\n<script>\n");
    write(report_parts::script_panes);
    write(report_parts::script_view);
    write("</script>\n</body>\n</html>\n");
}

}  // namespace raster
