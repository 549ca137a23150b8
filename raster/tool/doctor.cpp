// doctor.cpp: `raster doctor`: how this program was built and what it finds on this machine.
#include <dlfcn.h>

#include <filesystem>
#include <string>
#include <thread>
#include <vector>
#include <nlohmann/json.hpp>

#include <CLI/Version.hpp>
#include <raster/config.h>

#if !defined(RASTER_NO_THREADS)
#include <tbb/info.h>
#include <tbb/version.h>
#endif

#include "commands.h"
#include "flags.h"
#include "report.h"

namespace raster::tool {
namespace {

std::string compiler() {
#if defined(__clang__)
    return "clang " __clang_version__;
#elif defined(__GNUC__)
    return "g++ " __VERSION__;
#else
    return "unknown";
#endif
}

/// What the compiler was allowed to use.
std::string compiled_instructions() {
    std::string list;
    const auto add = [&](const char* name) { list += (list.empty() ? "" : " ") + std::string(name); };
#if defined(__SSE2__)
    add("SSE2");
#endif
#if defined(__SSE4_1__)
    add("SSE4.1");
#endif
#if defined(__AVX__)
    add("AVX");
#endif
#if defined(__AVX2__)
    add("AVX2");
#endif
#if defined(__FMA__)
    add("FMA");
#endif
#if defined(__AVX512F__)
    add("AVX-512F");
#endif
#if defined(__ARM_NEON)
    add("NEON");
#endif
    return list.empty() ? "none" : list;
}

/// What the processor has.
std::string available_instructions() {
#if defined(__x86_64__) || defined(__i386__)
    std::string list;
    const auto add = [&](bool has, const char* name) {
        if (has) list += (list.empty() ? "" : " ") + std::string(name);
    };
    __builtin_cpu_init();
    add(__builtin_cpu_supports("sse2"), "SSE2");
    add(__builtin_cpu_supports("sse4.1"), "SSE4.1");
    add(__builtin_cpu_supports("avx"), "AVX");
    add(__builtin_cpu_supports("avx2"), "AVX2");
    add(__builtin_cpu_supports("fma"), "FMA");
    add(__builtin_cpu_supports("avx512f"), "AVX-512F");
    return list;
#else
    return "not known for this kind of processor";
#endif
}

bool could_use_avx2() {
#if (defined(__x86_64__) || defined(__i386__)) && !defined(__AVX2__)
    __builtin_cpu_init();
    return __builtin_cpu_supports("avx2");
#else
    return false;
#endif
}

std::string threads() {
    const std::string processors = std::to_string(std::thread::hardware_concurrency()) + " processors";
#if defined(RASTER_NO_THREADS)
    return "1, built without threads; " + processors;
#else
    return std::to_string(tbb::info::default_concurrency()) + "; " + processors + "; oneTBB " + TBB_runtime_version();
#endif
}

/// OSMesa is the reference that pictures are compared with; nothing here needs it. It is only looked for.
std::string osmesa() {
    for (const char* name : {"libOSMesa.so.8", "libOSMesa.so.6", "libOSMesa.so"}) {
        void* library = ::dlopen(name, RTLD_LAZY | RTLD_LOCAL);
        if (!library) continue;
        // GL/osmesa.h's functions, by their types: the header need not be installed.
        using Create = void* (*)(unsigned format, int depth, int stencil, int accumulation, void* share);
        using Make = unsigned char (*)(void* context, void* buffer, unsigned type, int width, int height);
        using Address = void (*(*)(const char* name))();
        using GetString = const unsigned char* (*)(unsigned name);
        const auto create = reinterpret_cast<Create>(::dlsym(library, "OSMesaCreateContextExt"));
        const auto make_current = reinterpret_cast<Make>(::dlsym(library, "OSMesaMakeCurrent"));
        const auto address = reinterpret_cast<Address>(::dlsym(library, "OSMesaGetProcAddress"));
        constexpr unsigned gl_rgba = 0x1908, gl_unsigned_byte = 0x1401, gl_version = 0x1f02;
        static unsigned char pixels[64 * 64 * 4];
        void* context = create && make_current && address ? create(gl_rgba, 24, 0, 0, nullptr) : nullptr;
        if (!context || !make_current(context, pixels, gl_unsigned_byte, 64, 64))
            return std::string(name) + " is here, but makes no context";
        const auto get_string = reinterpret_cast<GetString>(address("glGetString"));
        const unsigned char* version = get_string ? get_string(gl_version) : nullptr;
        return std::string(name) + ", " + (version ? reinterpret_cast<const char*>(version) : "unknown version");
    }
    return "not found; only comparing with it needs it (Debian: libosmesa6)";
}

std::string libraries() {
    std::string list = "GLM " + std::to_string(GLM_VERSION_MAJOR) + "." + std::to_string(GLM_VERSION_MINOR) + "." +
                       std::to_string(GLM_VERSION_PATCH) + "." + std::to_string(GLM_VERSION_REVISION);
    list += ", CLI11 " CLI11_VERSION;
    list += ", JSON for Modern C++ " + std::to_string(NLOHMANN_JSON_VERSION_MAJOR) + "." +
            std::to_string(NLOHMANN_JSON_VERSION_MINOR) + "." + std::to_string(NLOHMANN_JSON_VERSION_PATCH);
    return list;
}

/// Models that Debian packages install.
std::string sample_models() {
    constexpr std::pair<const char*, const char*> models[] = {
        {"/usr/share/glmark2/models/bunny.obj", "glmark2-data"},
        {"/usr/share/assimp/models/OBJ/spider.obj", "assimp-testmodels"},
        {"/usr/share/doc/embree3/models/cornell_box.obj", "embree-tools"}};
    std::string list;
    for (const auto& [path, package] : models) {
        std::error_code ignored;
        if (!list.empty()) list += "\n                 ";
        list += std::filesystem::exists(path, ignored) ? path : "not installed: " + std::string(package);
    }
    return list;
}

Result<int> run_doctor() {
    std::string out = "raster " RASTER_VERSION "\n";
    const auto row = [&](const char* name, const std::string& text) {
        std::string left = "  " + std::string(name);
        left.resize(17, ' ');
        out += left + text + "\n";
    };
    row("compiler", compiler());
    row("build type", RASTER_BUILD_TYPE);
    row("compiled for", compiled_instructions());
    row("processor has", available_instructions());
    row("lanes", std::to_string(native_lanes) + " floats at once");
    row("threads", threads());
    row("libraries", libraries());
    row("OSMesa", osmesa());
    row("models to try", sample_models());
    if (std::string_view(RASTER_BUILD_TYPE) == "Debug")
        out += "note: this is a debug build, which is many times slower\n";
    if (could_use_avx2())
        out +=
            "note: built with -DRASTER_MARCH=x86-64-v3 this would draw 8 pixels at once here; the pictures are the "
            "same\n";
    const Status printed = print(out);
    return printed ? Result<int>(exit_done) : printed.error();
}

}  // namespace

Run add_doctor(CLI::App&) { return run_doctor; }

}  // namespace raster::tool
