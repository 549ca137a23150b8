// materials.h: substances by name, and materials in the terms of physically based renderers.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include <raster/scene/model.h>

namespace raster {

/// The names of all substances: metals, stones, cloths, ...
std::vector<std::string_view> material_names();

/// A substance: its reflectance model, its colours in linear RGB and what its model needs, with the sources of the
/// figures in materials.cpp. Nothing when there is none of that name.
std::optional<Material> find_material(std::string_view name);

/// A material that has the physically based keys (Pr, Pm, ...), and no reflectance model of its own, in the terms of this
/// library's models: the roughness Pr becomes facets of the slope Pr^2, the share Pm of Kd the colour of a metal's
/// reflection and the rest diffuse; with `aniso` Ward's model. Any other material comes back as it is. Layers on top are
/// those of scene/material_model.h.
Material physically_based(const Material& material);

/// What a metal reflects of light from everywhere: its specular colour times the reflectance at normal incidence (Cook
/// and Torrance 1982, 4).
glm::vec3 metal_ambient(const Material& material);

}  // namespace raster
