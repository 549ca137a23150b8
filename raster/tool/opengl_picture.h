// opengl_picture.h: a model's picture by OpenGL: the draws that the library plans, in GLSL.
#pragma once

#include <raster/scene/render.h>

#include "opengl.h"

namespace raster::tool {

/// What render(target, model, camera, options) draws, by OpenGL. Errors: usage for options that the GLSL shaders do not
/// know; input_output when OpenGL fails.
Result<OpenGlPicture> render_by_opengl(OpenGl& gl, const Model& model, const CameraMatrices& camera,
                                       const RenderOptions& options, int width, int height);

}  // namespace raster::tool
