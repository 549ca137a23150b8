// mtl_fuzz.cpp: libFuzzer target for MTL files and for the paths they name: values in range, nothing outside found.
// Build: clang++ -fsanitize=fuzzer,address,undefined; seeds: tests/fuzz/corpus/mtl.
#include <cstdlib>
#include <string_view>

#include <raster/scene/obj_material.h>

namespace {

using namespace raster;

void require(bool condition) {
    if (!condition) std::abort();
}

bool is_finite(float x) { return x - x == 0; }

void require_sound(const Material& m) {
    for (const glm::vec3& c : {m.ambient, m.diffuse, m.specular, m.emission})
        require(is_finite(c.x) && is_finite(c.y) && is_finite(c.z));
    require(is_finite(m.shininess) && m.shininess >= 0);
    require(is_finite(m.index_of_refraction) && m.index_of_refraction >= 0);
    for (const float f : {m.alpha, m.roughness, m.metallic, m.sheen, m.clearcoat, m.anisotropy})
        require(f >= 0 && f <= 1);
    require(m.illumination >= 0 && m.illumination <= 10);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    static const obj::Finder finder("/usr", false);
    for (const bool strict : {false, true}) {
        LoadReport report;
        obj::Log log(report, strict);
        obj::MaterialLibrary library;
        obj::read_mtl(text, "x.mtl", finder.folder(), library, log);
        require(library.index.size() == library.entries.size());
        require(!log.failed() || strict);
        for (const obj::MaterialEntry& entry : library.entries) {
            require_sound(entry.material);
            require(entry.textures.size() <= 5);
            for (const obj::TextureUse& use : entry.textures) {
                require(!use.name.empty() && use.slot != nullptr && use.line > 0);
                const Result<std::string> path = finder.find(use.name, finder.folder());
                require(path ? path->starts_with("/usr/") : !path.error().message.empty());
            }
        }
        for (const std::string& message : report.messages())
            for (const char c : message) require(static_cast<unsigned char>(c) >= 0x20 && c != 0x7f);
    }
    return 0;
}
