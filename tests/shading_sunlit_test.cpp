// The shader for one directional light: the bits of the general pixel shader, for whoever looks from wherever.
#include <gtest/gtest.h>

#include <raster/scene/observe.h>
#include <raster/scene/shapes.h>
#include <raster/scene/transform.h>
#include <raster/shading/blinn_phong.h>
#include <raster/shading/cook_torrance.h>
#include <raster/shading/lambert.h>
#include <raster/shading/oren_nayar.h>
#include <raster/shading/phong.h>
#include <raster/shading/sunlit_shader.h>
#include <raster/shading/ward.h>

#include "shading_scene.h"

namespace {

using namespace raster;
using namespace raster::testing;

Light sun() {
    Light light;
    light.direction = {-0.3f, -0.5f, -1};
    light.ambient = {0.1f, 0.2f, 0.3f};
    light.diffuse = {1, 0.5f, 0.25f};
    light.specular = {0.25f, 0.5f, 1};
    return light;
}

template <class Model>
void expect_the_bits_of_the_pixel_shader(const Model& model) {
    Random random(41);
    Scene scene({sun()});
    scene.u.material.alpha = 0.75f;
    int lit = 0;
    for (int i = 0; i < 3000; ++i) {
        scene.u.viewer_eye = i % 3 == 0 ? glm::vec4(0, 0, 1, 0) : glm::vec4(i % 3 == 1 ? 0.25f : 0.0f, 0, 0, 1);
        scene.u.two_sided = i % 2 != 0;
        scene.u.material.ambient_is_diffuse = i % 5 == 0;
        const SunlitShader<Model> sunlit(scene.u, model);
        const PixelShader<Model, Detail::plain> general{scene.u, model};
        const glm::vec3 normal = i % 50 == 0 ? glm::vec3(0, 0, 0) : unit_vector(random) * 1.5f;
        const glm::vec3 position = i % 70 == 0 ? glm::vec3(0, 0, 0) : glm::vec3(0, 0, -2) + unit_vector(random);
        FragmentInput<float> at{};
        at.front_facing = i % 7 < 4;
        const glm::vec4 expected = general.template fragment<float>({normal, position}, at);
        const glm::vec4 color = sunlit.template fragment<float>({normal, position}, at);
        for (int c = 0; c < 4; ++c) EXPECT_EQ(bits_of(color[c]), bits_of(expected[c])) << Model::name << " " << i;
        lit += expected.x > 0.5f;
    }
    EXPECT_GT(lit, 300);
}

TEST(SunlitShader, HasTheBitsOfThePixelShader) {
    CookTorrance metal;
    metal.fresnel = {{0.2f, 0.9f, 1.1f}, {3.9f, 2.4f, 2.2f}};
    expect_the_bits_of_the_pixel_shader(Lambert{});
    expect_the_bits_of_the_pixel_shader(Phong{20});
    expect_the_bits_of_the_pixel_shader(BlinnPhong{20});
    expect_the_bits_of_the_pixel_shader(CookTorrance{});
    expect_the_bits_of_the_pixel_shader(metal);
    expect_the_bits_of_the_pixel_shader(OrenNayar{});
    expect_the_bits_of_the_pixel_shader(Ward{});
}

struct Nobody {
    void on(const DrawEvent&) {}
};

TEST(SunlitShader, MakesThePictureOfTheChosenModelForEitherCamera) {
    const Model model = torus(0.4f, 24, 16);
    CameraMatrices near = *camera_matrices({{1, 2, 2.5f}, {0, 0, 0}, {0, 1, 0}, 40, 0.1f, 20}, 1), far = near;
    far.clip_from_eye = orthographic(-1.6, 1.6, -1.6, 1.6, 0.1, 20);
    far.clip_from_world = product(far.clip_from_eye, far.eye_from_world);
    for (const CameraMatrices& camera : {near, far}) {
        std::vector<std::vector<std::uint32_t>> seen;
        for (const char* name : {"lambert", "phong", "blinn-phong", "cook-torrance", "oren-nayar"}) {
            SCOPED_TRACE(name);
            RenderOptions options;
            options.reflectance = *find_reflectance(name);
            options.lights = {sun()};
            int sunlit = 0;
            DrawPlan(model, options, false).for_each(camera, [&](const PlannedDraw& draw) {
                with_shader(draw, [&]<class S>(const S&, const auto&...) {
                    sunlit += requires(const S& shader) { shader.sees_from_origin; };
                });
            });
            EXPECT_EQ(sunlit, 1) << "draws by this shader";
            Target observed(90, 90), rendered(90, 90);
            Nobody nobody;
            render_observed(observed, model, camera, options, nobody);
            render(rendered, model, camera, options);
            EXPECT_EQ(rendered.color8(), observed.color8());
            EXPECT_EQ(rendered.depth(), observed.depth());
            for (const auto& other : seen) EXPECT_NE(rendered.color8(), other);
            seen.push_back(rendered.color8());
        }
    }
}

TEST(SunlitShader, IsForOneDirectionalLightOnly) {
    Light bulb;
    bulb.kind = LightKind::point;
    EXPECT_TRUE(is_sunlit(Scene({sun()}).u));
    EXPECT_FALSE(is_sunlit(Scene(std::vector<Light>{}).u));
    EXPECT_FALSE(is_sunlit(Scene({bulb}).u));
    EXPECT_FALSE(is_sunlit(Scene({sun(), sun()}).u));
}

}  // namespace
