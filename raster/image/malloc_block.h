// malloc_block.h: memory that C code gave or will take, freed by its owner.
#pragma once

#include <cstdlib>
#include <memory>

namespace raster {

struct FreeBlock {
    void operator()(void* memory) const { std::free(memory); }
};

template <class T>
using MallocBlock = std::unique_ptr<T, FreeBlock>;

}  // namespace raster
