// render.cpp: drawing what a plan asks for.
#include <raster/scene/render.h>

#include <raster/scene/draw_plan.h>
#include <raster/scene/position_shader.h>

namespace raster {
namespace {

/// Adds 1 to every pixel that it is drawn to.
struct One {
    template <class F>
    vec<4, F> operator()(const FragmentInput<F>&) const {
        return {F(1), F(0), F(0), F(0)};
    }
};

}  // namespace

std::vector<Light> default_lights() {
    Light light;
    light.kind = LightKind::directional;
    light.space = LightSpace::eye;
    light.direction = {0.25f, -0.35f, -1.0f};
    light.ambient = glm::vec3(0.15f);
    light.diffuse = glm::vec3(0.85f);
    light.specular = glm::vec3(0.5f);
    return {light};
}

Material default_material() {
    Material material;
    material.name = "default";
    material.diffuse = glm::vec3(0.8f);
    material.specular = glm::vec3(0.3f);
    material.shininess = 32.0f;
    return material;
}

DrawCounts render(Target& target, const Model& model, const CameraMatrices& camera, const RenderOptions& options) {
    target.clear(options.background);
    DrawCounts counts;
    const DrawPlan plan(model, options, target.extra_channels() > 0);
    plan.for_each(camera, [&](const PlannedDraw& planned) {
        switch (planned.frequency) {
            case ShadingFrequency::flat: counts += draw_flat(target, planned); break;
            case ShadingFrequency::gouraud: counts += draw_gouraud(target, planned); break;
            case ShadingFrequency::phong: counts += draw_pixel_shaded(target, planned); break;
        }
    });
    return counts;
}

DrawCounts render_overdraw(Target& target, const Model& model, const CameraMatrices& camera,
                           const RenderOptions& options) {
    target.clear(glm::vec4(0.0f));
    DrawCounts counts;
    RenderOptions cheap = options;
    cheap.frequency = ShadingFrequency::phong;  // nothing is shaded here, so nothing need be lit beforehand
    const DrawPlan plan(model, cheap, false);
    plan.for_each(camera, [&](const PlannedDraw& planned) {
        State state = planned.state;
        state.blend = Blend::additive;
        counts += draw(target, PositionShader<One>{planned.uniforms.clip_from_object, {}}, planned.mesh, state);
    });
    return counts;
}

}  // namespace raster
