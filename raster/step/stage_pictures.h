// stage_pictures.h: how a picture comes about, as pictures: for slides.
#pragma once

#include <string>
#include <vector>

#include <raster/image/image.h>
#include <raster/scene/display.h>
#include <raster/scene/render.h>

namespace raster {

struct StagePicture {
    std::string name;  ///< what it shows
    Image8 image;      ///< RGB
};

/// The vertices as points; the triangles as lines; what each covers, without a depth test; the same with it; the
/// depths; the normals; ambient, diffuse and specular light; the picture. A bar along the lower edge tells how far it
/// is.
std::vector<StagePicture> stage_pictures(const Model& model, const CameraMatrices& camera, int width, int height,
                                         const RenderOptions& options, const Display& display = {});

}  // namespace raster
