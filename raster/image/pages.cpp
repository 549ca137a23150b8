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
    const auto advise = [](std::uintptr_t from, std::uintptr_t to, int advice) {
        (void)::madvise(reinterpret_cast<void*>(from), to - from, advice);
    };
#if defined(MADV_HUGEPAGE)
    advise(first, end, MADV_HUGEPAGE);
#endif
    // At multiples of the piece, since two threads that meet in a large page would both clear it.
    const std::uintptr_t first_piece = first / piece;
    tiles::parallel_for((end + piece - 1) / piece - first_piece, [&](std::size_t i) {
        const std::uintptr_t start = (first_piece + i) * piece;
        // Where it fails, as on kernels before 5.14, pages come at the first touch.
        advise(std::max(start, first), std::min<std::uintptr_t>(start + piece, end), MADV_POPULATE_WRITE);
    });
#if defined(MADV_HUGEPAGE)
    // What is there stays so. But of small blocks that come to this place later, none shall be given 2 MB.
    advise(first, end, MADV_NOHUGEPAGE);
#endif
#endif
}

}  // namespace raster
