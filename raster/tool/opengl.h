// opengl.h: Mesa's off-screen OpenGL, found while the program runs: nothing of it is needed to build or to start.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include <raster/result.h>
#include <raster/shading/texture.h>
#include <raster/state.h>

namespace raster::tool {

/// The functions of OpenGL that are called here: X(result, name without gl, arguments).
#define RASTER_OPENGL_FUNCTIONS(X)                                                                     \
    X(const unsigned char*, GetString, (unsigned name))                                                \
    X(unsigned, GetError, ())                                                                          \
    X(void, Enable, (unsigned what))                                                                   \
    X(void, Disable, (unsigned what))                                                                  \
    X(void, Viewport, (int x, int y, int width, int height))                                           \
    X(void, DepthRange, (double near_depth, double far_depth))                                         \
    X(void, Scissor, (int x, int y, int width, int height))                                            \
    X(void, ClipPlane, (unsigned plane, const double* coefficients))                                   \
    X(void, PolygonOffset, (float factor, float units))                                                \
    X(void, ColorMask, (unsigned char r, unsigned char g, unsigned char b, unsigned char a))           \
    X(void, FrontFace, (unsigned mode))                                                                \
    X(void, CullFace, (unsigned mode))                                                                 \
    X(void, DepthFunc, (unsigned compare))                                                             \
    X(void, DepthMask, (unsigned char on))                                                             \
    X(void, BlendFunc, (unsigned source, unsigned destination))                                        \
    X(void, LineWidth, (float width))                                                                  \
    X(void, PointSize, (float size))                                                                   \
    X(void, ClearColor, (float r, float g, float b, float a))                                          \
    X(void, ClearDepth, (double depth))                                                                \
    X(void, Clear, (unsigned mask))                                                                    \
    X(void, Finish, ())                                                                                \
    X(void, PixelStorei, (unsigned name, int value))                                                   \
    X(void, ReadPixels, (int x, int y, int w, int h, unsigned format, unsigned type, void* out))       \
    X(unsigned, CreateShader, (unsigned kind))                                                         \
    X(void, ShaderSource, (unsigned shader, int count, const char* const* text, const int* lengths))   \
    X(void, CompileShader, (unsigned shader))                                                          \
    X(void, GetShaderInfoLog, (unsigned shader, int size, int* length, char* text))                    \
    X(unsigned, CreateProgram, ())                                                                     \
    X(void, AttachShader, (unsigned program, unsigned shader))                                         \
    X(void, BindAttribLocation, (unsigned program, unsigned place, const char* name))                  \
    X(void, LinkProgram, (unsigned program))                                                           \
    X(void, GetProgramiv, (unsigned program, unsigned name, int* value))                               \
    X(void, UseProgram, (unsigned program))                                                            \
    X(int, GetUniformLocation, (unsigned program, const char* name))                                   \
    X(void, Uniform1i, (int place, int v))                                                             \
    X(void, Uniform1f, (int place, float v))                                                           \
    X(void, Uniform3fv, (int place, int count, const float* v))                                        \
    X(void, Uniform4fv, (int place, int count, const float* v))                                        \
    X(void, UniformMatrix3fv, (int place, int count, unsigned char transpose, const float* m))         \
    X(void, UniformMatrix4fv, (int place, int count, unsigned char transpose, const float* m))         \
    X(void, EnableVertexAttribArray, (unsigned place))                                                 \
    X(void, VertexAttribPointer,                                                                       \
      (unsigned place, int size, unsigned type, unsigned char normalized, int stride, const void* at)) \
    X(void, DisableVertexAttribArray, (unsigned place))                                                \
    X(void, EnableClientState, (unsigned array))                                                       \
    X(void, DisableClientState, (unsigned array))                                                      \
    X(void, VertexPointer, (int size, unsigned type, int stride, const void* at))                      \
    X(void, ColorPointer, (int size, unsigned type, int stride, const void* at))                       \
    X(void, DrawArrays, (unsigned mode, int first, int count))                                         \
    X(void, DrawElements, (unsigned mode, int count, unsigned type, const void* indices))              \
    X(void, ActiveTexture, (unsigned unit))                                                            \
    X(void, GenTextures, (int count, unsigned* names))                                                 \
    X(void, BindTexture, (unsigned target, unsigned name))                                             \
    X(void, TexParameteri, (unsigned target, unsigned name, int value))                                \
    X(void, TexImage2D,                                                                                \
      (unsigned target, int level, int inner, int w, int h, int border, unsigned format, unsigned type, const void* data))

/// What one draw of a picture left behind, rows from top to bottom: r | g << 8 | b << 16 | a << 24, depth in 24 bits.
struct OpenGlPicture {
    std::vector<std::uint32_t> color, depth;
};

/// One context. Members are OpenGL's functions; valid between begin and end.
class OpenGl {
public:
    /// Looks for libOSMesa and makes a context. Error: input_output, with what to install.
    static Result<std::unique_ptr<OpenGl>> make();
    ~OpenGl();
    OpenGl(const OpenGl&) = delete;

    /// Makes a target of this size current and clears it.
    Status begin(int width, int height, glm::vec4 clear_color, float clear_depth = 1);
    Result<OpenGlPicture> end();

    /// What it calls itself, as "Mesa 22.3.6, llvmpipe (LLVM 15.0.6, 128 bits)"; after begin.
    std::string version() const;

    /// A program from GLSL sources; attributes 0, 1, ... have these names. The error is the compiler's message.
    Result<unsigned> program(const std::string& vertex, const std::string& fragment,
                             const std::vector<std::string>& attributes) const;
    void bind_texture(const TextureView& texture, unsigned unit);
    /// Sets all that a State says but its topology.
    void apply(const State& state);

#define RASTER_OPENGL_MEMBER(result, name, arguments) result(*name) arguments = nullptr;
    RASTER_OPENGL_FUNCTIONS(RASTER_OPENGL_MEMBER)
#undef RASTER_OPENGL_MEMBER

private:
    OpenGl() = default;

    void* library_ = nullptr;
    void* context_ = nullptr;
    int width_ = 0, height_ = 0;
    std::vector<std::uint32_t> buffer_;
    std::vector<unsigned> textures_;
};

}  // namespace raster::tool
