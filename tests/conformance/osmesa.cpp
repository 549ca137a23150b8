// osmesa.cpp: the OpenGL side of the comparison: a scene's draws with their shaders.
#include "osmesa.h"

#include <cstdio>
#include <cstdlib>

#include <GL/gl.h>

namespace raster::conformance {

namespace {

/// The value, or the end of the program: without an oracle there is nothing to test.
template <class T>
T value_of(Result<T> result) {
    if (result) return std::move(*result);
    std::fprintf(stderr, "%s\n", result.error().message.c_str());
    std::abort();
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

Oracle::Oracle() : gl_(value_of(tool::OpenGl::make())) {}

std::string Oracle::version() {
    // Without a current context there is none: a first picture makes one current.
    if (!gl_->GetString(GL_VERSION)) {
        Scene scene;
        scene.width = scene.height = 1;
        render(scene);
    }
    return gl_->version();
}

unsigned Oracle::program(const std::string& vertex, const std::string& fragment) {
    unsigned& program = programs_[vertex + '\0' + fragment];
    if (!program) program = value_of(gl_->program(vertex, fragment, {"position", "color", "uv"}));
    return program;
}

void Oracle::draw(const Draw& draw) {
    tool::OpenGl& gl = *gl_;
    gl.apply(draw.full_state());
    constexpr int stride = sizeof(Vertex);
    const Vertex* first = draw.vertices.data();
    if (draw.coloring == Coloring::fixed_function) {
        gl.UseProgram(0);
        gl.EnableClientState(GL_VERTEX_ARRAY);
        gl.EnableClientState(GL_COLOR_ARRAY);
        gl.VertexPointer(4, GL_FLOAT, stride, &first->position);
        gl.ColorPointer(4, GL_FLOAT, stride, &first->color);
    } else {
        const std::string how = draw.coloring == Coloring::flat            ? "flat"
                                : draw.coloring == Coloring::noperspective ? "noperspective"
                                                                           : "smooth";
        if (draw.coloring == Coloring::textured) {
            gl.bind_texture(TextureView(draw.texture.image, draw.texture.wrap, draw.texture.filter), 0);
            gl.UseProgram(program(textured_vertex, textured_fragment));
        } else {
            gl.UseProgram(program(vertex_source(how), fragment_source(how)));
        }
        for (unsigned i = 0; i < 3; ++i) gl.EnableVertexAttribArray(i);
        gl.VertexAttribPointer(0, 4, GL_FLOAT, false, stride, &first->position);
        gl.VertexAttribPointer(1, 4, GL_FLOAT, false, stride, &first->color);
        gl.VertexAttribPointer(2, 2, GL_FLOAT, false, stride, &first->uv);
    }
    const GLenum topology = gl_topology(draw.state.topology);
    if (draw.indices.empty())
        gl.DrawArrays(topology, 0, int(draw.vertices.size()));
    else
        gl.DrawElements(topology, int(draw.indices.size()), GL_UNSIGNED_INT, draw.indices.data());
    gl.DisableClientState(GL_VERTEX_ARRAY);
    gl.DisableClientState(GL_COLOR_ARRAY);
    for (unsigned i = 0; i < 3; ++i) gl.DisableVertexAttribArray(i);
}

Picture Oracle::render(const Scene& scene) {
    value_of(gl_->begin(scene.width, scene.height, scene.clear_color, scene.clear_depth));
    for (const Draw& d : scene.draws) draw(d);
    tool::OpenGlPicture picture = value_of(gl_->end());
    return {std::move(picture.color), std::move(picture.depth)};
}

}  // namespace raster::conformance
