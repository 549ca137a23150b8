// report_page.h: the parts of the report page, each a source file of its own.
#pragma once

#include <raster/image/file.h>

namespace raster {

/// The MIME type of a picture file that browsers show, or nullptr.
const char* picture_type(const Bytes& file);

}  // namespace raster

namespace raster::report_parts {

extern const char* const style;  ///< CSS
extern const char* const body;   ///< HTML inside the body element
/// JavaScript, run after the body, one after the other.
extern const char* const script_panes;
extern const char* const script_view;

}  // namespace raster::report_parts
