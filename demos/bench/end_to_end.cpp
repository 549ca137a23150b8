// end_to_end.cpp: the picture of the rival's process, and the clock around both.
#include "end_to_end.h"

#include <stdlib.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>

#define STB_IMAGE_WRITE_STATIC
#define STB_IMAGE_WRITE_IMPLEMENTATION
#include <stb/stb_image_write.h>

#include "rival.h"

namespace bench {

bool write_rival_picture(const Scene& scene, int width, int height, const std::string& path) {
    Rival rival(scene, width, height);
    if (!rival.ok()) return false;
    rival.frame();
    return stbi_write_png(path.c_str(), width, height, 4, rival.color().data(), 4 * width) != 0;
}

nlohmann::json end_to_end(const std::string& ours, const std::string& rival, int runs) {
    char folder[] = "/tmp/raster_bench_XXXXXX";
    if (!mkdtemp(folder)) return {{"error", "cannot make a folder for the pictures"}};
    const std::string output = std::string(folder) + "/picture.png";
    double best[2] = {1e9, 1e9};
    bool worked = true;
    // The first run of each warms the file cache.
    for (int run = -1; run < runs && worked; ++run)
        for (int who = 0; who < 2; ++who) {
            const std::string command = (who == 0 ? ours : rival) + " '" + output + "'";
            const auto start = std::chrono::steady_clock::now();
            worked = worked && std::system(command.c_str()) == 0;
            const std::chrono::duration<double, std::milli> time = std::chrono::steady_clock::now() - start;
            if (run >= 0) best[who] = std::min(best[who], time.count());
        }
    unlink(output.c_str());
    rmdir(folder);
    if (!worked) return {{"error", "a command failed: " + ours + ", or " + rival}};
    return {{"ours_best", best[0]}, {"rival_best", best[1]}, {"ratio", best[1] / best[0]}};
}

}  // namespace bench
