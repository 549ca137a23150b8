// common.h: what most files of a build include, to be compiled once (everywhere.sh).
#if defined(__EMSCRIPTEN__)
#include "everywhere/emscripten.h"
#endif
#include <functional>
#include <map>
#include <optional>
#include <string>

#include <raster/pipeline.h>
#include <raster/scene/draw_plan.h>
