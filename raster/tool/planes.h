// planes.h: what --aov writes beside the picture: depth, normals, triangle numbers, overdraw, the terms of the light.
#pragma once

#include <string_view>
#include <vector>

#include <raster/image/image.h>
#include <raster/scene/render.h>

#include "outputs.h"
#include "view.h"

namespace raster::tool {

/// A list such as depth,normal.pfm. No plane twice.
Result<std::vector<PlaneChoice>> parse_planes(std::string_view text);
extern const char* const planes_help;

/// Draws what the planes need and makes pictures of it.
class PlaneRenderer {
public:
    PlaneRenderer(const Model& model, const View& view, const RenderOptions& options);

    /// `picture` is the target the picture was drawn to.
    ImageF floats(const PlaneChoice& plane, const Target& picture);
    Image8 colors(const PlaneChoice& plane, const Target& picture);

private:
    const Target& terms();
    const Target& overdraw();

    const Model& model_;
    const View& view_;
    const RenderOptions& options_;
    std::optional<Target> terms_, overdraw_;
};

}  // namespace raster::tool
