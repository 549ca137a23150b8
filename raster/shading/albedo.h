// albedo.h: the colour that a reflectance model has under light from everywhere.
#pragma once

#include <raster/shading/models.h>

namespace raster {

/// Of light that comes alike from everywhere, the part that the diffuse term of an isotropic model gives back to all
/// sides together, 0 to 1 for each channel, before kd: 1 of Lambert's, the colour itself of one that `has_own_color`. By
/// a fixed sum over 12288 pairs of directions, some milliseconds; off by 0.002 at most where highlights are wider than 3
/// degrees.
glm::vec3 diffuse_albedo(const AnyReflectance& model);

/// The same of models that have colours of their own; 1 of the others, whose colour is kd.
glm::vec3 own_color(const AnyReflectance& model);

}  // namespace raster
