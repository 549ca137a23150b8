// shading.cpp: a fragment's light taken apart, by the functions that the shaders are made of.
#include <raster/step/recorder.h>

namespace raster::step {
namespace {

using Vec3 = glm::vec3;

/// Where and with which normal the shader lit this fragment, and the varyings that its material reads.
struct LitPoint {
    const char* where;
    Vec3 position_eye, n;
    glm::vec2 uv;
    Vec3 color;
};

LitPoint point_of(const PlannedDraw& draw, std::int64_t triangle, bool front_facing, bool renormalised,
                  std::span<const float> v) {
    const ShadingUniforms& u = draw.uniforms;
    if (draw.frequency == ShadingFrequency::phong) {
        const Vec3 given(v[0], v[1], v[2]);
        const Vec3 outward = renormalised ? normalize_or_zero(given) : given;
        LitPoint at{"pixel", {v[3], v[4], v[5]}, u.two_sided ? negate_where<float>(!front_facing, outward) : outward,
                    glm::vec2(0.0f), Vec3(1.0f)};
        if (v.size() > 6) at.uv = {v[6], v[7]}, at.color = {v[8], v[9], v[10]};
        return at;
    }
    const FaceLight& face = draw.faces[std::size_t(triangle)];
    std::array<Vec3, 3> corner;
    for (std::size_t c = 0; c < 3; ++c) {
        const std::size_t place = 3 * std::size_t(triangle) + c;
        const std::size_t index = draw.mesh.indices.empty() ? place : draw.mesh.indices[place];
        corner[c] = eye_position(u, draw.mesh.vertices[index].position);
    }
    return {"centroid", (corner[0] + corner[1] + corner[2]) * (1.0f / 3.0f), face.normal_eye, {v[0], v[1]}, face.color};
}

LightRecord light_at(const ShadingUniforms& u, const RuntimeModel& model, int number, const Frame<float>& frame,
                     const Vec3& position_eye) {
    const EyeLight& light = u.lights[std::size_t(number)];
    const LightSample<float> from = sample_light(light, position_eye);
    const Reflectance<float> value = model.evaluate(frame, from.l);
    LightRecord r;
    r.light = number;
    r.l = from.l;
    r.strength = from.strength;
    r.n_l = glm::dot(frame.n, from.l);
    r.n_v = glm::dot(frame.n, frame.v);
    r.l_v = glm::dot(from.l, frame.v);
    r.h = normalize_or_zero(from.l + frame.v);
    r.n_h = glm::dot(frame.n, r.h);
    r.r_v = glm::dot(frame.n * (2.0f * r.n_l) - from.l, frame.v);
    r.diffuse = value.diffuse;
    r.specular = value.specular;
    r.lit_diffuse = value.diffuse * from.strength * light.diffuse;
    r.lit_specular = value.specular * from.strength * light.specular;
    return r;
}

bool same(const Vec3& a, std::span<const float> b) {
    return as_int(a.x) == as_int(b[0]) && as_int(a.y) == as_int(b[1]) && as_int(a.z) == as_int(b[2]);
}

ShadingRecord shading_of(const PlannedDraw& draw, const LitPoint& at) {
    const ShadingUniforms& u = draw.uniforms;
    const RuntimeModel model{draw.reflectance};
    const Frame<float> frame = frame_at(u, model, at.n, at.position_eye);
    const Lit<float> lit = illuminate(model, u.lights, frame, at.position_eye);
    const SurfaceColors<float> colors = mapped_colors<float>(u.material, at.uv, at.color);
    ShadingRecord r;
    r.where = at.where;
    r.position_eye = at.position_eye;
    r.n = frame.n;
    r.v = frame.v;
    for (int i = 0; i < int(u.lights.size()); ++i) r.lights.push_back(light_at(u, model, i, frame, at.position_eye));
    r.sum_diffuse = lit.diffuse;
    r.sum_specular = lit.specular;
    r.ka = colors.ambient;
    r.kd = colors.diffuse;
    r.ks = colors.specular;
    r.emission = colors.emission;
    r.alpha = colors.alpha;
    r.ambient = u.ambient;
    r.terms = make_terms(colors, u.ambient, lit);
    return r;
}

}  // namespace

ShadingRecord shading_at(const PlannedDraw& draw, std::int64_t triangle, bool front_facing,
                         const std::optional<Bug>& bug, std::span<const float> varyings,
                         std::span<const float> outputs) {
    ShadingRecord r =
        shading_of(draw, point_of(draw, triangle, front_facing, bug != Bug::no_renormalise, varyings));
    const auto plane = [&](int first) { return outputs.subspan(std::size_t(4 + first), 3); };
    r.agrees = same(r.terms.ambient, plane(shaded_plane::ambient)) &&
               same(r.terms.diffuse, plane(shaded_plane::diffuse)) &&
               same(r.terms.specular, plane(shaded_plane::specular));
    return r;
}

ShadingRecord shading_of_corner(const PlannedDraw& draw, std::uint32_t vertex, bool front_facing,
                                std::span<const float> varyings) {
    const ShadingUniforms& u = draw.uniforms;
    const SurfaceVertex<float>& v = draw.mesh.vertices[vertex];
    const bool mapped = draw.level != Detail::plain;
    const bool behind = mapped && u.two_sided && !front_facing;
    const Vec3 n = eye_normal(u, v.normal);
    ShadingRecord r = shading_of(draw, {"corner", eye_position(u, v.position), behind ? -n : n, v.uv, v.color});
    if (mapped) {
        const std::span<const float> lit = varyings.subspan(behind ? 6 : 0, 6);
        r.agrees = same(r.sum_diffuse, lit) && same(r.sum_specular, lit.subspan(3));
    } else {
        const Lit<float> lit{r.sum_diffuse, r.sum_specular};
        r.agrees = same(Vec3(plain_sum(u.material, u.ambient, lit)), varyings);
    }
    return r;
}

std::optional<Terms<float>> terms_of_varyings(const PlannedDraw& draw, bool front_facing, std::span<const float> v,
                                              std::span<const float> outputs) {
    if (draw.level == Detail::plain) return std::nullopt;
    const std::size_t side = front_facing ? 0 : 6;
    const Lit<float> lit{{v[side], v[side + 1], v[side + 2]}, {v[side + 3], v[side + 4], v[side + 5]}};
    const SurfaceColors<float> colors =
        mapped_colors<float>(draw.uniforms.material, {v[12], v[13]}, {v[14], v[15], v[16]});
    const Terms<float> terms = make_terms(colors, draw.uniforms.ambient, lit);
    if (!same(Vec3(sum_of(terms, colors.alpha)), outputs)) return std::nullopt;
    return terms;
}

}  // namespace raster::step
