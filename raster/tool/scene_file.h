// scene_file.h: a scene in a JSON file: objects with their places and materials, lights, camera, display.
//
// docs/scene.schema.json has the format. What is not geometry stands in for flags: a scene says what the command would
// be told, and what is on the command line wins.
#pragma once

#include <memory>
#include <string>

#include <CLI/App.hpp>

#include <raster/scene/obj.h>

#include "json_tree.h"

namespace raster::tool {

/// Whether a model's name is that of a scene: it ends in .json.
bool is_scene(const std::string& path);

/// A scene file that is JSON and says it is a scene. Errors of all functions are bad_input with FILE:LINE:COLUMN.
class SceneFile {
public:
    static Result<SceneFile> read(const std::string& path);
    /// The same of a text; `path` is where other files are looked for, and stands in messages.
    static Result<SceneFile> parse(const std::string& path, std::string text);

    /// Sets the flags of a command, parsed already, that the scene speaks of and the command line does not. Flags that
    /// the command does not have are passed over.
    Status set_flags(CLI::App& app) const;

    /// All objects as one model in world space. The report adds up those of the model files.
    Result<Model> load(const ObjOptions& options, LoadReport& report) const;

private:
    Status check_keys() const;

    std::shared_ptr<const JsonDocument> document_;
};

/// A shape by the name it has on the command line: shape:sphere:segments=64.
bool is_shape(const std::string& model);
Result<Model> load_shape(const std::string& model);

}  // namespace raster::tool
