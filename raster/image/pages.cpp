// pages.cpp: madvise, by all threads.
#include <raster/image/pages.h>

#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <cstdint>

#include <raster/tiles/parallel.h>

namespace raster {

void back_with_pages([[maybe_unused]] void* memory, [[maybe_unused]] std::size_t bytes) {
#if defined(MADV_POPULATE_WRITE)
    constexpr std::size_t least = std::size_t(1) << 20, piece = std::size_t(4) << 20;
    if (bytes < least) return;
    const std::uintptr_t page = std::uintptr_t(::sysconf(_SC_PAGESIZE));
    const std::uintptr_t first = (std::uintptr_t(memory) + page - 1) / page * page;
    const std::uintptr_t end = (std::uintptr_t(memory) + bytes) / page * page;
    tiles::parallel_for((end - first + piece - 1) / piece, [&](std::size_t i) {
        const std::uintptr_t start = first + i * piece;
        // Where it fails, as on kernels before 5.14, pages come at the first touch.
        (void)::madvise(reinterpret_cast<void*>(start), std::min<std::uintptr_t>(piece, end - start),
                        MADV_POPULATE_WRITE);
    });
#endif
}

}  // namespace raster
