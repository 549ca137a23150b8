// parallel.h: the one place that knows how loops are spread over threads: oneTBB.
#pragma once

#include <cstddef>

#if !defined(RASTER_NO_THREADS)
#include <tbb/parallel_for.h>
#endif

namespace raster::tiles {

/// Calls body(i) for each i in 0..count-1, on all threads of the current task arena, in any order. To use fewer
/// threads, draw inside a tbb::task_arena or under a tbb::global_control.
template <class Body>
inline void parallel_for(std::size_t count, const Body& body) {
#if defined(RASTER_NO_THREADS)
    for (std::size_t i = 0; i < count; ++i) body(i);
#else
    if (count == 1) {
        body(0);
    } else {
        tbb::parallel_for(std::size_t(0), count, body);
    }
#endif
}

}  // namespace raster::tiles
