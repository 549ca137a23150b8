// rival.cpp: OSMesa context, GLSL programs, buffer objects.
#define GL_GLEXT_PROTOTYPES
#include "rival.h"

#include <GL/osmesa.h>

#include <algorithm>

#include <GL/gl.h>
#include <GL/glext.h>

#include <raster/scene/transform.h>

namespace bench {

namespace {

const char* const lighting = R"(#version 120
uniform vec3 to_light;
uniform vec3 base;
vec3 blinn_phong(vec3 normal, vec3 eye_position) {
    vec3 n = normalize(normal), v = normalize(-eye_position);
    vec3 h = normalize(to_light + v);
    float n_l = max(dot(n, to_light), 0.0);
    float highlight = n_l > 0.0 ? pow(max(dot(n, h), 0.0), 32.0) : 0.0;
    return base * (0.2 + 0.8 * n_l) + vec3(0.5 * highlight);
}
)";
const char* const per_pixel_vertex = R"(
uniform mat4 clip_from_world, eye_from_world;
uniform mat3 normals;
varying vec3 normal, position;
void main() {
    gl_Position = clip_from_world * gl_Vertex;
    normal = normals * gl_Normal;
    position = vec3(eye_from_world * gl_Vertex);
})";
const char* const per_pixel_fragment = R"(
varying vec3 normal, position;
void main() { gl_FragColor = vec4(blinn_phong(normal, position), 1.0); })";
// The reflectance models, as a page of GLSL: what is diffuse and what specular of the light from l.
const char* const reflectance_common = R"(
uniform vec3 metal_n, metal_k;
varying vec3 normal, position;
)";
const char* const reflectance_main = R"(
void main() {
    vec3 diffuse, specular;
    vec3 n = normalize(normal), v = normalize(-position);
    reflect_light(n, v, to_light, diffuse, specular);
    gl_FragColor = vec4(base * (0.2 + 0.8 * diffuse) + 0.5 * specular, 1.0);
})";
struct GlslModel {
    const char* name;
    const char* function;
};
const GlslModel glsl_models[] = {
    {"lambert", R"(
void reflect_light(vec3 n, vec3 v, vec3 l, out vec3 diffuse, out vec3 specular) {
    diffuse = vec3(max(dot(n, l), 0.0));
    specular = vec3(0.0);
})"},
    {"phong", R"(
void reflect_light(vec3 n, vec3 v, vec3 l, out vec3 diffuse, out vec3 specular) {
    float n_l = dot(n, l);
    float r_v = 2.0 * n_l * dot(n, v) - dot(l, v);
    diffuse = vec3(max(n_l, 0.0));
    specular = vec3(n_l > 0.0 ? pow(max(r_v, 0.0), 32.0) : 0.0);
})"},
    {"blinn-phong", R"(
void reflect_light(vec3 n, vec3 v, vec3 l, out vec3 diffuse, out vec3 specular) {
    float n_l = dot(n, l), n_h = dot(n, normalize(l + v));
    diffuse = vec3(max(n_l, 0.0));
    specular = vec3(n_l > 0.0 ? pow(max(n_h, 0.0), 32.0) : 0.0);
})"},
    {"oren-nayar", R"(
void reflect_light(vec3 n, vec3 v, vec3 l, out vec3 diffuse, out vec3 specular) {
    const float s2 = 0.25, a = 1.0 - 0.5 * s2 / (s2 + 0.33), b = 0.45 * s2 / (s2 + 0.09);
    float n_l = dot(n, l), n_v = max(dot(n, v), 0.0);
    float along = max(dot(l, v) - n_l * n_v, 0.0) / max(max(n_l, n_v), 1e-6);
    diffuse = vec3(n_l > 0.0 ? n_l * (a + b * along) : 0.0);
    specular = vec3(0.0);
})"},
    {"cook-torrance", R"(
vec3 fresnel(float c) {
    float c2 = c * c, s2 = 1.0 - c2;
    vec3 n2 = metal_n * metal_n, k2 = metal_k * metal_k, t0 = n2 - k2 - s2;
    vec3 q = sqrt(t0 * t0 + 4.0 * n2 * k2), a = sqrt(max(0.5 * (q + t0), 0.0));
    vec3 rs = (q + c2 - 2.0 * a * c) / (q + c2 + 2.0 * a * c);
    vec3 t3 = c2 * q + s2 * s2, t4 = 2.0 * a * c * s2;
    return 0.5 * rs * (1.0 + (t3 - t4) / (t3 + t4));
}
void reflect_light(vec3 n, vec3 v, vec3 l, out vec3 diffuse, out vec3 specular) {
    const float m2 = 0.04;
    vec3 h = normalize(l + v);
    float n_l = dot(n, l), n_v = dot(n, v), n_h = dot(n, h), v_h = dot(v, h), c2 = n_h * n_h;
    float d = exp((1.0 - 1.0 / c2) / m2) / (m2 * c2 * c2);
    float g = min(1.0, 2.0 * n_h * min(n_l, n_v) / v_h);
    diffuse = vec3(max(n_l, 0.0));
    specular = n_l > 0.0 && n_v > 0.0 ? fresnel(v_h) * (0.25 * d * g / n_v) : vec3(0.0);
})"},
};
const char* const gouraud_vertex = R"(
uniform mat4 clip_from_world, eye_from_world;
uniform mat3 normals;
varying vec3 color;
void main() {
    gl_Position = clip_from_world * gl_Vertex;
    color = blinn_phong(normals * gl_Normal, vec3(eye_from_world * gl_Vertex));
})";
const char* const gouraud_fragment = R"(
varying vec3 color;
void main() { gl_FragColor = vec4(color, 1.0); })";
const char* const textured_vertex = R"(
uniform mat4 clip_from_world;
uniform mat3 normals;
varying vec3 normal;
varying vec2 uv;
void main() {
    gl_Position = clip_from_world * gl_Vertex;
    normal = normals * gl_Normal;
    uv = gl_MultiTexCoord0.xy;
})";
const char* const textured_fragment = R"(
uniform sampler2D image;
varying vec3 normal;
varying vec2 uv;
void main() {
    float n_l = max(dot(normalize(normal), to_light), 0.0);
    gl_FragColor = vec4(texture2D(image, uv).rgb * (0.2 + 0.8 * n_l), 1.0);
})";
const char* const plain_vertex = R"(
uniform mat4 clip_from_world;
void main() { gl_Position = clip_from_world * gl_Vertex; })";
const char* const plain_fragment = R"(
uniform vec4 color;
void main() { gl_FragColor = color; })";

