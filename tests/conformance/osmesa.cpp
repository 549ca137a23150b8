// osmesa.cpp: the OpenGL side of the comparison.
#define GL_GLEXT_PROTOTYPES
#include "osmesa.h"

#include <cstdio>
#include <cstdlib>

#include <GL/osmesa.h>

#include <raster/stages/project.h>

namespace raster::conformance {

namespace {

[[noreturn]] void fail(const std::string& what) {
    std::fprintf(stderr, "OSMesa: %s\n", what.c_str());
    std::abort();
}

GLenum gl_compare(Compare compare) {
    switch (compare) {
        case Compare::never: return GL_NEVER;
        case Compare::less: return GL_LESS;
        case Compare::equal: return GL_EQUAL;
        case Compare::less_equal: return GL_LEQUAL;
        case Compare::greater: return GL_GREATER;
        case Compare::not_equal: return GL_NOTEQUAL;
        case Compare::greater_equal: return GL_GEQUAL;
        case Compare::always: break;
    }
    return GL_ALWAYS;
}

GLenum gl_topology(Topology topology) {
    switch (topology) {
        case Topology::triangle_strip: return GL_TRIANGLE_STRIP;
        case Topology::triangle_fan: return GL_TRIANGLE_FAN;
        case Topology::points: return GL_POINTS;
        case Topology::lines: return GL_LINES;
        case Topology::line_strip: return GL_LINE_STRIP;
        case Topology::line_loop: return GL_LINE_LOOP;
        case Topology::triangles: break;
    }
    return GL_TRIANGLES;
}

std::string vertex_source(const std::string& interpolation) {
    return "#version 130\n"
           "in vec4 position, color; in vec2 uv;\n" +
           interpolation +
           " out vec4 tint;\n"
           "void main() { gl_Position = position; tint = color; }\n";
}

std::string fragment_source(const std::string& interpolation) {
    return "#version 130\n" + interpolation +
           " in vec4 tint; out vec4 result;\n"
           "void main() { result = tint; }\n";
}

constexpr const char* textured_vertex =
    "#version 130\n"
    "in vec4 position, color; in vec2 uv; out vec4 tint; out vec2 where;\n"
    "void main() { gl_Position = position; tint = color; where = uv; }\n";
constexpr const char* textured_fragment =
    "#version 130\n"
    "in vec4 tint; in vec2 where; out vec4 result; uniform sampler2D image;\n"
    "void main() { result = texture(image, where) * tint; }\n";

}  // namespace

Oracle& Oracle::instance() {
    static Oracle oracle;
    return oracle;
}

Oracle::Oracle() {
    // The driver compiles its shaders for the processor it finds. Without FMA and with one width of registers it gives
    // the same bits on every machine.
    setenv("GALLIUM_DRIVER", "llvmpipe", 1);
    setenv("GALLIUM_OVERRIDE_CPU_CAPS", "sse4.1", 1);
    setenv("GALLIVM_PERF", "no_aos_sampling", 1);
    const int attributes[] = {
        OSMESA_FORMAT, OSMESA_RGBA, OSMESA_DEPTH_BITS, 24, OSMESA_PROFILE, OSMESA_COMPAT_PROFILE, 0};
    context_ = OSMesaCreateContextAttribs(attributes, nullptr);
    if (!context_) fail("no context");
}

Oracle::~Oracle() { OSMesaDestroyContext(OSMesaContext(context_)); }

std::string Oracle::string(unsigned name) const {
    // Without a current context there are no strings: a first picture makes one current.
    if (!glGetString(name)) const_cast<Oracle*>(this)->begin(1, 1, glm::vec4(0), 1);
    return reinterpret_cast<const char*>(glGetString(name));
}

std::string Oracle::version() const {
    const std::string full = string(GL_VERSION);
    const auto mesa = full.find("Mesa ");
    return mesa == std::string::npos ? full : full.substr(mesa);
}

std::string Oracle::renderer() const { return string(GL_RENDERER); }

void Oracle::begin(int width, int height, glm::vec4 clear_color, float clear_depth) {
    width_ = width, height_ = height;
    buffer_.assign(std::size_t(width) * std::size_t(height), 0);
    if (!OSMesaMakeCurrent(OSMesaContext(context_), buffer_.data(), GL_UNSIGNED_BYTE, width, height))
        fail("cannot make a target current");
    OSMesaPixelStore(OSMESA_Y_UP, 0);
    apply({}, width, height);
    glUseProgram(0);
    glClearColor(clear_color.r, clear_color.g, clear_color.b, clear_color.a);
    glClearDepth(double(clear_depth));
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
}

Picture Oracle::end() {
    glFinish();
    Picture picture;
    picture.color = buffer_;
    std::vector<std::uint32_t> depth(buffer_.size());
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, width_, height_, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT, depth.data());
    if (const GLenum error = glGetError(); error != GL_NO_ERROR) fail("error " + std::to_string(error));
    // OpenGL's rows go up, and its 24 bits of depth are the upper ones of 32.
    for (int y = height_ - 1; y >= 0; --y)
        for (int x = 0; x < width_; ++x)
            picture.depth.push_back(depth[std::size_t(y) * std::size_t(width_) + std::size_t(x)] >> 8);
    return picture;
}

