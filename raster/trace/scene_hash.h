// scene_hash.h: a number for all that decides a picture, so that a trace can be told to belong to a scene.
#pragma once

#include <string>

#include <raster/scene/render.h>

namespace raster {

/// FNV-1a, 64 bits, as 16 hexadecimal digits, over the size of the picture, its background and everything its draws are
/// told: vertices, indices, matrices, states, materials, textures, lights. Equal scenes have equal hashes on every
/// machine; the name of the file does not count.
std::string scene_hash(const Model& model, const CameraMatrices& camera, const RenderOptions& options, int width,
                       int height);

}  // namespace raster
