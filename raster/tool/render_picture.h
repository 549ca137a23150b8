// render_picture.h: a loaded model drawn and written, with its planes, frame by frame.
#pragma once

#include <chrono>

#include "outputs.h"
#include "progress.h"
#include "view.h"

#include <raster/bugs/bug.h>
#include <raster/scene/display.h>
#include <raster/scene/render.h>

namespace raster::tool {

/// Seconds since the last lap.
class Timer {
public:
    double lap() {
        const Clock::time_point now = Clock::now();
        const double seconds = std::chrono::duration<double>(now - last_).count();
        last_ = now;
        return seconds;
    }

private:
    using Clock = std::chrono::steady_clock;
    Clock::time_point last_ = Clock::now();
};

struct PictureJob {
    const Model& model;
    RenderOptions options;
    Display display;
    const ViewPlan& view;
    const OutputPlan& outputs;
    bool hash;
    bool quiet;
    std::optional<Bug> bug = {};  ///< to be drawn with, and explained
    double load_time = 0;      ///< seconds, for the summary
    std::size_t warnings = 0;  ///< likewise
};

/// Draws and writes everything that `outputs` lists. Says a summary on standard error.
Status render_pictures(const PictureJob& job, Progress& progress);

}  // namespace raster::tool
