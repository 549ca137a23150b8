// obj_texture.h: the textures that a model's materials name.
#pragma once

#include <map>
#include <string>

#include <raster/scene/obj_material.h>

namespace raster::obj {

/// Loads textures into a model, each file once. What cannot be used is a warning and `missing_texture()`: missing,
/// outside the folder, damaged, too large, 16 bits or floats where 8 bits are expected.
class Textures {
public:
    Textures(const Finder* finder, const ObjOptions& options, Model& model, Log& log)
        : finder_(finder), options_(options), model_(model), log_(log) {}

    /// Loads the textures of one material and sets their slots in it.
    void load(const MaterialEntry& entry, Material& material);

private:
    int load(const TextureUse& use, const MaterialEntry& entry);
    Result<Image8> read(const std::string& path);

    const Finder* finder_;
    const ObjOptions& options_;
    Model& model_;
    Log& log_;
    std::map<std::string, int> known_;  ///< by path, or by the name of what was not found
    std::size_t bytes_ = 0;
};

}  // namespace raster::obj
