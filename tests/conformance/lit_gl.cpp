// lit_gl.cpp: flat, Gouraud and Phong shading in GLSL.
#define GL_GLEXT_PROTOTYPES
#include "lit_gl.h"

#include <GL/gl.h>

namespace raster::conformance {

namespace {

// One sum of light for all three frequencies. The formulas are those of the lectures: r = 2 (n l) n - l, h = (l + v) /
// |l + v|.
constexpr const char* lighting = R"(
struct Light {
    int kind;  // 1 directional, 2 point, 3 spot
    vec3 diffuse, specular, position, direction, attenuation;
    float cos_cutoff, exponent;
};
uniform Light lights[8];
uniform int light_count, model;  // 0 Lambert, 1 Phong, 2 Blinn-Phong
uniform float shininess;
uniform vec4 viewer;

void illuminate(vec3 n, vec3 p, out vec3 diffuse, out vec3 specular) {
    vec3 v = normalize(viewer.xyz - p * viewer.w);
    diffuse = specular = vec3(0.0);
    for (int i = 0; i < light_count; ++i) {
        vec3 l = -lights[i].direction;
        float strength = 1.0;
        if (lights[i].kind != 1) {
            vec3 to_light = lights[i].position - p;
            float d = length(to_light);
            l = to_light / d;
            strength = min(1.0 / dot(lights[i].attenuation, vec3(1.0, d, d * d)), 1.0);
            float along = dot(-l, lights[i].direction);
            if (lights[i].kind == 3) strength *= along >= lights[i].cos_cutoff ? pow(along, lights[i].exponent) : 0.0;
        }
        float n_l = dot(n, l);
        if (n_l <= 0.0) continue;
        diffuse += lights[i].diffuse * n_l * strength;
        if (model == 0) continue;
        vec3 r = 2.0 * n_l * n - l;
        float c = model == 1 ? dot(r, v) : dot(n, normalize(l + v));
        if (c > 0.0) specular += lights[i].specular * pow(c, shininess) * strength;
    }
}
)";

constexpr const char* vertex_main = R"(
in vec3 position, normal, color, face_a, face_b, face_c;
in vec2 uv;
uniform mat4 clip_from_object, eye_from_object;
uniform mat3 eye_from_object_normal;
uniform int frequency;  // 0 flat, 1 Gouraud, 2 Phong
uniform bool two_sided;
out vec3 normal_eye, position_eye, tint, front_diffuse, front_specular, back_diffuse, back_specular;
flat out vec3 face_diffuse, face_specular;
out vec2 where;

vec3 to_eye(vec3 p) { return (eye_from_object * vec4(p, 1.0)).xyz; }

void main() {
    gl_Position = clip_from_object * vec4(position, 1.0);
    position_eye = to_eye(position);
    normal_eye = eye_from_object_normal * normal;
    tint = color;
    where = uv;
    face_diffuse = face_specular = front_diffuse = front_specular = back_diffuse = back_specular = vec3(0.0);
    if (frequency == 0) {
        vec3 a = to_eye(face_a), b = to_eye(face_b), c = to_eye(face_c), middle = (a + b + c) / 3.0;
        vec3 n = normalize(cross(b - a, c - a));
        if (two_sided && dot(n, viewer.xyz - middle * viewer.w) < 0.0) n = -n;
        illuminate(n, middle, face_diffuse, face_specular);
    } else if (frequency == 1) {
        vec3 n = normalize(normal_eye);
        illuminate(n, position_eye, front_diffuse, front_specular);
        illuminate(-n, position_eye, back_diffuse, back_specular);
    }
}
)";

constexpr const char* fragment_main = R"(
in vec3 normal_eye, position_eye, tint, front_diffuse, front_specular, back_diffuse, back_specular;
flat in vec3 face_diffuse, face_specular;
in vec2 where;
uniform int frequency;
uniform bool two_sided, vertex_colors, ambient_is_diffuse, alpha_of_alpha;
uniform vec3 light_ambient, ambient_color, diffuse_color, specular_color, emission_color;
uniform float alpha;
uniform bool textured[5];
uniform sampler2D images[5];
out vec4 result;

void main() {
    vec3 kd = diffuse_color, ka = ambient_color, ks = specular_color, ke = emission_color;
    float opacity = alpha;
    if (textured[1]) kd *= texture(images[1], where).rgb;
    if (ambient_is_diffuse) ka *= kd;
    else if (textured[0]) ka *= texture(images[0], where).rgb;
    if (textured[2]) ks *= texture(images[2], where).rgb;
    if (textured[3]) ke *= texture(images[3], where).rgb;
    if (textured[4]) opacity *= alpha_of_alpha ? texture(images[4], where).a : texture(images[4], where).r;
    if (vertex_colors) kd *= tint, ka *= tint;
    bool turned = two_sided && !gl_FrontFacing;
    vec3 diffuse = face_diffuse, specular = face_specular;
    if (frequency == 1) {
        diffuse = turned ? back_diffuse : front_diffuse;
        specular = turned ? back_specular : front_specular;
    } else if (frequency == 2) {
        vec3 n = normalize(normal_eye);
        illuminate(turned ? -n : n, position_eye, diffuse, specular);
    }
    result = vec4(ke + ka * light_ambient + kd * diffuse + ks * specular, opacity);
}
)";

