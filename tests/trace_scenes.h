// trace_scenes.h: small pictures in which everything happens: for the tests of records, histories and traces.
#pragma once

#include <string>
#include <vector>

#include <raster/scene/observe.h>
#include <raster/scene/render.h>
#include <raster/scene/shapes.h>
#include <raster/scene/transform.h>

namespace raster::testing {

struct TraceScene {
    std::string name;
    Model model;
    CameraMatrices camera;
    RenderOptions options;
    int width = 24, height = 20;

    Target target(int planes = 0) const {
        return Target(width, height, ColorFormat::rgba8, DepthFormat::unorm24, planes);
    }
    Target picture() const {
        Target result = target();
        render(result, model, camera, options);
        return result;
    }
};

/// A sheet in the plane z facing +z, with a material.
inline void add_sheet(Model& model, glm::vec2 low, glm::vec2 high, float z, int material, float tilt = 0) {
    const auto base = std::uint32_t(model.vertices.size());
    for (const glm::vec2 p : {low, glm::vec2(high.x, low.y), high, glm::vec2(low.x, high.y)})
        model.vertices.push_back({{p.x, p.y, z + tilt * (p.x - low.x)}, {0, 0, 1}, p, glm::vec3(1)});
    const auto first = std::uint32_t(model.indices.size());
    for (const std::uint32_t i : {0u, 1u, 2u, 0u, 2u, 3u}) model.indices.push_back(base + i);
    model.parts.push_back({"sheet", material, first, 6});
}

inline CameraMatrices trace_camera(double aspect, Camera camera = {}) { return *camera_matrices(camera, aspect); }

/// One scene for each thing that can happen to a pixel.
inline std::vector<TraceScene> trace_scenes() {
    const double aspect = 24.0 / 20.0;
    std::vector<TraceScene> scenes;

    Model solids = torus(0.4f, 12, 8);
    TraceScene base{"z-buffer", solids, trace_camera(aspect, auto_frame(solids, aspect)), {}};
    base.options.frequency = ShadingFrequency::phong;
    scenes.push_back(base);
    scenes.push_back(base);
    scenes.back().name = "flat, back faces culled";
    scenes.back().model = bowl(12, 4);
    scenes.back().options.frequency = ShadingFrequency::flat;
    scenes.back().options.cull = Cull::back;
    scenes.push_back(base);
    scenes.back().name = "Gouraud, painter";
    scenes.back().options.frequency = ShadingFrequency::gouraud;
    scenes.back().options.visibility = Visibility::painter;
    scenes.push_back(base);
    scenes.back().name = "Direct3D's rule, front faces culled";
    scenes.back().options.fill_rule = FillRule::top_left;
    scenes.back().options.cull = Cull::front;

    TraceScene clipped = base;
    clipped.name = "clipped by near, far and sides";
    Camera near;
    near.position = {0.2f, 0.4f, 1.6f};
    near.near_plane = 0.9f;
    near.far_plane = 2.2f;
    clipped.camera = trace_camera(aspect, near);
    scenes.push_back(clipped);

    TraceScene blended = base;
    blended.name = "blended";
    blended.model.materials.resize(3);
    blended.model.materials[0].alpha = 0.5f;
    blended.model.materials[1].alpha = 0.25f;
    blended.model.materials[1].diffuse = {1, 0.2f, 0.1f};
    blended.model.parts[0].material = 2;
    add_sheet(blended.model, {-1.2f, -1}, {0.4f, 1}, 1.2f, 0);
    add_sheet(blended.model, {-0.4f, -0.8f}, {1.2f, 0.9f}, 0.9f, 1, 0.6f);
    add_sheet(blended.model, {-0.2f, -0.8f}, {1.0f, 0.5f}, -0.9f, 0);
    scenes.push_back(blended);

    // Corners on pixel centres, edges through them, equal depths, a degenerate triangle.
    TraceScene ties = base;
    ties.name = "ties";
    ties.width = ties.height = 16;
    ties.model = {};
    ties.camera.eye_from_world = glm::mat4(1.0f);
    ties.camera.clip_from_eye = ties.camera.clip_from_world = orthographic(-8, 8, -8, 8, -1, 1);
    add_sheet(ties.model, {-5.5f, -5.5f}, {2.5f, 2.5f}, 0, -1);
    add_sheet(ties.model, {-2.5f, -2.5f}, {5.5f, 5.5f}, 0, -1);
    add_sheet(ties.model, {-7.5f, 3.5f}, {4.5f, 3.5f}, 0, -1);
    add_sheet(ties.model, {4, -7.25f}, {4.125f, 7}, 0.5f, -1);
    scenes.push_back(ties);
    return scenes;
}

}  // namespace raster::testing
