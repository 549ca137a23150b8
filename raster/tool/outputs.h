// outputs.h: the files a command will write, named and checked before the work that fills them begins.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <raster/image/write.h>
#include <raster/result.h>
#include <raster/scene/model.h>

namespace raster::tool {

/// A picture beside the picture: "depth.pfm" is the depth as floats, "depth" or "depth.png" the depth to look at.
struct PlaneChoice {
    std::string name;  ///< depth, normal, triangle, ...
    bool as_floats;    ///< .pfm, else .png
    std::string suffix() const { return "." + name + (as_floats ? ".pfm" : ".png"); }
};

bool is_standard_output(const std::string& path);

/// "models/teapot.obj" gives "teapot.png": in the current folder.
std::string default_picture_path(const std::string& model);

/// "a/teapot.png" with ".depth.png" gives "a/teapot.depth.png".
std::string beside(const std::string& path, const std::string& suffix);

/// Which files will be written.
struct OutputPlan {
    std::string picture;  ///< path; "-" for standard output
    OutputFormat format = OutputFormat::png;
    int frames = 0;  ///< of a turntable; 0 for a single picture
    std::vector<PlaneChoice> planes;
    std::string camera_json;  ///< path or empty

    /// The path of the picture, or of a frame from 0: teapot.007.png.
    std::string picture_path(int frame) const;
    std::string plane_path(int frame, const PlaneChoice& plane) const {
        return beside(picture_path(frame), plane.suffix());
    }

    /// All paths, in the order they are written.
    std::vector<std::string> paths() const;
};

/// Fills in the format and checks that each path can be written, that none is written twice and none is one of
/// the `inputs`. Errors: usage, or input_output from check_writable.
Status check(OutputPlan& plan, const std::vector<std::string>& inputs);

/// The files that a model's textures came from.
std::vector<std::string> texture_paths(const std::string& model_path, const Model& model);

/// An error if a path is one of the inputs.
Status check_no_input(const std::vector<std::string>& outputs, const std::vector<std::string>& inputs);

}  // namespace raster::tool
