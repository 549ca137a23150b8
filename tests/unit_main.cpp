// unit_main.cpp: the unit tests' program: GoogleTest's main, and --hash, which prints NAME HASH, one scene a line.
#include <cstdio>
#include <string_view>

#include <gtest/gtest.h>

#include "everywhere/scenes.h"

int main(int argc, char** argv) {
    testing::InitGoogleTest(&argc, argv);
    if (argc > 1 && std::string_view(argv[1]) == "--hash") {
        using namespace raster::everywhere;
        for (const auto& scenes : {stage_scenes(), model_scenes()})
            for (const Scene& scene : scenes) std::printf("%s %s\n", scene.name.c_str(), hash_of(scene).c_str());
        return 0;
    }
    return RUN_ALL_TESTS();
}
