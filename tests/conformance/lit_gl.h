// lit_gl.h: a planned draw of the library, drawn by OpenGL with shaders written from the textbook's formulas.
#pragma once

#include <raster/scene/draw_plan.h>

#include "osmesa.h"

namespace raster::conformance {

/// The picture that render(model, camera, options) of the library is compared with.
Picture render_lit(Oracle& oracle, const Model& model, const CameraMatrices& camera, const RenderOptions& options,
                   int width, int height);

}  // namespace raster::conformance
