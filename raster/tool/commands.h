// commands.h: what the command can do. A new command is one file and one line here.
#pragma once

#include <functional>

#include <raster/result.h>

namespace CLI {
class App;
}

namespace raster::tool {

/// A command after its flags are read. It gives the exit code, or an error that becomes one.
using Run = std::function<Result<int>()>;

/// Adds the flags and gives what is to be done with them.
using AddFlags = Run (*)(CLI::App& app);

Run add_render(CLI::App& app);
Run add_demo(CLI::App& app);
Run add_step(CLI::App& app);
Run add_info(CLI::App& app);
Run add_pixel(CLI::App& app);
Run add_trace(CLI::App& app);
Run add_brdf(CLI::App& app);
Run add_compare(CLI::App& app);
Run add_diff(CLI::App& app);
Run add_approve(CLI::App& app);
Run add_doctor(CLI::App& app);

struct Command {
    const char* name;
    const char* summary;
    AddFlags add;
};
inline constexpr Command commands[] = {
    {"render", "Draws a picture of a model.", add_render},
    {"demo", "Draws a teapot; needs no file.", add_demo},
    {"step", "Writes a page in which one steps through the draw, from vertex to pixel.", add_step},
    {"info", "Tells what is in a model file, and the camera that frames it.", add_info},
    {"pixel", "Tells why a pixel has its colour.", add_pixel},
    {"trace", "Writes down every step that makes a picture.", add_trace},
    {"brdf", "Tabulates what a material reflects, and compresses such tables.", add_brdf},
    {"compare", "Draws a model by Mesa's OpenGL too, and tells how far the pictures are apart.", add_compare},
    {"diff", "Tells whether a picture is the one it should be, and shows how it is not.", add_diff},
    {"approve", "Makes the actual pictures of a failed comparison the expected ones.", add_approve},
    {"doctor", "Tells how this program was built and what it finds on this machine.", add_doctor},
};

}  // namespace raster::tool
