// main.cpp: runs the suite: --seed=N picks other scenes, --scenes=N more of them.
#include <cstdio>
#include <cstdlib>
#include <string_view>

#include <gtest/gtest.h>

#include "options.h"

int main(int argc, char** argv) {
    using raster::conformance::options;
    testing::InitGoogleTest(&argc, argv);
    if (const char* seed = std::getenv("RASTER_SEED")) options.seed = std::strtoull(seed, nullptr, 10);
    for (int i = 1; i < argc; ++i) {
        const std::string_view argument = argv[i];
        const auto value = [&](std::string_view flag) -> const char* {
            return argument.starts_with(flag) ? argv[i] + flag.size() : nullptr;
        };
        if (const char* seed = value("--seed=")) {
            options.seed = std::strtoull(seed, nullptr, 10);
        } else if (const char* scenes = value("--scenes=")) {
            options.scenes = std::atoi(scenes);
        } else if (const char* file = value("--write-references=")) {
            options.write_references = file;
        } else {
            std::fprintf(stderr, "usage: %s [--seed=N] [--scenes=N] [--write-references=FILE]\n", argv[0]);
            return 2;
        }
    }
    return RUN_ALL_TESTS();
}
