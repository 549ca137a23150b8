// main.cpp: runs the suite: --seed=N picks other scenes, --scenes=N more of them; --hash prints the library's hashes.
#include <cstdio>
#include <cstdlib>
#include <string_view>

#include <gtest/gtest.h>

#include "catalogue.h"
#include "options.h"
#include "scene.h"

namespace {

/// Kind, seed and hash of what the library draws, as in references.txt.
void print_hashes() {
    using namespace raster::conformance;
    for (const Kind& kind : exact_kinds())
        for (int i = 0; i < options.scenes; ++i) {
            const std::uint64_t seed = options.seed * 1000 + std::uint64_t(i);
            const std::uint64_t hash = hash_of(render(kind.make(seed), Path::fast));
            std::printf("%s %llu %016llx\n", kind.name.c_str(), static_cast<unsigned long long>(seed),
                        static_cast<unsigned long long>(hash));
        }
}

}  // namespace

int main(int argc, char** argv) {
    using raster::conformance::options;
    testing::InitGoogleTest(&argc, argv);
    if (const char* seed = std::getenv("RASTER_SEED")) options.seed = std::strtoull(seed, nullptr, 10);
    bool hash = false;
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
        } else if (argument == "--hash") {
            hash = true;
        } else {
            std::fprintf(stderr, "usage: %s [--seed=N] [--scenes=N] [--hash] [--write-references=FILE]\n", argv[0]);
            return 2;
        }
    }
    if (hash) return print_hashes(), 0;
    return RUN_ALL_TESTS();
}
