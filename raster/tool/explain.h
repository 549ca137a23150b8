// explain.h: `raster diff --explain MODEL`: the cause of each cluster of differing pixels.
#pragma once

#include <raster/image/diff_files.h>

#include "picture.h"
#include "view.h"

namespace raster::tool {

struct ExplainFlags {
    LoadFlags load;  ///< no model: nothing is to be explained
    ViewFlags view;
    PictureFlags picture;
};
/// --explain, and the flags of `raster render` that say what picture of the model it is.
void add_explain_flags(CLI::App& app, ExplainFlags& flags);

/// What there is to say of a comparison, as text or as a JSON array. Both pictures are of the model, drawn with these
/// flags; the size is theirs.
struct Explained {
    std::string text, json;
};
Result<Explained> explain(const ExplainFlags& flags, const Comparison& comparison);

}  // namespace raster::tool