void Oracle::apply(const State& state, int width, int height) {
    const auto enable = [](GLenum what, bool on) { on ? glEnable(what) : glDisable(what); };
    const Viewport viewport = effective_viewport(state.viewport, width, height);
    glViewport(viewport.x, height - (viewport.y + viewport.height), viewport.width, viewport.height);
    glDepthRange(double(viewport.near_depth), double(viewport.far_depth));
    glFrontFace(state.front_face == FrontFace::counter_clockwise ? GL_CCW : GL_CW);
    enable(GL_CULL_FACE, state.cull != Cull::none);
    glCullFace(state.cull == Cull::both ? GL_FRONT_AND_BACK : state.cull == Cull::front ? GL_FRONT : GL_BACK);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(gl_compare(state.depth_compare));
    glDepthMask(state.depth_write);
    const GLboolean color = state.color_write;
    glColorMask(color, color, color, color);
    enable(GL_SCISSOR_TEST, state.scissor.has_value());
    if (const auto& s = state.scissor) glScissor(s->x, height - (s->y + s->height), s->width, s->height);
    enable(GL_POLYGON_OFFSET_FILL, state.depth_offset.is_on());
    glPolygonOffset(state.depth_offset.factor, state.depth_offset.units);
    glLineWidth(float(state.line_width));
    glPointSize(state.point_size);
    for (std::size_t i = 0; i < std::size_t(max_user_planes); ++i) {
        const GLenum plane = GL_CLIP_PLANE0 + GLenum(i);
        enable(plane, i < state.clip_planes.size());
        if (i >= state.clip_planes.size()) continue;
        const glm::dvec4 coefficients(state.clip_planes[i]);
        glClipPlane(plane, &coefficients.x);
    }
    enable(GL_BLEND, state.blend != Blend::off);
    if (state.blend == Blend::additive)
        glBlendFunc(GL_ONE, GL_ONE);
    else
        glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
}

void Oracle::bind_texture(const TextureView& texture, unsigned unit) {
    glActiveTexture(GL_TEXTURE0 + unit);
    static GLuint names[8] = {};
    if (!names[unit]) glGenTextures(1, &names[unit]);
    glBindTexture(GL_TEXTURE_2D, names[unit]);
    // OpenGL's first row is the bottom one.
    const std::size_t width = std::size_t(texture.width), height = std::size_t(texture.height);
    std::vector<std::int32_t> rows;
    for (std::size_t y = height; y-- > 0;)
        rows.insert(rows.end(), texture.texels + y * width, texture.texels + (y + 1) * width);
    const GLint wrap = texture.wrap == Wrap::repeat  ? GL_REPEAT
                       : texture.wrap == Wrap::clamp ? GL_CLAMP_TO_EDGE
                                                     : GL_MIRRORED_REPEAT;
    const GLint filter = texture.filter == Filter::nearest ? GL_NEAREST : GL_LINEAR;
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, wrap);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, wrap);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, filter);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, filter);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, texture.width, texture.height, 0, GL_RGBA, GL_UNSIGNED_BYTE, rows.data());
    glActiveTexture(GL_TEXTURE0);
}