/// A corner with all that the vertex shader may want.
struct Corner {
    SurfaceVertex<float> vertex;
    glm::vec3 face[3];
};

class Uniforms {
public:
    explicit Uniforms(GLuint program) : program_(program) { glUseProgram(program); }
    void set(const std::string& name, int v) { glUniform1i(place(name), v); }
    void set(const std::string& name, float v) { glUniform1f(place(name), v); }
    void set(const std::string& name, const glm::vec3& v) { glUniform3fv(place(name), 1, &v.x); }
    void set(const std::string& name, const glm::vec4& v) { glUniform4fv(place(name), 1, &v.x); }
    void set(const std::string& name, const glm::mat3& m) { glUniformMatrix3fv(place(name), 1, false, &m[0].x); }
    void set(const std::string& name, const glm::mat4& m) { glUniformMatrix4fv(place(name), 1, false, &m[0].x); }

private:
    GLint place(const std::string& name) const { return glGetUniformLocation(program_, name.c_str()); }
    GLuint program_;
};

void set_reflectance(Uniforms& to, const AnyReflectance& reflectance) {
    float exponent = 0;
    if (const auto* phong = std::get_if<Phong>(&reflectance)) exponent = phong->exponent;
    if (const auto* blinn = std::get_if<BlinnPhong>(&reflectance))
        exponent = blinn->convention == BlinnPhong::Exponent::alpha ? blinn->exponent : blinn->exponent / 4;
    to.set("shininess", exponent);
    to.set("model", std::holds_alternative<Phong>(reflectance)        ? 1
                    : std::holds_alternative<BlinnPhong>(reflectance) ? 2
                                                                      : 0);
}

void set_uniforms(Uniforms& to, const PlannedDraw& draw) {
    const ShadingUniforms& u = draw.uniforms;
    to.set("clip_from_object", u.clip_from_object);
    to.set("eye_from_object", u.eye_from_object);
    to.set("eye_from_object_normal", u.eye_from_object_normal);
    to.set("viewer", u.viewer_eye);
    to.set("two_sided", int(u.two_sided));
    to.set("frequency", int(draw.frequency));
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
        to.set(name + "exponent", light.falloff_exponent);
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
        if (*t) Oracle::bind_texture(*t, unsigned(unit));
        ++unit;
    }
}

std::vector<Corner> corners_of(const PlannedDraw& draw) {
    std::vector<Corner> corners;
    const auto& mesh = draw.mesh;
    const std::size_t count = mesh.indices.empty() ? mesh.vertices.size() : mesh.indices.size();
    for (std::size_t i = 0; i + 2 < count; i += 3) {
        std::array<SurfaceVertex<float>, 3> v;
        for (std::size_t c = 0; c < 3; ++c) v[c] = mesh.vertices[mesh.indices.empty() ? i + c : mesh.indices[i + c]];
        const glm::vec3 mean = (v[0].color + v[1].color + v[2].color) / 3.0f;
        for (auto& one : v) {
            if (draw.frequency == ShadingFrequency::flat) one.color = mean;
            corners.push_back({one, {v[0].position, v[1].position, v[2].position}});
        }
    }
    return corners;
}

}  // namespace

Picture render_lit(Oracle& oracle, const Model& model, const CameraMatrices& camera, const RenderOptions& options,
                   int width, int height) {
    return oracle.render(width, height, options.background, 1, [&] {
        const std::string version = "#version 130\n";
        const GLuint program = oracle.program(version + lighting + vertex_main, version + lighting + fragment_main);
        DrawPlan(model, options, false).for_each(camera, [&](const PlannedDraw& draw) {
            Oracle::apply(draw.state, width, height);
            Uniforms uniforms(program);
            set_uniforms(uniforms, draw);
            set_reflectance(uniforms, draw.reflectance);
            const std::vector<Corner> corners = corners_of(draw);
            const Corner& first = corners[0];
            const std::pair<int, const float*> attributes[] = {
                {3, &first.vertex.position.x}, {3, &first.vertex.color.x}, {2, &first.vertex.uv.x},
                {3, &first.vertex.normal.x},   {3, &first.face[0].x},      {3, &first.face[1].x},
                {3, &first.face[2].x}};
            for (GLuint i = 0; i < 7; ++i) {
                glEnableVertexAttribArray(i);
                glVertexAttribPointer(i, attributes[i].first, GL_FLOAT, false, sizeof(Corner), attributes[i].second);
            }
            glDrawArrays(GL_TRIANGLES, 0, GLsizei(corners.size()));
            for (GLuint i = 0; i < 7; ++i) glDisableVertexAttribArray(i);
        });
    });
}

}  // namespace raster::conformance