const GlslModel* find_glsl(const std::string& name) {
    const auto model = std::find_if(std::begin(glsl_models), std::end(glsl_models),
                                    [&](const GlslModel& m) { return name == m.name; });
    return model == std::end(glsl_models) ? nullptr : model;
}

unsigned compile(unsigned kind, const std::string& source, std::string& error) {
    const unsigned shader = glCreateShader(kind);
    const char* parts[] = {lighting, source.c_str()};
    glShaderSource(shader, 2, parts, nullptr);
    glCompileShader(shader);
    int ok = 0;
    glGetShaderiv(shader, GL_COMPILE_STATUS, &ok);
    if (!ok) {
        char log[1000];
        glGetShaderInfoLog(shader, sizeof log, nullptr, log);
        error = log;
    }
    return shader;
}

}  // namespace

bool has_glsl(const std::string& reflectance) { return find_glsl(reflectance) != nullptr; }

Rival::Rival(const Scene& scene, int width, int height)
    : scene_(scene), width_(width), height_(height), color_(std::size_t(width) * std::size_t(height)) {
    const int attributes[] = {
        OSMESA_FORMAT, OSMESA_RGBA, OSMESA_DEPTH_BITS, 24, OSMESA_PROFILE, OSMESA_COMPAT_PROFILE, 0};
    auto context = OSMesaCreateContextAttribs(attributes, nullptr);
    if (!context || !OSMesaMakeCurrent(context, color_.data(), GL_UNSIGNED_BYTE, width, height)) {
        error_ = "OSMesa gave no context";
        return;
    }
    context_ = context;
    OSMesaPixelStore(OSMESA_Y_UP, 0);

    std::string vertex = plain_vertex, fragment = plain_fragment;
    if (scene.shading == Shading::reflectance) {
        vertex = per_pixel_vertex;
        const GlslModel* model = find_glsl(scene.reflectance);
        if (!model) {
            error_ = "no GLSL for " + scene.reflectance;
            return;
        }
        fragment = std::string(reflectance_common) + model->function + reflectance_main;
    }
    if (scene.shading == Shading::per_pixel) vertex = per_pixel_vertex, fragment = per_pixel_fragment;
    if (scene.shading == Shading::gouraud) vertex = gouraud_vertex, fragment = gouraud_fragment;
    if (scene.shading == Shading::textured) vertex = textured_vertex, fragment = textured_fragment;
    program_ = glCreateProgram();
    glAttachShader(program_, compile(GL_VERTEX_SHADER, vertex, error_));
    glAttachShader(program_, compile(GL_FRAGMENT_SHADER, fragment, error_));
    glLinkProgram(program_);
    glUseProgram(program_);
    const auto at = [&](const char* name) { return glGetUniformLocation(program_, name); };
    const glm::mat4 clip = raster::product(projection(width, height), scene.eye_from_world);
    const glm::mat3 normals(scene.eye_from_world);
    const glm::vec3 light = to_light_eye();
    glUniformMatrix4fv(at("clip_from_world"), 1, GL_FALSE, &clip[0][0]);
    glUniformMatrix4fv(at("eye_from_world"), 1, GL_FALSE, &scene.eye_from_world[0][0]);
    glUniformMatrix3fv(at("normals"), 1, GL_FALSE, &normals[0][0]);
    glUniform3fv(at("to_light"), 1, &light.x);
    glUniform3fv(at("base"), 1, &base_color.x);
    glUniform3fv(at("metal_n"), 1, &metal_n.x);
    glUniform3fv(at("metal_k"), 1, &metal_k.x);
    glUniform4f(at("color"), base_color.x, base_color.y, base_color.z, scene.blend ? 0.5f : 1.0f);

    unsigned buffers[2];
    glGenBuffers(2, buffers);
    glBindBuffer(GL_ARRAY_BUFFER, buffers[0]);
    glBufferData(GL_ARRAY_BUFFER, GLsizeiptr(scene.vertices.size() * sizeof(Vertex<float>)), scene.vertices.data(),
                 GL_STATIC_DRAW);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffers[1]);
    glBufferData(GL_ELEMENT_ARRAY_BUFFER, GLsizeiptr(scene.indices.size() * 4), scene.indices.data(), GL_STATIC_DRAW);
    index_count_ = int(scene.indices.size());
    const auto offset = [](std::size_t bytes) { return reinterpret_cast<const void*>(bytes); };
    glEnableClientState(GL_VERTEX_ARRAY);
    glVertexPointer(3, GL_FLOAT, sizeof(Vertex<float>), offset(0));
    if (scene.shading >= Shading::gouraud) {
        glEnableClientState(GL_NORMAL_ARRAY);
        glNormalPointer(GL_FLOAT, sizeof(Vertex<float>), offset(12));
    }
    if (scene.shading == Shading::textured) {
        glEnableClientState(GL_TEXTURE_COORD_ARRAY);
        glTexCoordPointer(2, GL_FLOAT, sizeof(Vertex<float>), offset(24));
        // Row 0 of an OpenGL image is its bottom row.
        glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, scene.texture.width, scene.texture.height, 0, GL_RGBA,
                     GL_UNSIGNED_BYTE, scene.upside_down.data());
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    }

    glEnable(GL_DEPTH_TEST);
    if (scene.cull_back) glEnable(GL_CULL_FACE);
    if (scene.blend) {
        glEnable(GL_BLEND);
        glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    }
    if (scene.shading == Shading::none) glColorMask(0, 0, 0, 0);
    glClearColor(clear_color.x, clear_color.y, clear_color.z, clear_color.w);
    if (const unsigned e = glGetError(); e != GL_NO_ERROR) error_ = "OpenGL error " + std::to_string(e);
}

Rival::~Rival() {
    if (context_) OSMesaDestroyContext(static_cast<OSMesaContext>(context_));
}

std::string Rival::version() const {
    return std::string(reinterpret_cast<const char*>(glGetString(GL_VERSION))) + ", " +
           reinterpret_cast<const char*>(glGetString(GL_RENDERER));
}

void Rival::frame() {
    if (scene_.shading == Shading::none) glColorMask(1, 1, 1, 1);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    if (scene_.shading == Shading::none) glColorMask(0, 0, 0, 0);
    if (index_count_ > 0) glDrawElements(GL_TRIANGLES, index_count_, GL_UNSIGNED_INT, nullptr);
    glFinish();
}

std::vector<std::uint32_t> Rival::depth() {
    std::vector<std::uint32_t> bottom_up(color_.size()), result(color_.size());
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, width_, height_, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT, bottom_up.data());
    for (int y = 0; y < height_; ++y)
        for (int x = 0; x < width_; ++x)
            result[std::size_t(y * width_ + x)] = bottom_up[std::size_t((height_ - 1 - y) * width_ + x)] >> 8;
    return result;
}

}  // namespace bench
