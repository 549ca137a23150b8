// Loops under a lock: threads that wait in one take up nothing else, and whoever looks at a clear sees all of it.
#include <raster/tiles/isolated.h>

#include <atomic>
#include <chrono>
#include <thread>

#include <gtest/gtest.h>
#include <tbb/global_control.h>
#include <tbb/task_arena.h>

#include <raster/target.h>

namespace {

using namespace raster;

TEST(IsolatedLoop, CallsItsBodyOnceForEachNumber) {
    std::vector<int> calls(1000);
    tiles::isolated_parallel_for(calls.size(), [&](std::size_t i) { ++calls[i]; });
    EXPECT_EQ(calls, std::vector<int>(1000, 1));
}

TEST(IsolatedLoop, AThreadThatWaitsForItTakesUpNoOtherLoopsWork) {
    const tbb::global_control eight(tbb::global_control::max_allowed_parallelism, 8);
    thread_local bool inside = false;
    std::atomic<int> taken_up = 0;
    const auto wait = [] { std::this_thread::sleep_for(std::chrono::microseconds(100)); };
    tbb::task_arena(8).execute([&] {
        tiles::parallel_for(256, [&](std::size_t i) {
            if (inside) ++taken_up;
            wait();
            if (i % 4 != 0) return;
            inside = true;
            tiles::isolated_parallel_for(16, [&](std::size_t) { wait(); });
            inside = false;
        });
    });
    EXPECT_EQ(taken_up, 0);
}

TEST(IsolatedLoop, ThreadsThatLookAtALargeClearAtOnceSeeAllOfIt) {
    std::vector<Target> targets(3, Target(1100, 1000));
    for (int round = 0; round < 10; ++round) {
        for (Target& t : targets) t.clear(round % 2 ? glm::vec4(1) : glm::vec4(0));
        std::vector<std::uint32_t> seen(48);
        tiles::parallel_for(seen.size(), [&](std::size_t i) { seen[i] = targets[i % 3].color8()[i * 22'000]; });
        EXPECT_EQ(seen, std::vector<std::uint32_t>(48, round % 2 ? 0xffffffffu : 0u));
    }
}

}  // namespace
