// draw_plan.cpp: from materials, textures, lights and camera to the uniforms and states of draw calls.
#include <raster/scene/draw_plan.h>

#include <raster/scene/material_model.h>

#include <algorithm>
#include <numeric>

#include <raster/scene/outline.h>
#include <raster/scene/transform.h>
#include <raster/shading/albedo.h>
#include <raster/shading/materials.h>

namespace raster {
namespace {

bool any_vertex_color(const Model& model) {
    return std::any_of(model.vertices.begin(), model.vertices.end(),
                       [](const SurfaceVertex<float>& v) { return v.color != glm::vec3(1.0f); });
}

/// Twice the area of the triangle in ndc, times the product of its corners' w: positive where its front is seen, also
/// when corners lie behind the eye (Olano and Greer 1997, Triangle Scan Conversion using 2D Homogeneous Coordinates).
double facing(const std::array<glm::vec4, 3>& clip) {
    const auto xyw = [&](std::size_t c) { return glm::dvec3(clip[c].x, clip[c].y, clip[c].w); };
    return glm::dot(xyw(0), glm::cross(xyw(1), xyw(2)));
}

}  // namespace

DrawPlan::DrawPlan(const Model& model, const RenderOptions& options, bool terms)
    : model_(model), options_(options), terms_(terms) {
    has_vertex_colors_ = options.vertex_colors && any_vertex_color(model);
    textures_.resize(model.textures.size());
    if (options.textures)
        for (std::size_t i = 0; i < textures_.size(); ++i) textures_[i] = pack_texture(model.textures[i].image);
    for (const Material& material : model.materials) materials_.push_back(prepare(material));
    materials_.push_back(prepare(options.default_material));

    const auto add = [&](std::size_t material, std::size_t first, std::size_t count) {
        std::vector<Run>& runs = materials_[material].transparent ? transparent_ : opaque_;
        if (!runs.empty() && runs.back().material == material &&
            runs.back().first_triangle + runs.back().triangle_count == first) {
            runs.back().triangle_count += count;
        } else if (count > 0) {
            runs.push_back({material, first, count});
        }
    };
    const std::size_t default_material = model.materials.size();
    if (model.parts.empty()) add(default_material, 0, model.triangle_count());
    for (const Part& part : model.parts) {
        const bool known = part.material >= 0 && std::size_t(part.material) < model.materials.size();
        const std::size_t end =
            std::min<std::size_t>(part.first_index + std::size_t(part.index_count), model.indices.size());
        const std::size_t first = std::min<std::size_t>(part.first_index, end);
        add(known ? std::size_t(part.material) : default_material, first / 3, (end - first) / 3);
    }
}

TextureView DrawPlan::view(int texture, const Material& material, bool color) const {
    if (texture < 0 || std::size_t(texture) >= textures_.size()) return {};
    return TextureView(textures_[std::size_t(texture)], material.clamp_texture ? Wrap::clamp : options_.wrap,
                       options_.filter, color && options_.decode_srgb ? srgb_decode_table() : nullptr);
}

DrawPlan::PreparedMaterial DrawPlan::prepare(const Material& material) const {
    const Material m = physically_based(material);
    const bool is_metal = m.extinction != glm::vec3(0.0f);
    SurfaceMaterial s;
    const bool own_ambient = is_metal || m.ambient_counts;
    s.ambient_is_diffuse = options_.ambient_color == AmbientColor::diffuse && !own_ambient;
    s.ambient = s.ambient_is_diffuse             ? glm::vec3(1.0f)
                : is_metal && !m.ambient_counts ? m.diffuse + metal_ambient(m)
                                                : m.ambient;
    s.diffuse = m.diffuse;
    s.emission = m.emission;
    if (options_.blend) s.alpha = m.alpha;
    s.ambient_texture = view(m.ambient_texture, m, true);
    s.diffuse_texture = view(m.diffuse_texture, m, true);
    s.specular_texture = view(m.specular_texture, m, true);
    s.emission_texture = view(m.emission_texture, m, true);
    if (options_.blend) s.alpha_texture = view(m.alpha_texture, m, false);
    if (s.alpha_texture) {
        const int channels = model_.textures[std::size_t(m.alpha_texture)].image.channels;
        s.alpha_texture_has_alpha = channels == 2 || channels == 4;
    }
    s.vertex_colors = has_vertex_colors_;
    if (m.illumination == 0) {  // "color on and ambient off": the colour is Kd whatever the light
        s.emission = s.diffuse;
        s.emission_texture = s.diffuse_texture;
        s.diffuse = s.ambient = glm::vec3(0.0f);
    }

    const std::optional<AnyReflectance> own = find_reflectance(m.reflectance);
    AnyReflectance reflectance = own.value_or(options_.reflectance);
    if (own || options_.reflectance_from_material) reflectance = RuntimeModel{reflectance}.with_material(m).model;
    if (!own_ambient) s.ambient *= own_color(reflectance);
    const MaterialModel finished = finish(m, reflectance);
    s.specular = finished.specular;
    const SinCos turn = sin_cos_degrees(360.0 * double(m.anisotropy_rotation));
    return {s, finished.reflectance, s.alpha < 1.0f || s.alpha_texture, m.grain, {turn.cos, turn.sin}};
}

State DrawPlan::state_for(const Run& run) const {
    const bool transparent = materials_[run.material].transparent;
    const bool painted = options_.visibility == Visibility::painter;
    State state;
    state.cull = options_.cull;
    state.fill_rule = options_.fill_rule;
    state.depth_compare = painted ? Compare::always : Compare::less;
    state.depth_write = painted || !transparent;
    state.blend = transparent ? Blend::source_over : Blend::off;
    return state;
}

DrawPlan::SortedTriangles DrawPlan::sort(std::span<const Run> runs, const glm::mat4& eye_from_object) const {
    std::vector<std::uint32_t> indices;
    std::vector<std::pair<std::size_t, std::size_t>> origin;  // material and number in the model
    for (const Run& run : runs) {
        const auto first = model_.indices.begin() + std::ptrdiff_t(3 * run.first_triangle);
        indices.insert(indices.end(), first, first + std::ptrdiff_t(3 * run.triangle_count));
        for (std::size_t i = 0; i < run.triangle_count; ++i) origin.emplace_back(run.material, run.first_triangle + i);
    }
    SortedTriangles sorted;
    for (const std::uint32_t t : painter_order(model_.vertices, indices, eye_from_object, options_.painter_key)) {
        const auto [material, number] = origin[t];
        if (sorted.runs.empty() || sorted.runs.back().material != material)
            sorted.runs.push_back({material, sorted.numbers.size(), 0});
        ++sorted.runs.back().triangle_count;
        sorted.numbers.push_back(std::int32_t(number));
        for (std::size_t c = 0; c < 3; ++c) sorted.indices.push_back(indices[3 * t + c]);
    }
    return sorted;
}

void DrawPlan::emit(PlannedDraw& draw, const Run& run, const std::function<void(const PlannedDraw&)>& visit) const {
    const PreparedMaterial& material = materials_[run.material];
    draw.uniforms.material = material.surface;
    draw.uniforms.grain_eye = glm::mat3(draw.uniforms.eye_from_object) * material.grain_object;
    draw.uniforms.grain_turn = material.grain_turn;
    draw.reflectance = material.reflectance;
    draw.state = state_for(run);
    // A vertex does not know its side, so Gouraud's plain shader has one only.
    const bool both_sides =
        draw.frequency == ShadingFrequency::gouraud && options_.two_sided && draw.state.cull != Cull::back;
    draw.level = terms_ ? Detail::terms : material.surface.is_plain() && !both_sides ? Detail::plain : Detail::mapped;
    std::vector<FaceLight> faces;
    if (draw.frequency == ShadingFrequency::flat) faces = light_faces(draw.uniforms, {draw.reflectance}, draw.mesh);
    draw.faces = faces;
    options_.style == Style::surface ? visit(draw) : emit_outline(draw, visit);
}

void DrawPlan::emit_outline(const PlannedDraw& surface, const std::function<void(const PlannedDraw&)>& visit) const {
    const std::span<const SurfaceVertex<float>> vertices = surface.mesh.vertices;
    std::vector<std::uint32_t> counted(surface.mesh.indices.empty() ? vertices.size() : 0);
    std::iota(counted.begin(), counted.end(), 0u);
    const auto indices = counted.empty() ? surface.mesh.indices : std::span<const std::uint32_t>(counted);
    const auto is_seen = [&](std::uint32_t t) {
        if (options_.cull == Cull::none) return true;
        std::array<glm::vec4, 3> clip{};
        for (std::size_t c = 0; c < 3; ++c)
            if (const std::uint32_t i = indices[3 * t + c]; i < vertices.size())
                clip[c] = transform_point(surface.uniforms.clip_from_object, vertices[i].position);
        const double side = facing(clip);
        return options_.cull == Cull::back ? side > 0 : options_.cull == Cull::front && side < 0;
    };
    const bool lines = options_.style == Style::wireframe;
    const Outline outline = lines ? edges_of(indices, is_seen) : corners_of(indices, is_seen);

    // What a triangle has by its number, its lines and points have by theirs.
    const ShadingUniforms& u = surface.uniforms;
    std::vector<std::int32_t> numbers;
    std::vector<std::uint32_t> triangles;
    std::vector<FaceLight> faces;
    for (const std::uint32_t t : outline.triangles) {
        numbers.push_back(u.triangle_numbers.empty() ? u.first_triangle + std::int32_t(t) : u.triangle_numbers[t]);
        triangles.insert(triangles.end(), &indices[3 * t], &indices[3 * t] + 3);
        if (!surface.faces.empty()) faces.push_back(surface.faces[t]);
    }
    if (numbers.empty()) return;  // no index would mean all vertices
    PlannedDraw draw = surface;
    draw.mesh.indices = outline.indices;
    draw.triangles = triangles;
    draw.uniforms.triangle_numbers = numbers;
    draw.faces = faces;
    draw.state.topology = lines ? Topology::lines : Topology::points;
    draw.state.line_width = options_.line_width;
    draw.state.point_size = options_.point_size;
    visit(draw);
}

void DrawPlan::for_each(const CameraMatrices& camera, const std::function<void(const PlannedDraw&)>& visit) const {
    const Lighting lighting = make_lighting(options_.lights, camera.eye_from_world);
    PlannedDraw draw{};
    draw.frequency = options_.frequency;
    ShadingUniforms& u = draw.uniforms;
    u.clip_from_object = product(camera.clip_from_world, options_.world_from_object);
    u.eye_from_object = product(camera.eye_from_world, options_.world_from_object);
    u.eye_from_object_normal = normal_matrix(u.eye_from_object);
    u.world_from_eye = glm::transpose(glm::mat3(camera.eye_from_world));
    u.ambient = lighting.ambient;
    u.lights = lighting.lights;
    u.two_sided = options_.two_sided;
    if (camera.clip_from_eye[2][3] == 0.0f) u.viewer_eye = {0, 0, 1, 0};  // w does not depend on z: no perspective

    const bool painted = options_.visibility == Visibility::painter;
    const std::span<const std::uint32_t> indices(model_.indices);
    if (!painted) {
        for (const Run& run : opaque_) {
            draw.mesh = {model_.vertices, indices.subspan(3 * run.first_triangle, 3 * run.triangle_count)};
            u.first_triangle = std::int32_t(run.first_triangle);
            emit(draw, run, visit);
        }
    }

    std::vector<Run> unsorted = transparent_;
    if (painted) {
        unsorted.insert(unsorted.end(), opaque_.begin(), opaque_.end());
        std::sort(unsorted.begin(), unsorted.end(),
                  [](const Run& a, const Run& b) { return a.first_triangle < b.first_triangle; });
    }
    if (unsorted.empty()) return;
    const SortedTriangles sorted = sort(unsorted, u.eye_from_object);
    std::vector<SurfaceVertex<float>> corners;
    for (const Run& run : sorted.runs) {
        const auto triangles =
            std::span(sorted.indices).subspan(3 * run.first_triangle, 3 * run.triangle_count);
        u.triangle_numbers = std::span(sorted.numbers).subspan(run.first_triangle, run.triangle_count);
        if (sorted.runs.size() == 1) {
            draw.mesh = {model_.vertices, triangles};
        } else {
            // Many short runs over one large vertex array would shade it again and again; each gets its own corners.
            corners.clear();
            for (const std::uint32_t i : triangles) corners.push_back(model_.vertices[i]);
            draw.mesh = {corners, {}};
        }
        emit(draw, run, visit);
    }
}

}  // namespace raster
