// report_page.cpp: puts the report page together: markup, style, script, and the comparisons as JSON.
#include <raster/image/report.h>
#include <raster/image/report_json.h>
#include <raster/image/report_page.h>

namespace raster {

std::string report_page(const std::vector<ReportEntry>& entries, const std::string& folder) {
    std::size_t size = 65536;
    for (const ReportEntry& e : entries)
        size += 4096 + e.expected_url.size() + e.actual_url.size() + e.difference_url.size() + e.flip_url.size();
    std::string page;
    page.reserve(size);
    // The policy forbids the page every connection, whatever a picture's name says.
    page += "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
            "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
            "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; img-src data:; "
            "style-src 'unsafe-inline'; script-src 'unsafe-inline'\">\n<title>raster diff</title>\n<style>\n";
    page += report_parts::style;
    page += "</style>\n</head>\n<body>\n";
    page += report_parts::body;
    page += "<script type=\"application/json\" id=\"data\">";
    page += "{\"folder\":" + json_string(folder) + ",\"pairs\":[";
    for (const ReportEntry& entry : entries) {
        page += &entry == entries.data() ? "\n{\"facts\":" : ",\n{\"facts\":";
        page += to_json(entry);
        // Megabytes, of letters that need no escaping.
        page += ",\"expected\":\"" + entry.expected_url;
        page += "\",\"actual\":\"" + entry.actual_url;
        page += "\",\"difference\":\"" + entry.difference_url;
        page += "\",\"flip\":\"" + entry.flip_url;
        page += "\"}";
    }
    page += "]}";
    page += "</script>\n<script>\n";
    page += report_parts::script_panes;
    page += report_parts::script_view;
    page += "</script>\n</body>\n</html>\n";
    return page;
}

}  // namespace raster
