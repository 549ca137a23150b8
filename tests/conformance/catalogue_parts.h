// catalogue_parts.h: what scenes of many kinds are made of, and the lists that make up the catalogue.
#pragma once

#include "catalogue.h"
#include "scenes.h"

namespace raster::conformance {

using raster::testing::Group;
using raster::testing::Random;

glm::vec4 random_color(Random& random, float low, float high);
Blend random_blend(Random& random);

/// Most scenes are small; some have the sizes that people use.
Scene empty_scene(Random& random);

/// Twelve of the groups in turn; noperspective draws leave out those in which Mesa divides 0 by 0
/// (docs/conformance.md).
Group random_group(Random& random, bool unclipped = false);

/// Triangles of one group for a viewport of this size. Colours go beyond 0 to 1 where OpenGL keeps such.
Draw make_draw(Group group, Random& random, int count, int width, int height, Coloring coloring = Coloring::smooth);

/// What is drawn: groups of triangles, colours, textures, blending, fans and strips, lines and points.
std::vector<Kind> primitive_kinds();
/// State: depth, culling, viewports, clearing, scissor, depth offset, clip planes, and all at once.
std::vector<Kind> state_kinds();

}  // namespace raster::conformance
