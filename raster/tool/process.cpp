// process.cpp: standard streams and signals.
#include "process.h"

#include <fcntl.h>
#include <signal.h>
#include <unistd.h>

#include <cstddef>

namespace raster::tool {
namespace {

/// Under a limit on memory (ulimit -v) a stack that cannot grow later is a segmentation fault, which nobody can catch.
[[gnu::noinline]] void grow_stack() {
    volatile char room[256 * 1024];
    for (std::size_t i = 0; i < sizeof room; i += 1024) room[i] = 0;
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
}

}  // namespace raster::tool
