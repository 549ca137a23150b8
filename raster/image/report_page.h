// report_page.h: the parts of the report page, each a source file of its own.
#pragma once

#include <raster/image/file.h>

namespace raster {

/// The MIME type of a picture file that browsers show, or nullptr.
const char* picture_type(const Bytes& file);

/// The page, in the order it is written: its start; of each comparison a start with its facts in JSON, its pictures
/// ("expected", "actual", "difference", "flip"; empty where there is none) and an end; the page's end.
/// One file, no network, opens from disk.
void write_page_start(const std::string& folder, const Sink& sink);
void write_page_entry_start(const std::string& facts, bool is_first, const Sink& sink);
void write_page_picture(const char* name, const Bytes& picture, const Sink& sink);
void write_page_entry_end(const Sink& sink);
void write_page_end(const Sink& sink);

}  // namespace raster

namespace raster::report_parts {

extern const char* const style;  ///< CSS
extern const char* const body;   ///< HTML inside the body element
/// JavaScript, run after the body, one after the other.
extern const char* const script_panes;
extern const char* const script_view;

}  // namespace raster::report_parts
