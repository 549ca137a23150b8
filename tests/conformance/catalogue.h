// catalogue.h: the kinds of scenes on which the library and OpenGL must agree.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "scene.h"

namespace raster::conformance {

/// One kind: any seed gives one scene of it, the same on every machine.
struct Kind {
    std::string name;
    Scene (*make)(std::uint64_t seed);
};

/// The kinds in which not one bit may differ.
const std::vector<Kind>& exact_kinds();
/// The kinds in which colours may differ by 1/255.
const std::vector<Kind>& close_kinds();

}  // namespace raster::conformance
