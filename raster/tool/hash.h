// hash.h: a number for the contents of a picture, whatever file it is stored in.
#pragma once

#include <cstdint>
#include <string>

#include <raster/target.h>

namespace raster::tool {

/// FNV-1a, 64 bits (http://www.isthe.com/chongo/tech/comp/fnv/), of the picture's width and height, each as 4 bytes,
/// the least significant first, and of its pixels row by row from the top left: 4 bytes R, G, B, A, or for float
/// colours 4 floats of 4 bytes. As 16 hexadecimal digits.
std::string content_hash(const Target& target);

}  // namespace raster::tool
