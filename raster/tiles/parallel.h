// parallel.h: the one place that knows how loops are spread over threads: oneTBB.
#pragma once

#include <cstddef>

#if defined(__has_feature)
#if __has_feature(thread_sanitizer)
#define RASTER_PLAIN_THREADS 1
#endif
#elif defined(__SANITIZE_THREAD__)
#define RASTER_PLAIN_THREADS 1
#endif

#if defined(RASTER_PLAIN_THREADS)
#include <array>
#include <thread>
#elif !defined(RASTER_NO_THREADS)
#include <tbb/parallel_for.h>
#endif

namespace raster::tiles {

/// Calls body(i) for each i in 0..count-1, on all threads of the current task arena, in any order. To use fewer
/// threads, draw inside a tbb::task_arena or under a tbb::global_control.
template <class Body>
inline void parallel_for(std::size_t count, const Body& body) {
#if defined(RASTER_NO_THREADS)
    for (std::size_t i = 0; i < count; ++i) body(i);
#elif defined(RASTER_PLAIN_THREADS)
    // The thread sanitizer does not see how oneTBB, which is compiled without it, hands work over, and takes that for
    // races. With plain threads it reports what the bodies share.
    std::array<std::thread, 4> threads;
    for (std::size_t t = 0; t < threads.size(); ++t)
        threads[t] = std::thread([&, t] {
            for (std::size_t i = t; i < count; i += threads.size()) body(i);
        });
    for (std::thread& t : threads) t.join();
#else
    if (count == 1) {
        body(0);
    } else {
        tbb::parallel_for(std::size_t(0), count, body);
    }
#endif
}

}  // namespace raster::tiles
