// model_scenes.cpp: every way to light, shade, texture and hide the models in this tree.
#include <array>

#include <raster/scene/obj.h>
#include <raster/scene/render.h>
#include <raster/scene/shapes.h>

#include "files.h"
#include "scenes.h"

namespace raster::everywhere {

namespace {

/// A picture of a model as `change` wants it. With extra channels the terms of the light come along.
void draw_model(Hash& hash, const Model& model, const RenderOptions& options, int extra_channels = 0,
                ColorFormat format = ColorFormat::rgba8) {
    Target target(200, 150, format, DepthFormat::unorm24, extra_channels);
    const auto camera = camera_matrices(auto_frame(model, 4.0 / 3.0), 4.0 / 3.0);
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 4; ++row) hash.add(camera->clip_from_world[column][row]);
    hash.add(render(target, model, *camera, options));
    hash.add(target);
}

template <class Make, class Change>
Scene scene(const std::string& name, const Make& make, const Change& change, int extra_channels = 0,
            ColorFormat format = ColorFormat::rgba8) {
    return {name, [=](Hash& hash) {
                RenderOptions options;
                change(options);
                draw_model(hash, make(), options, extra_channels, format);
            }};
}

Light white(LightKind kind) {
    Light light;
    light.kind = kind;
    light.ambient = glm::vec3(0.1f);
    light.position = {2, 3, 4};
    light.direction = {-0.4f, -0.7f, -1};
    return light;
}

constexpr std::array frequencies = {ShadingFrequency::flat, ShadingFrequency::gouraud, ShadingFrequency::phong};
constexpr std::array frequency_names = {"flat", "gouraud", "phong"};

/// A ring that one can see through.
Model glass() {
    Model model = torus(0.4f, 24, 12);
    model.materials = {default_material()};
    model.materials[0].alpha = 0.5f;
    model.parts[0].material = 0;
    return model;
}

/// A torus whose vertices have the colours of their normals.
Model colorful() {
    Model model = torus(0.4f, 24, 12);
    for (auto& v : model.vertices) v.color = v.normal * 0.5f + 0.5f;
    return model;
}

}  // namespace

std::vector<Scene> model_scenes() {
    std::vector<Scene> all;
    const auto pot = [] { return teapot(4); };
    const auto box = [] { return models::checker_cube(); };
    for (std::size_t f = 0; f < frequencies.size(); ++f) {
        const auto with = [&](const std::string& name, const auto& make, const auto& change, int extra_channels = 0) {
            const ShadingFrequency frequency = frequencies[f];
            all.push_back(scene(
                std::string(frequency_names[f]) + "_" + name, make,
                [=](RenderOptions& options) {
                    options.frequency = frequency;
                    change(options);
                },
                extra_channels));
        };
        for (const std::string_view model : reflectance_names())
            with(std::string(model), pot,
                 [=](RenderOptions& options) { options.reflectance = *find_reflectance(model); });
        with("layered", pot, [](RenderOptions& options) {
            options.default_material.sheen = 0.7f;
            options.default_material.clearcoat = 0.8f;
            options.default_material.clearcoat_roughness = 0.5f;
        });
        with("point_light", pot, [](RenderOptions& options) {
            options.lights = {white(LightKind::point)};
            options.lights[0].attenuation = {0.5f, 0.1f, 0.02f};
        });
        with("spot_light", pot, [](RenderOptions& options) {
            options.lights = {white(LightKind::spot), white(LightKind::ambient)};
            options.lights[0].falloff_exponent = 5;
        });
        with("four_lights", pot, [](RenderOptions& options) {
            for (const LightKind kind : {LightKind::directional, LightKind::point, LightKind::spot})
                options.lights.push_back(white(kind));
        });
        with("bowl_two_sided", [] { return bowl(24, 6); }, [](RenderOptions&) {});
        with("bowl_one_sided", [] { return bowl(24, 6); }, [](RenderOptions& options) { options.two_sided = false; });
        with("texture_nearest", box, [](RenderOptions& options) { options.filter = Filter::nearest; });
        with("texture_srgb", box, [](RenderOptions& options) { options.decode_srgb = true; });
        with("vertex_colors", colorful, [](RenderOptions&) {});
        with("planes", pot, [](RenderOptions&) {}, 16);
        with("see_through", glass, [](RenderOptions&) {});
        with("wireframe", pot, [](RenderOptions& options) {
            options.style = Style::wireframe;
            options.line_width = 2;
            options.cull = Cull::back;
        });
        with("points", colorful, [](RenderOptions& options) { options.style = Style::points; });
    }
    for (const PainterKey key : {PainterKey::centroid, PainterKey::farthest_vertex})
        all.push_back(scene(key == PainterKey::centroid ? "painter_centroid" : "painter_farthest", pot,
                            [=](RenderOptions& options) {
                                options.visibility = Visibility::painter;
                                options.painter_key = key;
                            }));
    all.push_back(scene("cornell_box", cornell_box, [](RenderOptions& options) { options.cull = Cull::back; }));
    all.push_back(scene("float_colors", pot, [](RenderOptions&) {}, 0, ColorFormat::rgba_float));
    all.push_back({"overdraw", [](Hash& hash) {
                       const Model model = cornell_box();
                       Target target(120, 120, ColorFormat::rgba_float);
                       const auto camera = camera_matrices(cornell_camera(), 1);
                       hash.add(render_overdraw(target, model, *camera));
                       hash.add(target);
                   }});
    return all;
}

std::vector<Scene> file_scenes(const std::string& models) {
    std::vector<Scene> all;
    for (const std::string name : {"teapot", "torus", "sphere", "bowl", "plane", "cube", "tetrahedron", "checker_cube",
                                   "cornell_box", "cyclic_trio"})
        all.push_back({"file_" + name, [=](Hash& hash) {
                           LoadReport report;
                           const auto model = load_obj(models + "/" + name + ".obj", {}, report);
                           if (model && report.warnings.empty()) draw_model(hash, *model, {});
                       }});
    return all;
}

}  // namespace raster::everywhere
