// main.cpp: raster_everywhere: a hash for each scene, and whether it is the one that stands in hashes.txt.
//
//   raster_everywhere --hash                    prints NAME HASH, one scene a line
//   raster_everywhere HASHES.TXT                compares; tells what differs; exit code 0 when nothing does, else 1
//   --models=DIR    also the model files of that folder
//   --threads=N     with so many threads (where the library has them)
#include <cstdio>
#include <cstdlib>
#include <map>
#include <optional>
#include <string_view>

#include "scenes.h"

#if !defined(RASTER_NO_THREADS)
#include <tbb/global_control.h>
#include <tbb/task_arena.h>
#endif

namespace {

using namespace raster::everywhere;

std::optional<std::map<std::string, std::string>> read_hashes(const char* path) {
    std::FILE* const file = std::fopen(path, "r");
    if (!file) return std::nullopt;
    std::map<std::string, std::string> hashes;
    char name[100], hash[20];
    while (std::fscanf(file, "%99s %19s", name, hash) == 2) hashes[name] = hash;
    std::fclose(file);
    return hashes;
}

/// How many scenes differ from the file or are missing in it.
int compare(const std::vector<Scene>& scenes, const std::map<std::string, std::string>& expected) {
    int wrong = 0;
    for (const Scene& scene : scenes) {
        const auto found = expected.find(scene.name);
        const std::string actual = hash_of(scene);
        if (found != expected.end() && found->second == actual) continue;
        std::printf("%s: %s, expected %s\n", scene.name.c_str(), actual.c_str(),
                    found == expected.end() ? "nothing" : found->second.c_str());
        ++wrong;
    }
    if (wrong)
        std::printf("where pictures were meant to change: raster_everywhere --hash --models=models >"
                    " tests/everywhere/hashes.txt\n");
    std::printf("%d of %d scenes equal\n", int(scenes.size()) - wrong, int(scenes.size()));
    return wrong;
}

}  // namespace

int main(int argc, char** argv) {
    const char* hashes = nullptr;
    std::string models;
    int threads = 0;
    for (int i = 1; i < argc; ++i) {
        const std::string_view argument = argv[i];
        if (argument.starts_with("--models="))
            models = argument.substr(9);
        else if (argument.starts_with("--threads="))
            threads = std::atoi(argv[i] + 10);
        else if (argument != "--hash")
            hashes = argv[i];
    }
    std::vector<Scene> scenes = stage_scenes();
    for (const auto& more : {model_scenes(), models.empty() ? std::vector<Scene>() : file_scenes(models)})
        scenes.insert(scenes.end(), more.begin(), more.end());
    const auto run = [&] {
        if (!hashes) {
            for (const Scene& scene : scenes) std::printf("%s %s\n", scene.name.c_str(), hash_of(scene).c_str());
            return 0;
        }
        const auto expected = read_hashes(hashes);
        if (!expected) return std::fprintf(stderr, "%s: cannot be read\n", hashes), 2;
        return compare(scenes, *expected) ? 1 : 0;
    };
#if !defined(RASTER_NO_THREADS)
    if (threads > 0) {
        const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, std::size_t(threads));
        tbb::task_arena arena(threads);
        return arena.execute(run);
    }
#endif
    (void)threads;
    return run();
}
