// opengl.cpp: loading libOSMesa, and the few parts of OpenGL that pictures of models need.
#include "opengl.h"

#include <dlfcn.h>

#include <cstdlib>

#include <raster/stages/project.h>

namespace raster::tool {
namespace {

// From the OpenGL specification and GL/osmesa.h, whose functions are called by their types.
enum : unsigned {
    gl_color_and_depth_bits = 0x4100,
    gl_never = 0x0200,
    gl_src_alpha = 0x0302,
    gl_one_minus_src_alpha = 0x0303,
    gl_one = 1,
    gl_front = 0x0404,
    gl_back = 0x0405,
    gl_front_and_back = 0x0408,
    gl_cw = 0x0900,
    gl_ccw = 0x0901,
    gl_cull_face = 0x0b44,
    gl_depth_test = 0x0b71,
    gl_blend = 0x0be2,
    gl_scissor_test = 0x0c11,
    gl_unpack_alignment = 0x0cf5,
    gl_pack_alignment = 0x0d05,
    gl_texture_2d = 0x0de1,
    gl_unsigned_byte = 0x1401,
    gl_unsigned_int = 0x1405,
    gl_depth_component = 0x1902,
    gl_rgba = 0x1908,
    gl_version = 0x1f02,
    gl_renderer = 0x1f01,
    gl_nearest = 0x2600,
    gl_linear = 0x2601,
    gl_texture_mag_filter = 0x2800,
    gl_texture_min_filter = 0x2801,
    gl_texture_wrap_s = 0x2802,
    gl_texture_wrap_t = 0x2803,
    gl_repeat = 0x2901,
    gl_rgba8 = 0x8058,
    gl_clip_plane0 = 0x3000,
    gl_polygon_offset_fill = 0x8037,
    gl_clamp_to_edge = 0x812f,
    gl_mirrored_repeat = 0x8370,
    gl_texture0 = 0x84c0,
    gl_fragment_shader = 0x8b30,
    gl_vertex_shader = 0x8b31,
    gl_link_status = 0x8b82,
};
constexpr int osmesa_y_up = 0x11;

using Function = void (*)();
using CreateContext = void* (*)(unsigned format, int depth, int stencil, int accumulation, void* share);
using DestroyContext = void (*)(void* context);
using MakeCurrent = unsigned char (*)(void* context, void* buffer, unsigned type, int width, int height);
using PixelStore = void (*)(int name, int value);
using GetProcAddress = Function (*)(const char* name);

template <class F>
F find(void* library, const char* name) {
    return reinterpret_cast<F>(::dlsym(library, name));
}

Error trouble(const std::string& what) { return {ErrorKind::input_output, "OSMesa: " + what}; }

const char* const how_to_get_it =
    "OSMesa, Mesa's off-screen OpenGL, is not on this machine (no libOSMesa.so.8 nor .6)\n"
    "  Debian 12, Ubuntu 22.04 and 24.04: apt-get install libosmesa6\n"
    "  Mesa 25.1 and later no longer has it: build an older one with -Dosmesa=true, and give its folder in LD_LIBRARY_PATH";

}  // namespace

Result<std::unique_ptr<OpenGl>> OpenGl::make() {
    // The driver compiles for the processor that it finds. Without FMA, and with one width of registers, it gives the same
    // bits on every machine; without the short cut for textures it filters in float. It reads this when it is loaded.
    for (const auto& [name, value] : {std::pair{"GALLIUM_DRIVER", "llvmpipe"},
                                      {"GALLIUM_OVERRIDE_CPU_CAPS", "sse4.1"},
                                      {"GALLIVM_PERF", "no_aos_sampling"}})
        ::setenv(name, value, 1);
    std::unique_ptr<OpenGl> gl(new OpenGl);
    for (const char* name : {"libOSMesa.so.8", "libOSMesa.so.6", "libOSMesa.so"})
        if (!gl->library_) gl->library_ = ::dlopen(name, RTLD_NOW | RTLD_LOCAL);
    if (!gl->library_) return Error{ErrorKind::input_output, how_to_get_it};

    const auto create = find<CreateContext>(gl->library_, "OSMesaCreateContextExt");
    const auto address = find<GetProcAddress>(gl->library_, "OSMesaGetProcAddress");
    if (!create || !address) return trouble("the library has no OSMesaCreateContextExt");
#define RASTER_OPENGL_LOAD(result, name, arguments)                              \
    gl->name = reinterpret_cast<result(*) arguments>(address("gl" #name)); \
    if (!gl->name) return trouble("the library has no gl" #name);
    RASTER_OPENGL_FUNCTIONS(RASTER_OPENGL_LOAD)
#undef RASTER_OPENGL_LOAD
    gl->context_ = create(gl_rgba, 24, 0, 0, nullptr);
    if (!gl->context_) return trouble("it makes no context");
    return gl;
}

// The library stays loaded: its compiler's exit handlers are still to run.
OpenGl::~OpenGl() {
    const auto destroy = library_ ? find<DestroyContext>(library_, "OSMesaDestroyContext") : nullptr;
    if (destroy && context_) destroy(context_);
}

std::string OpenGl::version() const {
    const auto text = [&](unsigned name) {
        const unsigned char* found = GetString(name);
        return std::string(found ? reinterpret_cast<const char*>(found) : "unknown");
    };
    const std::string full = text(gl_version);
    const auto mesa = full.find("Mesa ");
    return (mesa == std::string::npos ? full : full.substr(mesa)) + ", " + text(gl_renderer);
}

Status OpenGl::begin(int width, int height, glm::vec4 clear_color, float clear_depth) {
    width_ = width, height_ = height;
    buffer_.assign(std::size_t(width) * std::size_t(height), 0);
    const auto make_current = find<MakeCurrent>(library_, "OSMesaMakeCurrent");
    const auto pixel_store = find<PixelStore>(library_, "OSMesaPixelStore");
    if (!make_current || !pixel_store || !make_current(context_, buffer_.data(), gl_unsigned_byte, width, height))
        return trouble("it takes no target of " + std::to_string(width) + "x" + std::to_string(height));
    pixel_store(osmesa_y_up, 0);
    apply({});
    UseProgram(0);
    ClearColor(clear_color.r, clear_color.g, clear_color.b, clear_color.a);
    ClearDepth(double(clear_depth));
    Clear(gl_color_and_depth_bits);
    return Done{};
}

Result<OpenGlPicture> OpenGl::end() {
    Finish();
    OpenGlPicture picture{buffer_, {}};
    std::vector<std::uint32_t> depth(buffer_.size());
    PixelStorei(gl_pack_alignment, 1);
    ReadPixels(0, 0, width_, height_, gl_depth_component, gl_unsigned_int, depth.data());
    if (const unsigned error = GetError()) return trouble("error " + std::to_string(error));
    // OpenGL's rows go up, and its 24 bits of depth are the upper ones of 32.
    for (int y = height_ - 1; y >= 0; --y)
        for (int x = 0; x < width_; ++x)
            picture.depth.push_back(depth[std::size_t(y) * std::size_t(width_) + std::size_t(x)] >> 8);
    return picture;
}

void OpenGl::apply(const State& state) {
    const auto enable = [&](unsigned what, bool on) { on ? Enable(what) : Disable(what); };
    const raster::Viewport v = effective_viewport(state.viewport, width_, height_);
    Viewport(v.x, height_ - (v.y + v.height), v.width, v.height);  // OpenGL's rows go up
    DepthRange(double(v.near_depth), double(v.far_depth));
    FrontFace(state.front_face == FrontFace::counter_clockwise ? gl_ccw : gl_cw);
    enable(gl_cull_face, state.cull != Cull::none);
    CullFace(state.cull == Cull::both ? gl_front_and_back : state.cull == Cull::front ? gl_front : gl_back);
    enable(gl_depth_test, true);
    DepthFunc(gl_never + unsigned(state.depth_compare));  // OpenGL has them in the same order
    DepthMask(state.depth_write);
    ColorMask(state.color_write, state.color_write, state.color_write, state.color_write);
    enable(gl_scissor_test, state.scissor.has_value());
    if (const auto& s = state.scissor) Scissor(s->x, height_ - (s->y + s->height), s->width, s->height);
    enable(gl_polygon_offset_fill, state.depth_offset.is_on());
    PolygonOffset(state.depth_offset.factor, state.depth_offset.units);
    for (unsigned i = 0; i < unsigned(max_user_planes); ++i) {
        enable(gl_clip_plane0 + i, i < state.clip_planes.size());
        if (i >= state.clip_planes.size()) continue;
        const glm::dvec4 coefficients(state.clip_planes[i]);
        ClipPlane(gl_clip_plane0 + i, &coefficients.x);
    }
    enable(gl_blend, state.blend != Blend::off);
    const bool add = state.blend == Blend::additive;
    BlendFunc(add ? gl_one : gl_src_alpha, add ? gl_one : gl_one_minus_src_alpha);
    LineWidth(float(state.line_width));
    PointSize(state.point_size);
}

Result<unsigned> OpenGl::program(const std::string& vertex, const std::string& fragment,
                                 const std::vector<std::string>& attributes) const {
    const unsigned program = CreateProgram();
    std::string messages;
    for (const auto& [kind, source] : {std::pair{gl_vertex_shader, &vertex}, {gl_fragment_shader, &fragment}}) {
        const unsigned shader = CreateShader(kind);
        const char* const text = source->c_str();
        ShaderSource(shader, 1, &text, nullptr);
        CompileShader(shader);
        char log[2000] = "";
        GetShaderInfoLog(shader, sizeof log, nullptr, log);
        messages += log;
        AttachShader(program, shader);
    }
    for (std::size_t i = 0; i < attributes.size(); ++i) BindAttribLocation(program, unsigned(i), attributes[i].c_str());
    LinkProgram(program);
    int good = 0;
    GetProgramiv(program, gl_link_status, &good);
    if (!good) return trouble("it does not compile the shaders: " + messages);
    return program;
}

void OpenGl::bind_texture(const TextureView& texture, unsigned unit) {
    if (textures_.size() <= unit) textures_.resize(unit + 1);
    if (!textures_[unit]) GenTextures(1, &textures_[unit]);
    ActiveTexture(gl_texture0 + unit);
    BindTexture(gl_texture_2d, textures_[unit]);
    // OpenGL's first row is the bottom one.
    const std::size_t width = std::size_t(texture.width), height = std::size_t(texture.height);
    std::vector<std::int32_t> rows;
    for (std::size_t y = height; y-- > 0;)
        rows.insert(rows.end(), texture.texels + y * width, texture.texels + (y + 1) * width);
    const unsigned wrap = texture.wrap == Wrap::repeat  ? gl_repeat
                          : texture.wrap == Wrap::clamp ? gl_clamp_to_edge
                                                        : gl_mirrored_repeat;
    const unsigned filter = texture.filter == Filter::nearest ? gl_nearest : gl_linear;
    for (const auto& [name, value] : {std::pair{gl_texture_wrap_s, wrap},
                                      {gl_texture_wrap_t, wrap},
                                      {gl_texture_min_filter, filter},
                                      {gl_texture_mag_filter, filter}})
        TexParameteri(gl_texture_2d, name, int(value));
    PixelStorei(gl_unpack_alignment, 1);
    TexImage2D(gl_texture_2d, 0, int(gl_rgba8), texture.width, texture.height, 0, gl_rgba, gl_unsigned_byte,
               rows.data());
    ActiveTexture(gl_texture0);
}

}  // namespace raster::tool
