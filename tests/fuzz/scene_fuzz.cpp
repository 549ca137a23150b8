// scene_fuzz.cpp: libFuzzer target for scene files: flags and a sound model, or an error that names line and column.
// Build: clang++ -fsanitize=fuzzer,address,undefined; seeds: tests/fuzz/corpus/scene.
#include <cstdlib>
#include <string>

#include <CLI/CLI.hpp>

#include "scene_file.h"

namespace {

using namespace raster;
using namespace raster::tool;

void require(bool condition) {
    if (!condition) std::abort();
}

bool is_finite(float x) { return x - x == 0; }

const std::string path = "/nonexistent/s.json";

/// /nonexistent/s.json:LINE:COLUMN: and some words that a terminal can show.
void require_place(const Error& error) {
    const std::string& m = error.message;
    require(error.kind == ErrorKind::bad_input && m.starts_with(path + ":"));
    const char* at = m.c_str() + path.size() + 1;
    char* end = nullptr;
    require(std::strtol(at, &end, 10) >= 1 && *end == ':');
    require(std::strtol(end + 1, &end, 10) >= 1 && *end == ':' && end[1] == ' ' && end[2] != 0);
    for (const char c : m) require(static_cast<unsigned char>(c) >= 0x20 && c != 0x7f);
}

void require_sound(const Model& model) {
    require(model.indices.size() % 3 == 0);
    for (const std::uint32_t i : model.indices) require(i < model.vertices.size());
    for (const auto& v : model.vertices)
        for (int c = 0; c < 3; ++c) require(is_finite(v.position[c]) && is_finite(v.normal[c]));
    for (const Part& part : model.parts) require(part.material < int(model.materials.size()));
    for (const Material& m : model.materials) {
        for (const glm::vec3& c : {m.ambient, m.diffuse, m.specular, m.emission})
            for (int i = 0; i < 3; ++i) require(is_finite(c[i]) && c[i] >= 0);
        for (const float f : {m.alpha, m.roughness, m.metallic, m.anisotropy, m.anisotropy_rotation, m.sheen,
                              m.clearcoat, m.clearcoat_roughness})
            require(f >= 0 && f <= 1);
    }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
    const Result<SceneFile> scene = SceneFile::parse(path, std::string(reinterpret_cast<const char*>(data), size));
    if (!scene) {
        require_place(scene.error());
        return 0;
    }
    CLI::App app;
    std::vector<std::string> words;
    for (const char* flag : {"--light", "--size", "--camera-position", "--camera-view-angle", "--background", "--shade",
                             "--display", "--exposure", "--reflectance", "--two-sided"})
        app.add_option(flag, words);
    if (const Status status = scene->set_flags(app); !status) require_place(status.error());

    ObjOptions options;
    options.max_triangles = 20000;
    LoadReport report;
    const Result<Model> model = scene->load(options, report);
    if (model) {
        require_sound(*model);
    } else {
        require_place(model.error());
    }
    return 0;
}