unsigned Oracle::program(const std::string& vertex, const std::string& fragment) {
    unsigned& program = programs_[vertex + '\0' + fragment];
    if (program) return program;
    program = glCreateProgram();
    const auto attach = [&](GLenum kind, const std::string& source) {
        const GLuint shader = glCreateShader(kind);
        const char* text = source.c_str();
        glShaderSource(shader, 1, &text, nullptr);
        glCompileShader(shader);
        GLint good = 0;
        glGetShaderiv(shader, GL_COMPILE_STATUS, &good);
        if (!good) {
            char log[2000] = "";
            glGetShaderInfoLog(shader, sizeof log, nullptr, log);
            fail(std::string(log) + source);
        }
        glAttachShader(program, shader);
    };
    attach(GL_VERTEX_SHADER, vertex);
    attach(GL_FRAGMENT_SHADER, fragment);
    GLuint place = 0;
    for (const char* attribute : {"position", "color", "uv"})
        glBindAttribLocation(program, place++, attribute);
    glLinkProgram(program);
    GLint good = 0;
    glGetProgramiv(program, GL_LINK_STATUS, &good);
    if (!good) fail("cannot link " + vertex + fragment);
    return program;
}

void Oracle::draw(const Draw& draw, int width, int height) {
    apply(draw.full_state(), width, height);
    constexpr GLsizei stride = sizeof(Vertex);
    const Vertex* first = draw.vertices.data();
    if (draw.style == Style::fixed_function) {
        glUseProgram(0);
        glEnableClientState(GL_VERTEX_ARRAY);
        glEnableClientState(GL_COLOR_ARRAY);
        glVertexPointer(4, GL_FLOAT, stride, &first->position);
        glColorPointer(4, GL_FLOAT, stride, &first->color);
    } else {
        const std::string how = draw.style == Style::flat            ? "flat"
                                : draw.style == Style::noperspective ? "noperspective"
                                                                     : "smooth";
        if (draw.style == Style::textured) {
            bind_texture(TextureView(draw.texture.image, draw.texture.wrap, draw.texture.filter), 0);
            glUseProgram(program(textured_vertex, textured_fragment));
        } else {
            glUseProgram(program(vertex_source(how), fragment_source(how)));
        }
        for (GLuint i = 0; i < 3; ++i) glEnableVertexAttribArray(i);
        glVertexAttribPointer(0, 4, GL_FLOAT, false, stride, &first->position);
        glVertexAttribPointer(1, 4, GL_FLOAT, false, stride, &first->color);
        glVertexAttribPointer(2, 2, GL_FLOAT, false, stride, &first->uv);
    }
    const GLenum topology = gl_topology(draw.state.topology);
    if (draw.indices.empty())
        glDrawArrays(topology, 0, GLsizei(draw.vertices.size()));
    else
        glDrawElements(topology, GLsizei(draw.indices.size()), GL_UNSIGNED_INT, draw.indices.data());
    glDisableClientState(GL_VERTEX_ARRAY);
    glDisableClientState(GL_COLOR_ARRAY);
    for (GLuint i = 0; i < 3; ++i) glDisableVertexAttribArray(i);
}

Picture Oracle::render(const Scene& scene) {
    return render(scene.width, scene.height, scene.clear_color, scene.clear_depth, [&] {
        for (const Draw& d : scene.draws) draw(d, scene.width, scene.height);
    });
}

}  // namespace raster::conformance
