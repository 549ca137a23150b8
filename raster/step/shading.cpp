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

LitPoint point_of(const PlannedDraw& draw, std::int64_t triangle, bool front_facing, std::span<const float> v) {
    const ShadingUniforms& u = draw.uniforms;
    if (draw.frequency == ShadingFrequency::phong) {
        const Vec3 outward = normalize_or_zero<float>({v[0], v[1], v[2]});
        return {"pixel", {v[3], v[4], v[5]}, u.two_sided ? negate_where<float>(!front_facing, outward) : outward,
                {v[6], v[7]}, {v[8], v[9], v[10]}};
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
    r.diffuse = value.diffuse;
    r.specular = value.specular;
    r.lit_diffuse = value.diffuse * from.strength * light.diffuse;
    r.lit_specular = value.specular * from.strength * light.specular;
    return r;
}

bool same(const Vec3& a, std::span<const float> b) {
    return as_int(a.x) == as_int(b[0]) && as_int(a.y) == as_int(b[1]) && as_int(a.z) == as_int(b[2]);
}

}  // namespace

std::optional<ShadingRecord> shading_at(const PlannedDraw& draw, std::int64_t triangle, bool front_facing,
                                        std::span<const float> varyings, std::span<const float> outputs) {
    if (draw.frequency == ShadingFrequency::gouraud) return std::nullopt;
    const ShadingUniforms& u = draw.uniforms;
    const RuntimeModel model{draw.reflectance};
    const LitPoint at = point_of(draw, triangle, front_facing, varyings);
    const Frame<float> frame = frame_at(u, model, at.n, at.position_eye);
    ShadingRecord r;
    r.where = at.where;
    r.position_eye = at.position_eye;
    r.n = frame.n;
    r.v = frame.v;
    for (int i = 0; i < int(u.lights.size()); ++i) r.lights.push_back(light_at(u, model, i, frame, at.position_eye));
    const Lit<float> lit = illuminate(model, u.lights, frame, at.position_eye);
    r.sum_diffuse = lit.diffuse;
    r.sum_specular = lit.specular;
    const SurfaceColors<float> colors = mapped_colors<float>(u.material, at.uv, at.color);
    const Terms<float> terms = make_terms(colors, u.ambient, lit);
    r.ka = colors.ambient;
    r.kd = colors.diffuse;
    r.ks = colors.specular;
    r.emission = colors.emission;
    r.alpha = colors.alpha;
    r.ambient = u.ambient;
    const auto plane = [&](int first) { return outputs.subspan(std::size_t(4 + first), 3); };
    r.agrees = same(terms.ambient, plane(shaded_plane::ambient)) && same(terms.diffuse, plane(shaded_plane::diffuse)) &&
               same(terms.specular, plane(shaded_plane::specular));
    return r;
}

}  // namespace raster::step
