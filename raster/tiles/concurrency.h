// concurrency.h: whether loops are spread over threads at all.
#pragma once

#include <raster/tiles/parallel.h>

#if !defined(RASTER_NO_THREADS) && !defined(RASTER_PLAIN_THREADS)
#include <tbb/global_control.h>
#include <tbb/task_arena.h>
#endif

namespace raster::tiles {

/// Whether parallel_for is more than a loop: what would only make parts for it can be left out then.
inline bool has_several_threads() {
#if defined(RASTER_NO_THREADS)
    return false;
#elif defined(RASTER_PLAIN_THREADS)
    return true;
#else
    return tbb::this_task_arena::max_concurrency() > 1 &&
           tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism) > 1;
#endif
}

}  // namespace raster::tiles
