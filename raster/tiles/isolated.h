// isolated.h: a loop over threads that can run under a lock.
#pragma once

#include <cstddef>

#include <raster/tiles/parallel.h>

#if !defined(RASTER_NO_THREADS) && !defined(RASTER_PLAIN_THREADS)
#include <tbb/task_arena.h>
#endif

namespace raster::tiles {

/// As parallel_for, but a thread that waits for the last calls takes up no other loop's work, which might want a lock
/// that this thread holds.
template <class Body>
inline void isolated_parallel_for(std::size_t count, const Body& body) {
#if defined(RASTER_NO_THREADS) || defined(RASTER_PLAIN_THREADS)
    parallel_for(count, body);
#else
    tbb::this_task_arena::isolate([&] { parallel_for(count, body); });
#endif
}

}  // namespace raster::tiles
