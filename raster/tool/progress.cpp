// progress.cpp: progress lines on standard error.
#include "progress.h"

#include <unistd.h>

#include <algorithm>
#include <cstdio>

#include "flags.h"
#include "report.h"

namespace raster::tool {
namespace {

constexpr std::chrono::milliseconds quiet_time(1000), interval(100);
constexpr int bar_width = 30, line_width = 56;

constexpr Choices<ProgressMode, 3> modes = {
    {{"auto", ProgressMode::automatic}, {"json", ProgressMode::json}, {"none", ProgressMode::none}}};

void write_text(const std::string& text) { (void)!::write(STDERR_FILENO, text.data(), text.size()); }

}  // namespace

void add_progress_flags(CLI::App& app, ProgressMode& mode) {
    add_choice(app, "--progress", mode, modes,
               "Progress on standard error: on a terminal once a second has passed; or one JSON object a line,"
               " {\"stage\":\"load\",\"done\":0.25}; or none. [auto]")
        ->group("Other flags");
}

Progress::Progress(ProgressMode mode) : mode_(mode), start_(Clock::now()) {
    if (mode_ == ProgressMode::automatic && ::isatty(STDERR_FILENO) == 0) mode_ = ProgressMode::none;
}

void Progress::begin(const std::string& stage) {
    stage_ = stage;
    shown_part_ = -1;
    if (mode_ == ProgressMode::json) show(0);
}

void Progress::update(double part) {
    if (mode_ == ProgressMode::none) return;
    const Clock::time_point now = Clock::now();
    if (now - shown_ < interval || (mode_ == ProgressMode::automatic && now - start_ < quiet_time)) return;
    show(std::clamp(part, 0.0, 1.0));
}

void Progress::end() {
    if (mode_ == ProgressMode::json && shown_part_ < 1) show(1);
    erase();
}

void Progress::show(double part) {
    shown_ = Clock::now();
    shown_part_ = part;
    char line[128];
    if (mode_ == ProgressMode::json) {
        std::snprintf(line, sizeof line, "{\"stage\":\"%s\",\"done\":%.3f}", stage_.c_str(), part);
        say(line);
        return;
    }
    std::string bar(std::size_t(part * bar_width), '#');
    bar.resize(std::size_t(bar_width), '.');
    std::snprintf(line, sizeof line, "\r%-8.8s [%s] %3d %%", stage_.c_str(), bar.c_str(), int(part * 100));
    write_text(line);
    visible_ = true;
}

void Progress::erase() {
    if (visible_) write_text("\r" + std::string(std::size_t(line_width), ' ') + "\r");
    visible_ = false;
}

}  // namespace raster::tool
