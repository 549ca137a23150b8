// append.h: several models become one, each at its place: how a scene is put together.
#pragma once

#include <string>

#include <glm/glm.hpp>

#include <raster/result.h>
#include <raster/scene/model.h>

namespace raster {

/// Adds a model, with its materials and textures, to another. Positions are taken along by the matrix, normals by its
/// inverse transpose and are of unit length again, the grain of materials as a direction; where the matrix mirrors, triangles are turned so that they keep
/// their front. Errors, of kind bad_input, and `into` is as it was: the matrix has no inverse or is not finite, a
/// position leaves the range of floats, or there are more than 2^32 vertices or indices.
Status append(Model& into, const Model& model, const glm::mat4& into_from_model);

}  // namespace raster
