// view_json.h: a view as JSON, for those who put it into a larger document.
#pragma once

#include "json.h"
#include "view.h"

namespace raster::tool {

Json to_json(const View& view);
Json to_json(const glm::vec3& v);

}  // namespace raster::tool
