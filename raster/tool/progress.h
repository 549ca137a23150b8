// progress.h: how far the work is, for a person who waits or a program that watches.
#pragma once

#include <chrono>
#include <string>

#include <CLI/App.hpp>

namespace raster::tool {

enum class ProgressMode {
    automatic,  ///< on standard error, if that is a terminal, after a second
    json,       ///< one JSON object a line on standard error, at once
    none,
};
void add_progress_flags(CLI::App& app, ProgressMode& mode);

/// One line that is written over and over, and gone at the end. It has no colours, so NO_COLOR has nothing to turn off.
class Progress {
public:
    explicit Progress(ProgressMode mode);
    ~Progress() { erase(); }
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    /// A stage of the work: "load", "render", "write".
    void begin(const std::string& stage);
    /// The part of the stage that is done, 0 to 1. Calls are cheap.
    void update(double part);
    void end();

private:
    using Clock = std::chrono::steady_clock;

    void show(double part);
    void erase();

    ProgressMode mode_;
    bool visible_ = false;
    std::string stage_;
    double shown_part_ = -1;
    Clock::time_point start_, shown_;
};

}  // namespace raster::tool
