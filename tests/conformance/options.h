// options.h: what the command line of the suite says.
#pragma once

#include <cstdint>
#include <string>

namespace raster::conformance {

struct Options {
    std::uint64_t seed = 1;        ///< --seed=N, else the environment's RASTER_SEED
    int scenes = 4;                ///< --scenes=N of each kind
    std::string write_references;  ///< --write-references=FILE: from OSMesa's pictures
};
inline Options options;

}  // namespace raster::conformance
