// view.h: the camera as flags, as a JSON file, and as the matrices that are drawn with.
#pragma once

#include <optional>
#include <string>

#include <raster/scene/camera.h>

#include "flags.h"

namespace raster::tool {

/// A camera and the picture it is for.
struct View {
    Size size;
    std::optional<Camera> camera;  ///< what the matrices were made from, where that is known
    CameraMatrices matrices;
};

struct ViewFlags {
    std::optional<Size> size;
    std::optional<glm::vec3> position, focal_point, up;
    std::optional<float> view_angle, near_plane, far_plane, azimuth, elevation;
    std::string json;  ///< path of a camera file

    /// The first flag given that places the camera, for messages; empty when there is none.
    std::string first_camera_flag() const;
};
void add_view_flags(CLI::App& app, ViewFlags& flags);

/// The camera that the flags ask for, before a model is known.
class ViewPlan {
public:
    /// Reads the camera file, if there is one, and checks what can be checked without a model. Errors: usage for
    /// flags, bad_input and input_output for the file.
    static Result<ViewPlan> make(const ViewFlags& flags);

    const Size& size() const { return size_; }
    bool is_from_file() const { return file_view_.has_value(); }

    /// The view of a model. What no flag says is taken so that the model fills the picture.
    Result<View> view_of(const Model& model) const;

    /// The view number `step` of `steps` around the model. All have one distance.
    Result<View> turned_view_of(const Model& model, int step, int steps) const;

private:
    double aspect() const { return double(size_.width) / size_.height; }
    Result<View> finish(const Camera& camera) const;
    Camera placed(const Model& model, bool spinning) const;
    Camera with_planes(Camera camera, const Box& model) const;

    ViewFlags flags_;
    Size size_;
    std::optional<View> file_view_;
};

/// The camera file (docs/command.md has the format): view, projection and their product as decimal and
/// hexadecimal floats, rows from the top.
std::string camera_json(const View& view);

/// Reads a camera file, or the output of `info --json`, which holds one. Hexadecimal floats win over decimal ones,
/// matrices over the parameters they were made from. Errors name FILE:LINE where they can.
Result<View> read_camera_json(const std::string& path);

}  // namespace raster::tool
