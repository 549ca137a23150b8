// obj_material.h: MTL files into materials.
#pragma once

#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include <raster/scene/model.h>
#include <raster/scene/obj_path.h>
#include <raster/scene/obj_report.h>

namespace raster::obj {

/// A texture that a material names, not loaded yet.
struct TextureUse {
    std::string name;      ///< as the file spells it
    std::size_t line = 0;  ///< in the MTL file
    int Material::*slot = nullptr;
};

/// A material, and what is needed to load its textures.
struct MaterialEntry {
    Material material;
    std::vector<TextureUse> textures;
    std::string file;    ///< the MTL file, for messages
    std::string folder;  ///< where it lies
};

/// The materials of all MTL files of a model, by name. Of two with one name the first counts.
struct MaterialLibrary {
    std::vector<MaterialEntry> entries;
    std::map<std::string, int, std::less<>> index;
};

/// Reads the statements of an MTL file. Faults are warnings: a number that is none leaves the value as it was, an
/// unknown key is skipped. Values are brought into their ranges.
void read_mtl(std::string_view bytes, const std::string& file, const std::string& folder, MaterialLibrary& library,
              Log& log);

/// Opens and reads the files that an mtllib statement names: several, or one with blanks in its name. Each is read
/// once. Without a finder none is opened.
class MaterialFiles {
public:
    MaterialFiles(const Finder* finder, std::size_t max_bytes) : finder_(finder), max_bytes_(max_bytes) {}
    void read(std::string_view names, const Place& place, MaterialLibrary& library, Log& log);

private:
    void read_found(const std::string& path, std::string_view name, const Place& place, MaterialLibrary& library,
                    Log& log);

    const Finder* finder_;
    std::size_t max_bytes_;
    std::set<std::string, std::less<>> statements_;
    std::set<std::string> opened_;
};

}  // namespace raster::obj
