// Lit pictures of models, the library's against GLSL: depth to the last bit, colours within 1/255.
#include <cstdio>
#include <filesystem>
#include <memory>

#include <gtest/gtest.h>

#include <raster/scene/obj.h>
#include <raster/scene/shapes.h>

#include "lit_pair.h"
#include "random.h"
#include "scene.h"

namespace {

using namespace raster;
using namespace raster::conformance;

constexpr int width = 512, height = 384;

struct LitScene {
    std::string name;
    Model model;
    RenderOptions options;
    Camera camera;
};

Light light(LightKind kind, glm::vec3 color) {
    Light l;
    l.kind = kind;
    l.ambient = glm::vec3(0.05f);
    l.diffuse = color;
    l.specular = color * 0.5f;
    l.direction = {-0.4f, -0.7f, -1.0f};
    l.position = {3, 4, 5};
    l.attenuation = {1, 0.02f, 0.005f};
    l.cutoff_degrees = 25;
    l.falloff_exponent = 6;
    return l;
}

/// A texture of random texels: nothing hides in it.
void add_texture(Model& model, int size) {
    raster::testing::Random random(7);
    raster::Texture texture{"random", Image8(size, size, 3)};
    for (auto& sample : texture.image.samples) sample = std::uint8_t(random.integer(0, 255));
    model.textures = {texture};
    Material material;
    material.diffuse_texture = 0;
    material.specular = glm::vec3(0.4f);
    model.materials = {material};
    for (Part& part : model.parts) part.material = 0;
}

LitScene scene(const std::string& name, Model model, RenderOptions options = {}) {
    const Camera camera = auto_frame(model, double(width) / height);
    return {name, std::move(model), std::move(options), camera};
}

RenderOptions with(ShadingFrequency frequency, AnyReflectance reflectance,
                   std::vector<Light> lights = default_lights()) {
    RenderOptions options;
    options.frequency = frequency;
    options.reflectance = reflectance;
    options.lights = std::move(lights);
    return options;
}

/// The shading frequencies, models, lights, textures, and what else changes colours.
std::vector<LitScene> made_scenes() {
    std::vector<LitScene> scenes;
    constexpr const char* frequencies[] = {"flat", "Gouraud", "Phong"};
    for (int f = 0; f < 3; ++f) {
        const auto frequency = ShadingFrequency(f);
        const std::string how = std::string(frequencies[f]) + " shading, ";
        scenes.push_back(scene("teapot, " + how + "Lambert", teapot(8), with(frequency, Lambert{})));
        scenes.push_back(scene("teapot, " + how + "Phong", teapot(8), with(frequency, Phong{})));
        scenes.push_back(scene("teapot, " + how + "Blinn-Phong", teapot(8), with(frequency, BlinnPhong{})));
        scenes.push_back(scene("torus, " + how + "a point light", torus(),
                               with(frequency, Phong{}, {light(LightKind::point, {0.9f, 0.7f, 0.5f})})));
        scenes.push_back(scene("sphere, " + how + "a spot", sphere(),
                               with(frequency, BlinnPhong{}, {light(LightKind::spot, {1, 1, 1})})));
        scenes.push_back(scene("bowl, " + how + "both sides", bowl(), with(frequency, BlinnPhong{})));
        LitScene nearest = scene("torus, " + how + "texture, nearest", torus(), with(frequency, BlinnPhong{}));
        add_texture(nearest.model, 16);
        nearest.options.filter = Filter::nearest;
        scenes.push_back(nearest);
        LitScene bilinear = scene("torus, " + how + "texture, bilinear", torus(), with(frequency, BlinnPhong{}));
        add_texture(bilinear.model, 16);
        scenes.push_back(bilinear);
        LitScene wireframe = scene("teapot, " + how + "wireframe", teapot(8), with(frequency, BlinnPhong{}));
        wireframe.options.style = Style::wireframe;
        wireframe.options.line_width = 2;
        scenes.push_back(wireframe);
        LitScene points = scene("torus, " + how + "points", torus(), with(frequency, BlinnPhong{}));
        add_texture(points.model, 16);
        points.options.style = Style::points;
        points.options.point_size = 5;
        points.options.cull = Cull::back;
        scenes.push_back(points);
    }
    std::vector<Light> several = {light(LightKind::directional, {0.4f, 0.1f, 0.1f}),
                                  light(LightKind::point, {0.1f, 0.5f, 0.1f}),
                                  light(LightKind::spot, {0.2f, 0.2f, 0.9f}), light(LightKind::ambient, {1, 1, 1})};
    several[0].direction = {1, -0.5f, -0.5f};
    several[1].space = LightSpace::eye;
    scenes.push_back(scene("teapot, four lights", teapot(10), with(ShadingFrequency::phong, Phong{}, several)));
    scenes.push_back(scene("teapot, exponent 5", teapot(8), with(ShadingFrequency::phong, Phong{5})));
    scenes.back().options.reflectance_from_material = false;
    scenes.push_back(scene("teapot, exponent 200", teapot(8), with(ShadingFrequency::phong, Phong{200})));
    scenes.back().options.reflectance_from_material = false;
    scenes.push_back(scene("teapot, quarter exponent", teapot(8),
                           with(ShadingFrequency::phong, BlinnPhong{100, BlinnPhong::Exponent::quarter_alpha})));
    scenes.back().options.reflectance_from_material = false;
    scenes.push_back(scene("cube, one side", cube(), with(ShadingFrequency::phong, Lambert{})));
    scenes.back().options.two_sided = false;
    LitScene box = scene("Cornell box, a point light inside", cornell_box());
    box.camera = cornell_camera();
    Light lamp = light(LightKind::point, {0.9f, 0.8f, 0.6f});
    lamp.position = {278, 500, 279};
    lamp.attenuation = {1, 0, 2e-6f};
    box.options.lights = {lamp};
    scenes.push_back(box);
    return scenes;
}

/// Files that others wrote, where their packages are installed.
std::vector<LitScene> file_scenes() {
    std::vector<LitScene> scenes;
    for (const auto& [name, path] :
         {std::pair{"bunny (glmark2-data)", "/usr/share/glmark2/models/bunny.obj"},
          {"spider (assimp-testmodels)", "/usr/share/assimp/models/OBJ/spider.obj"},
          {"Wuson (assimp-testmodels)", "/usr/share/assimp/models/OBJ/WusonOBJ.obj"},
          {"vertex colours (assimp-testmodels)", "/usr/share/assimp/models/OBJ/cube_with_vertexcolors.obj"},
          {"Cornell box (embree-tools)", "/usr/share/doc/embree3/models/cornell_box.obj"}}) {
        LoadReport report;
        if (!std::filesystem::exists(path)) continue;
        auto model = load_obj(path, {}, report);
        EXPECT_TRUE(model) << path;
        if (model) scenes.push_back(scene(name, std::move(*model)));
    }
    return scenes;
}

void compare_all(const std::vector<LitScene>& scenes) {
    const auto gl = tool::OpenGl::make();
    ASSERT_TRUE(gl) << gl.error().message;
    for (const LitScene& s : scenes) {
        SCOPED_TRACE(s.name);
        LitPair pair;
        ASSERT_NO_FATAL_FAILURE(draw_lit_pair(**gl, s.model, s.camera, s.options, width, height, pair));
        const auto& [ours, theirs] = pair;
        const Difference difference = compare(ours, theirs);
        EXPECT_EQ(difference.depth_pixels, 0u) << s.name;
        EXPECT_LE(difference.largest, 1) << s.name;
        const auto drawn =
            std::count_if(theirs.depth.begin(), theirs.depth.end(), [](auto d) { return d != 0xffffff; });
        EXPECT_GT(drawn, width * height / 20) << s.name;
        std::printf("| %s | %ld | %zu | %zu | %d/255 |\n", s.name.c_str(), long(drawn), difference.depth_pixels,
                    difference.color_pixels, difference.largest);
    }
}

TEST(Lit, ModelsMadeByFormula) { compare_all(made_scenes()); }
TEST(Lit, ModelsFromFiles) { compare_all(file_scenes()); }

}  // namespace
