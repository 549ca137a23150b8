// pages.h: memory for large pictures, asked for at once.
#pragma once

#include <cstddef>
#include <vector>

namespace raster {

/// Has the system back `bytes` of memory that will be written whole. Else it does so page by page at the first touch,
/// which takes twice as long. Does nothing for what is small, or where the system does not know how.
void back_with_pages(void* memory, std::size_t bytes);

/// `values.resize(size)` for a vector that is empty.
template <class T>
void resize_whole(std::vector<T>& values, std::size_t size) {
    values.reserve(size);
    back_with_pages(values.data(), size * sizeof(T));
    values.resize(size);
}

}  // namespace raster
