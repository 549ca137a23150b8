// render.h: a picture of a model: options, lights and materials in, draw calls out.
#pragma once

#include <vector>

#include <raster/pipeline.h>
#include <raster/scene/camera.h>
#include <raster/shading/light.h>
#include <raster/shading/models.h>
#include <raster/shading/texture.h>
#include <raster/visibility/painter.h>

namespace raster {

/// How often the light is computed.
enum class ShadingFrequency {
    flat,     ///< once a triangle
    gouraud,  ///< once a vertex, the colours interpolated
    phong,    ///< once a pixel, the normals interpolated
};

/// How hidden surfaces are removed.
enum class Visibility { zbuffer, painter };

/// What is drawn of a triangle.
enum class Style {
    surface,
    wireframe,  ///< its edges, one line for those that share it
    points,     ///< its corners, one point for those that share it
};

/// What is taken as a material's ambient colour.
enum class AmbientColor {
    diffuse,   ///< the diffuse one (Kd): many programs write an arbitrary Ka
    material,  ///< the one in the file (Ka)
};

/// One white light over the viewer's left shoulder that moves with the viewer, with some ambient light.
std::vector<Light> default_lights();

/// What parts without a material are made of: light grey with a soft highlight.
Material default_material();

/// How a model becomes a picture. The defaults are meant to show any model well.
struct RenderOptions {
    ShadingFrequency frequency = ShadingFrequency::phong;
    AnyReflectance reflectance = BlinnPhong{};  ///< of materials that name none
    bool reflectance_from_material = true;  ///< materials set the model's parameters (Ns its exponent); else as given
    std::vector<Light> lights = default_lights();
    AmbientColor ambient_color = AmbientColor::diffuse;
    Material default_material = raster::default_material();
    bool two_sided = true;                  ///< light back faces from their own side
    bool textures = true;
    Filter filter = Filter::bilinear;
    Wrap wrap = Wrap::repeat;               ///< of textures whose material does not ask for clamping
    bool decode_srgb = false;               ///< colour textures are sRGB and become linear; else byte / 255
    bool vertex_colors = true;
    bool blend = true;                      ///< alpha below 1 is see-through, drawn back to front; else opaque
    Style style = Style::surface;           ///< culled triangles have no edges nor corners either
    int line_width = 1;                     ///< of a wireframe, in pixels, 1 and more
    float point_size = 3;                   ///< in pixels, rounded to whole ones, 1 and more
    Visibility visibility = Visibility::zbuffer;
    PainterKey painter_key = PainterKey::centroid;
    Cull cull = Cull::none;
    FillRule fill_rule = FillRule::bottom_left;
    glm::vec4 background{0.2f, 0.2f, 0.2f, 1.0f};
    glm::mat4 world_from_object{1.0f};
};

/// Clears the target to the background and draws the model, part by part with its material. A target with extra
/// channels gets the planes of shaded_plane (shading/uniforms.h) too, as many as it has room for; the colours stay the
/// same but for Gouraud's rounding. What blends leaves its own values in the extra planes.
DrawCounts render(Target& target, const Model& model, const CameraMatrices& camera, const RenderOptions& options = {});

/// How often each pixel is written by the same draws, in the red channel of `counts`, which has float colours.
DrawCounts render_overdraw(Target& counts, const Model& model, const CameraMatrices& camera,
                           const RenderOptions& options = {});

}  // namespace raster
