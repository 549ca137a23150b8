// process.cpp: standard streams and signals.
#include "process.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/mman.h>
#include <unistd.h>

#include <cstddef>
#include <cstdint>
#include <cstdlib>

#if defined(__GLIBC__)
#include <malloc.h>
#endif

namespace raster::tool {
namespace {

/// Under a limit on memory (ulimit -v) a stack that cannot grow later is a segmentation fault, which nobody can catch.
[[gnu::noinline]] void grow_stack() {
    volatile char room[256 * 1024];
    for (std::size_t i = 0; i < sizeof room; i += 1024) room[i] = 0;
}

/// A third of a picture's time went into fresh pages of 4 kB, many of them for memory that had just been given back. So
/// what is freed is kept, all threads share one heap, and its first 64 MB have pages of 2 MB, where the system knows
/// them.
void prepare_heap() {
#if defined(__GLIBC__) && defined(MADV_HUGEPAGE)
    constexpr int megabyte = 1 << 20;
    ::mallopt(M_MMAP_THRESHOLD, 32 * megabyte);
    ::mallopt(M_TRIM_THRESHOLD, 256 * megabyte);
    ::mallopt(M_TOP_PAD, 64 * megabyte);
    ::mallopt(M_ARENA_MAX, 1);
    const std::uintptr_t before = std::uintptr_t(::sbrk(0));
    void* volatile grown = std::malloc(std::size_t(megabyte));  // compilers leave out what is freed at once
    std::free(grown);
    const std::uintptr_t end = std::uintptr_t(::sbrk(0)), huge = 2 * megabyte;
    const std::uintptr_t first = (before + huge - 1) / huge * huge;
    if (first < end) (void)::madvise(reinterpret_cast<void*>(first), end - first, MADV_HUGEPAGE);
#endif
}

}  // namespace

void prepare_process() {
    for (int fd = 0; fd < 3; ++fd) {
        if (::fcntl(fd, F_GETFD) >= 0) continue;
        // The lowest free number is the one given, so this is fd itself.
        (void)!::open("/dev/null", fd == STDIN_FILENO ? O_WRONLY : O_RDONLY);
    }
    ::signal(SIGPIPE, SIG_IGN);
    ::signal(SIGXFSZ, SIG_IGN);
    grow_stack();
    prepare_heap();
}

}  // namespace raster::tool
