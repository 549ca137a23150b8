// opengl_picture.cpp: uniforms, vertex arrays and draw calls.
#include "opengl_picture.h"

#include <map>
#include <optional>

#include <raster/scene/draw_plan.h>

#include "opengl_models.h"
#include "opengl_shaders.h"

namespace raster::tool {
namespace {

constexpr std::size_t max_lights = 8;  // of the GLSL shaders

/// A corner with all that the vertex shader may want.
struct Corner {
    SurfaceVertex<float> vertex;
    glm::vec3 face[3];
};

class UniformSetter {
public:
    UniformSetter(const OpenGl& gl, unsigned program) : gl_(gl), program_(program) { gl.UseProgram(program); }
    void set(const std::string& name, int v) const { gl_.Uniform1i(place(name), v); }
    void set(const std::string& name, float v) const { gl_.Uniform1f(place(name), v); }
    void set(const std::string& name, const glm::vec3& v) const { gl_.Uniform3fv(place(name), 1, &v.x); }
    void set(const std::string& name, const glm::vec4& v) const { gl_.Uniform4fv(place(name), 1, &v.x); }
    void set(const std::string& name, const glm::mat3& m) const { gl_.UniformMatrix3fv(place(name), 1, 0, &m[0].x); }
    void set(const std::string& name, const glm::mat4& m) const { gl_.UniformMatrix4fv(place(name), 1, 0, &m[0].x); }

private:
    int place(const std::string& name) const { return gl_.GetUniformLocation(program_, name.c_str()); }
    const OpenGl& gl_;
    unsigned program_;
};

void set_uniforms(OpenGl& gl, const UniformSetter& to, const PlannedDraw& draw) {
    const ShadingUniforms& u = draw.uniforms;
    to.set("clip_from_object", u.clip_from_object);
    to.set("eye_from_object", u.eye_from_object);
    to.set("eye_from_object_normal", u.eye_from_object_normal);
    to.set("viewer", u.viewer_eye);
    to.set("two_sided", int(u.two_sided));
    to.set("frequency", int(draw.frequency));
    to.set("grain", u.grain_eye);
    to.set("grain_cosine", u.grain_turn.x);
    to.set("grain_sine", u.grain_turn.y);
    to.set("light_ambient", u.ambient);
    to.set("light_count", int(u.lights.size()));
    for (std::size_t i = 0; i < u.lights.size(); ++i) {
        const EyeLight& light = u.lights[i];
        const std::string name = "lights[" + std::to_string(i) + "].";
        to.set(name + "kind", int(light.kind));
        to.set(name + "diffuse", light.diffuse);
        to.set(name + "specular", light.specular);
        to.set(name + "position", light.position_eye);
        to.set(name + "direction", light.direction_eye);
        to.set(name + "attenuation", glm::vec3(light.attenuation.c1, light.attenuation.c2, light.attenuation.c3));
        to.set(name + "cos_cutoff", light.cos_cutoff);
        to.set(name + "falloff", light.falloff_exponent);
        to.set(name + "inverse_square", int(light.inverse_square));
    }
    const SurfaceMaterial& m = u.material;
    to.set("ambient_color", m.ambient);
    to.set("diffuse_color", m.diffuse);
    to.set("specular_color", m.specular);
    to.set("emission_color", m.emission);
    to.set("alpha", m.alpha);
    to.set("vertex_colors", int(m.vertex_colors));
    to.set("ambient_is_diffuse", int(m.ambient_is_diffuse));
    to.set("alpha_of_alpha", int(m.alpha_texture_has_alpha));
    int unit = 0;
    for (const TextureView* t :
         {&m.ambient_texture, &m.diffuse_texture, &m.specular_texture, &m.emission_texture, &m.alpha_texture}) {
        const std::string index = "[" + std::to_string(unit) + "]";
        to.set("textured" + index, int(bool(*t)));
        to.set("images" + index, unit);
        if (*t) gl.bind_texture(*t, unsigned(unit));
        ++unit;
    }
}

std::vector<Corner> corners_of(const PlannedDraw& draw) {
    std::vector<Corner> corners;
    const auto& mesh = draw.mesh;
    const std::size_t count = mesh.indices.empty() ? mesh.vertices.size() : mesh.indices.size();
    const auto vertex = [&](std::size_t i) { return mesh.vertices[mesh.indices.empty() ? i : mesh.indices[i]]; };
    const auto corners_a_primitive = std::size_t(corner_count(draw.state.topology));
    for (std::size_t primitive = 0; primitive < count / corners_a_primitive; ++primitive) {
        std::array<SurfaceVertex<float>, 3> face;
        for (std::size_t c = 0; c < 3; ++c)
            face[c] =
                corners_a_primitive == 3 ? vertex(3 * primitive + c) : mesh.vertices[draw.triangles[3 * primitive + c]];
        for (std::size_t c = 0; c < corners_a_primitive; ++c) {
            Corner corner{vertex(primitive * corners_a_primitive + c),
                          {face[0].position, face[1].position, face[2].position}};
            if (draw.frequency == ShadingFrequency::flat)
                corner.vertex.color = (face[0].color + face[1].color + face[2].color) / 3.0f;
            corners.push_back(corner);
        }
    }
    return corners;
}

}  // namespace

Result<OpenGlPicture> render_by_opengl(OpenGl& gl, const Model& model, const CameraMatrices& camera,
                                       const RenderOptions& options, int width, int height) {
    if (options.lights.size() > max_lights)
        return Error{ErrorKind::usage, "at most 8 lights can be compared with OpenGL"};
    if (const Status status = gl.begin(width, height, options.background); !status) return status.error();
    std::map<std::string, Result<unsigned>> programs;  // by the reflectance model's source
    std::optional<Error> error;
    DrawPlan(model, options, false).for_each(camera, [&](const PlannedDraw& draw) {
        const auto reflectance = reflectance_in_glsl(draw.reflectance);
        if (!reflectance) error = Error{ErrorKind::usage, "a measured reflectance is not known in GLSL"};
        if (error) return;
        const auto [place, is_new] = programs.try_emplace(reflectance->source, 0u);
        if (is_new) {
            const std::string head = "#version 130\n" + reflectance->source + glsl::lighting;
            place->second = gl.program(head + glsl::vertex_main, head + glsl::fragment_main,
                                       {"position", "color", "uv", "normal", "face_a", "face_b", "face_c"});
        }
        if (!place->second) {
            error = place->second.error();
            return;
        }
        gl.apply(draw.state);
        const UniformSetter uniforms(gl, *place->second);
        set_uniforms(gl, uniforms, draw);
        for (const auto& uniform : reflectance->uniforms)
            std::visit([&](const auto& number) { uniforms.set(uniform.first, number); }, uniform.second);
        const std::vector<Corner> corners = corners_of(draw);
        if (corners.empty()) return;
        const Corner& first = corners[0];
        const std::pair<int, const float*> attributes[] = {
            {3, &first.vertex.position.x}, {3, &first.vertex.color.x}, {2, &first.vertex.uv.x},
            {3, &first.vertex.normal.x},   {3, &first.face[0].x},      {3, &first.face[1].x},
            {3, &first.face[2].x}};
        constexpr unsigned gl_float = 0x1406, modes[] = {0, 1, 4};  // points, lines, triangles
        for (unsigned i = 0; i < 7; ++i) {
            gl.EnableVertexAttribArray(i);
            gl.VertexAttribPointer(i, attributes[i].first, gl_float, 0, int(sizeof(Corner)), attributes[i].second);
        }
        gl.DrawArrays(modes[corner_count(draw.state.topology) - 1], 0, int(corners.size()));
    });
    if (error) return *error;
    return gl.end();
}

}  // namespace raster::tool
