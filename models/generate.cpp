// generate.cpp: writes the files of this folder into the folder given.
#include <cstdio>
#include <span>
#include <string>

#include <raster/image/file.h>

#include "files.h"

int main(int argc, char** argv) {
    if (argc != 2) {
        std::fprintf(stderr, "usage: raster_models FOLDER\n");
        return 2;
    }
    for (const auto& [name, bytes] : raster::models::all_files()) {
        const std::string path = std::string(argv[1]) + "/" + name;
        const raster::Status status = raster::write_file(path, std::as_bytes(std::span(bytes)));
        if (!status) {
            std::fprintf(stderr, "error: %s\n", status.error().message.c_str());
            return 3;
        }
        std::printf("%s: %zu bytes\n", name.c_str(), bytes.size());
    }
    return std::fflush(stdout) == 0 ? 0 : 3;
}
