// lit_pair.h: one lit model, drawn by the library and by GLSL on OSMesa.
#pragma once

#include <gtest/gtest.h>

#include "opengl_picture.h"
#include "scene.h"

namespace raster::conformance {

struct LitPair {
    Picture ours, theirs;
};

/// Both pictures, width x height. Fails the test, and leaves `pair` as it is, where one cannot be drawn.
inline void draw_lit_pair(tool::OpenGl& gl, const Model& model, const Camera& camera, const RenderOptions& options,
                          int width, int height, LitPair& pair) {
    const auto matrices = camera_matrices(with_planes_around(camera, bounding_box(model)), double(width) / height);
    ASSERT_TRUE(matrices);
    Target target(width, height);
    render(target, model, *matrices, options);
    const auto opengl = tool::render_by_opengl(gl, model, *matrices, options, width, height);
    ASSERT_TRUE(opengl) << opengl.error().message;
    pair = {{target.color8(), target.depth()}, {opengl->color, opengl->depth}};
}

}  // namespace raster::conformance
