// picture.h: the flags that say what a picture looks like, whoever draws it, and how a model is loaded.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <raster/scene/display.h>
#include <raster/scene/obj.h>
#include <raster/scene/render.h>

#include "flags.h"
#include "progress.h"
#include "scene_file.h"
#include "specs.h"

namespace raster::tool {

/// How a model file is read.
struct LoadFlags {
    std::string model;  ///< path of an OBJ or a scene file, or shape:NAME
    ObjOptions options;
    std::optional<Result<SceneFile>> scene;  ///< where the model is a scene: read and its flags set, or why not
};
void add_load_flags(CLI::App& app, LoadFlags& flags);
/// All of these but the model itself.
void add_reading_flags(CLI::App& app, LoadFlags& flags);

/// A model and what was said while it was read.
struct Loaded {
    Model model;
    LoadReport report;
};

/// Loads the model. Warnings go to standard error unless `quiet`, at most a screenful; errors come back.
Result<Loaded> load(const LoadFlags& flags, Progress& progress, bool quiet);

/// How light becomes bytes.
enum class Encoding {
    automatic,  ///< sRGB where a material's reflectance model is physical, else plain
    srgb,
    plain,
};

/// How a model is drawn.
struct PictureFlags {
    RenderOptions options;
    std::vector<std::vector<Light>> lights;
    std::vector<MaterialChange> materials;
    int samples = 1;
    Encoding encoding = Encoding::automatic;
    float exposure = 0.0f;  ///< stops

    /// The options for this model, whose materials are changed as the flags ask.
    RenderOptions options_for(Model& model) const;

    /// How the picture of a model is shown, after options_for has changed its materials.
    Display display_for(const Model& model, const RenderOptions& changed) const;
};
void add_picture_flags(CLI::App& app, PictureFlags& flags);
/// For commands that do not look into triangles.
void add_style_flags(CLI::App& app, RenderOptions& options);

/// How many threads draw.
struct ThreadFlags {
    std::optional<int> threads;
};
void add_thread_flags(CLI::App& app, ThreadFlags& flags);

/// Calls `work` where all that the library does in parallel uses that many threads.
void with_threads(const ThreadFlags& flags, const std::function<void()>& work);

}  // namespace raster::tool
