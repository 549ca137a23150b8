// main.cpp: this library against llvmpipe, frame by frame in turn in one process, and a table of both.
//
// llvmpipe reads its thread count once a process, so each configuration runs in a child process of its own.
#include <malloc.h>
#include <sys/resource.h>
#include <tbb/global_control.h>
#include <tbb/info.h>
#include <time.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "compare.h"
#include "end_to_end.h"
#include "limit.h"
#include "ours.h"
#include "rival.h"
#include "scenes.h"

namespace {

using json = nlohmann::json;

/// One, and as many as the machine has.
std::vector<int> default_threads() {
    const int all = tbb::info::default_concurrency();
    return all > 1 ? std::vector<int>{1, all} : std::vector<int>{1};
}

struct Options {
    std::vector<std::string> scenes = bench::scene_names();
    std::vector<std::pair<int, int>> sizes = {{640, 480}, {1920, 1080}};
    std::vector<int> threads = default_threads();
    int warm_up = 3;
    int frames = 15;
    std::string bunny = "/usr/share/glmark2/models/bunny.obj";
    bool as_json = false;
    bool child = false;
    bool alone = false;           ///< ours only, for profiling
    bool check = false;           ///< instead: the pictures only, which have to have equal depths too
    bool first = false;           ///< instead: from nothing to the first frame, each in a process of its own
    std::string raster;           ///< instead: whole processes, this command against the rival's
    std::string picture;          ///< the rival's picture is written here
    bool processor_time = false;  ///< count the time of this process on all processors, where a machine is shared
};

double milliseconds(const Options& options, const auto& work) {
    const clockid_t clock = options.processor_time ? CLOCK_PROCESS_CPUTIME_ID : CLOCK_MONOTONIC;
    timespec start, end;
    clock_gettime(clock, &start);
    work();
    clock_gettime(clock, &end);
    return double(end.tv_sec - start.tv_sec) * 1e3 + double(end.tv_nsec - start.tv_nsec) / 1e6;
}

/// The most memory that this process has had.
std::size_t peak_bytes() {
    rusage usage;
    getrusage(RUSAGE_SELF, &usage);
    return std::size_t(usage.ru_maxrss) * 1024;
}

/// How many pixels something was drawn to.
std::size_t drawn_pixels(const std::vector<std::uint32_t>& depth) {
    return std::size_t(std::ranges::count_if(depth, [](std::uint32_t d) { return d != 0xffffff; }));
}

double median(std::vector<double> v) {
    std::sort(v.begin(), v.end());
    return v.empty() ? 0 : v[v.size() / 2];
}

/// One scene at one size with one number of threads: the pictures compared, then both renderers in turn.
json measure(const Options& options, const std::string& name, int width, int height, int threads) {
    auto scene = bench::make_scene(name, options.bunny);
    if (!scene) return {{"error", scene.error().message}};
    const tbb::global_control used(tbb::global_control::max_allowed_parallelism, std::size_t(threads));
    json row{{"scene", name}, {"what", scene->what}, {"width", width}, {"height", height}, {"threads", threads},
             {"triangles", scene->indices.size() / 3}};
    if (options.first) {
        const auto ours = [&] { bench::Ours(*scene, width, height).frame(); };
        const auto rival = [&] { bench::Rival(*scene, width, height).frame(); };
        row["ms"] = options.alone ? milliseconds(options, ours) : milliseconds(options, rival);
        return row;
    }
    bench::Ours ours(*scene, width, height);
    bench::Limit limit(*scene, width, height);
    const bool alone = options.alone || (!scene->reflectance.empty() && !bench::has_glsl(scene->reflectance));
    std::optional<bench::Rival> rival;
    ours.frame();
    if (!alone) {
        rival.emplace(*scene, width, height);
        if (!rival->ok()) return {{"error", rival->error()}};
        row["rival"] = rival->version();
        rival->frame();
        const bench::Differences d = compare(ours, *rival);
        row["largest_color_difference"] = d.largest_color;
        row["color_pixels_different"] = d.color_pixels;
        row["largest_depth_difference"] = d.largest_depth;
        row["depth_pixels_different"] = d.depth_pixels;
        row["coverage_pixels_different"] = d.coverage_pixels;
        if (const std::string wrong = disagreement(d, *scene, options.check); !wrong.empty()) row["error"] = wrong;
        if (options.check || row.contains("error")) return row;
    }
    row["drawn"] = drawn_pixels(ours.depth());
    if (options.check) return row;
    std::vector<double> our_times, rival_times, limit_times, ratios;
    for (int i = -options.warm_up; i < options.frames; ++i) {
        const double a = milliseconds(options, [&] { ours.frame(); });
        const double b = rival ? milliseconds(options, [&] { rival->frame(); }) : 0;
        const double c = limit.known() ? milliseconds(options, [&] { limit.frame(); }) : 0;
        if (i < 0) continue;
        our_times.push_back(a);
        rival_times.push_back(b);
        limit_times.push_back(c);
        ratios.push_back(b / a);
    }
    row["ours_best"] = std::ranges::min(our_times);
    row["ours_median"] = median(our_times);
    if (limit.known()) {
        row["limit"] = std::ranges::min(limit_times);
        row["over_limit"] = double(row["ours_best"]) / double(row["limit"]);
    }
    if (rival) {
        row["rival_best"] = std::ranges::min(rival_times);
        row["rival_median"] = median(rival_times);
        row["ratio"] = median(ratios);
    } else {
        row["scratch_bytes"] = ours.scratch_bytes();
        row["peak_bytes"] = peak_bytes();
    }
    return row;
}

/// Runs this program again for one configuration and reads the JSON that it prints.
json run_child(const std::string& arguments, int rival_threads, const std::string& environment = "") {
    char self[4096];
    const ssize_t length = readlink("/proc/self/exe", self, sizeof self - 1);
    if (length < 0) return {{"error", "cannot find this program"}};
    self[length] = 0;
    const std::string command =
        environment + " LP_NUM_THREADS=" + std::to_string(rival_threads) + " '" + self + "' --child " + arguments;
    FILE* pipe = popen(command.c_str(), "r");
    if (!pipe) return {{"error", "cannot start a child process"}};
    std::string text;
    char buffer[4096];
    while (const std::size_t n = fread(buffer, 1, sizeof buffer, pipe)) text.append(buffer, n);
    pclose(pipe);
    const json result = json::parse(text, nullptr, false);
    return result.is_discarded() ? json{{"error", "a child process failed"}} : result;
}

/// The time from nothing to the first frame: a target or a context made, shaders compiled, one frame.
json run_first(const std::string& arguments) {
    const json ours = run_child(arguments + " --first --alone", 0);
    json row = run_child(arguments + " --first", 0);
    if (ours.contains("error") || row.contains("error")) return ours.contains("error") ? ours : row;
    row["ours_best"] = ours["ms"];
    row["rival_best"] = row["ms"];
    row["ratio"] = double(row["ms"]) / double(ours["ms"]);
    return row;
}

/// From the model's file to the picture's, whole processes.
json run_end_to_end(const Options& options, const std::string& scene, int width, int height) {
    const std::string size = std::to_string(width) + "x" + std::to_string(height);
    char self[4096] = {};
    if (readlink("/proc/self/exe", self, sizeof self - 1) < 0) return {{"error", "cannot find this program"}};
    json row{{"scene", scene}, {"what", "raster render, bunny, whole process"}, {"width", width}, {"height", height},
             {"threads", options.threads.front()}, {"triangles", 0}};
    row.update(bench::end_to_end(
        "'" + options.raster + "' render '" + options.bunny + "' --size " + size + " --threads " +
            std::to_string(options.threads.front()) + " --quiet -o",
        "LP_NUM_THREADS=" + std::to_string(options.threads.front() == 1 ? 0 : options.threads.front()) + " '" + self +
            "' --child --scene " + scene + " --size " + size + " --bunny '" + options.bunny + "' --picture",
        options.frames));
    return row;
}

/// One line of the table. Pictures are compared twice: in a process where llvmpipe may not use the instructions that
/// multiply and add in one rounding, which give it other depths, and as it is timed. With two threads the rival may use
/// its better setting of one or two raster threads.
json run(const Options& options, const std::string& scene, int width, int height, int threads) {
    const std::string arguments = "--scene " + scene + " --size " + std::to_string(width) + "x" +
                                  std::to_string(height) + " --threads " + std::to_string(threads) + " --frames " +
                                  std::to_string(options.frames) + " --warm-up " + std::to_string(options.warm_up) +
                                  " --bunny '" + options.bunny + "'" + (options.alone ? " --alone" : "") +
                                  (options.processor_time ? " --processor-time" : "");
    if (options.first) return run_first(arguments);
    if (!options.alone) {
        json check = run_child(arguments + " --check", 0, "GALLIUM_OVERRIDE_CPU_CAPS=sse4.1");
        if (check.contains("error")) return check;
    }
    if (threads == 1 || options.alone) return run_child(arguments, 0);
    json best = run_child(arguments, 1);
    if (!best.contains("rival_best")) return best;
    const json other = run_child(arguments, threads);
    if (other.contains("error") || other["rival_best"] < best["rival_best"]) best = other;
    return best;
}

std::vector<std::string> split(const std::string& text, char by) {
    std::vector<std::string> parts(1);
    for (const char c : text) {
        if (c == by) {
            parts.emplace_back();
        } else {
            parts.back() += c;
        }
    }
    return parts;
}

const char* const help =
    "raster_bench: this library against llvmpipe, in turn, from clear to finished pixels\n"
    "  --scene A,B      scenes (default all: clear s1 s2 s3 s4 s4q s5 s6b s6a s6f s7 s7d);\n"
    "                   also fill, one quad, torus:N, of about N triangles, layers:N, of N quads, and `models`:\n"
    "                   m-lambert, m-phong, ..., what each reflectance model costs\n"
    "  --size WxH,...   default 640x480,1920x1080\n"
    "  --threads N,...  default 1 and as many as the machine has\n"
    "  --frames N       counted frames (default 15), after --warm-up N (default 3)\n"
    "  --bunny FILE     the OBJ file of s2, s3, s5, s7d (default: that of Debian's glmark2-data)\n"
    "  --processor-time time on processors, not on the clock: for a shared machine, with one thread\n"
    "  --first          from nothing to the first frame: target or context made, shaders compiled\n"
    "  --end-to-end RASTER  whole processes, from the bunny's file to a PNG file: that command against OSMesa with\n"
    "                   stb_image_write, drawing the scene (s3 is what the command draws)\n"
    "  --alone          ours only, for profiling\n"
    "  --json           figures as JSON\n"
    "Pictures are compared before frames are timed. One that differs gives an error, and the exit code is 1. `limit`\n"
    "is the time of the least work that fills the same pixels, where there is such a thing.\n";

bool parse(int argc, char** argv, Options& options) {
    for (int i = 1; i < argc; ++i) {
        const std::string flag = argv[i];
        if (flag == "--json") {
            options.as_json = true;
        } else if (flag == "--child") {
            options.child = true;
        } else if (flag == "--alone") {
            options.alone = true;
        } else if (flag == "--check") {
            options.check = true;
        } else if (flag == "--first") {
            options.first = true;
        } else if (flag == "--processor-time") {
            options.processor_time = true;
        } else if (i + 1 < argc) {
            const std::string value = argv[++i];
            if (flag == "--scene") {
                options.scenes = value == "models" ? bench::reflectance_scene_names() : split(value, ',');
            } else if (flag == "--size") {
                options.sizes.clear();
                for (const auto& s : split(value, ',')) {
                    int w = 0, h = 0;
                    if (std::sscanf(s.c_str(), "%dx%d", &w, &h) != 2 || w < 1 || h < 1) return false;
                    options.sizes.emplace_back(w, h);
                }
            } else if (flag == "--threads") {
                options.threads.clear();
                for (const auto& t : split(value, ',')) options.threads.push_back(std::max(1, std::atoi(t.c_str())));
            } else if (flag == "--frames") {
                options.frames = std::max(1, std::atoi(value.c_str()));
            } else if (flag == "--warm-up") {
                options.warm_up = std::max(0, std::atoi(value.c_str()));
            } else if (flag == "--end-to-end") {
                options.raster = value;
            } else if (flag == "--picture") {
                options.picture = value;
            } else if (flag == "--bunny") {
                options.bunny = value;
            } else {
                return false;
            }
        } else {
            return false;
        }
    }
    return true;
}

void print_table(const json& rows) {
    std::printf("%-25s %-42s %10s %2s %9s %9s %7s %9s %7s %9s %9s %9s  %s\n", "scene", "what", "size", "th", "ours ms",
                "rival ms", "ratio", "limit ms", "/limit", "Mtri/s", "Mpix/s", "drawn",
                "color max, depth pixels");
    double log_all = 0, log_rest = 0;
    int all = 0, rest = 0;
    for (const json& r : rows) {
        if (r.contains("error")) {
            std::printf("%-25s %dx%d, threads %d: error: %s\n", r["scene"].get<std::string>().c_str(), int(r["width"]),
                        int(r["height"]), int(r["threads"]), r["error"].get<std::string>().c_str());
            continue;
        }
        const double ours = r["ours_best"], ratio = r.value("ratio", 0.0);
        const std::string name = r["scene"];
        const int w = r["width"], h = r["height"];
        std::printf("%-25s %-42s %5dx%-4d %2d %9.2f %9.2f %7.2f ", name.c_str(),
                    r["what"].get<std::string>().c_str(), w, h, int(r["threads"]), ours, r.value("rival_best", 0.0),
                    ratio);
        if (r.contains("limit")) {
            std::printf("%9.2f %7.2f ", double(r["limit"]), double(r["over_limit"]));
        } else {
            std::printf("%9s %7s ", "", "");
        }
        std::printf("%9.2f %9.1f %9.1f  %d, %d\n", double(r["triangles"]) / ours / 1e3, w * h / ours / 1e3,
                    r.value("drawn", 0.0) / ours / 1e3, r.value("largest_color_difference", 0),
                    r.value("depth_pixels_different", 0));
        if (ratio > 0) {
            log_all += std::log(ratio), ++all;
            if (name.rfind("s6", 0) != 0) log_rest += std::log(ratio), ++rest;
        }
    }
    if (all && rest)
        std::printf("geometric mean of the ratios: %.2f, without s6: %.2f\n", std::exp(log_all / all),
                    std::exp(log_rest / rest));
}

}  // namespace

int main(int argc, char** argv) {
    Options options;
    if (!parse(argc, argv, options)) {
        std::fputs(help, stderr);
        return 2;
    }
    // llvmpipe frees its scene every frame; with the heap kept it is up to 45 % faster, which is fair to it.
    mallopt(M_MMAP_THRESHOLD, 1 << 30);
    mallopt(M_TRIM_THRESHOLD, 1 << 30);
    if (options.child) {
        const auto [width, height] = options.sizes.front();
        if (!options.picture.empty()) {
            const auto scene = bench::make_scene(options.scenes.front(), options.bunny);
            return scene && bench::write_rival_picture(*scene, width, height, options.picture) ? 0 : 1;
        }
        std::printf("%s\n",
                    measure(options, options.scenes.front(), width, height, options.threads.front()).dump().c_str());
        return 0;
    }
    bool failed = false;
    json rows = json::array();
    for (const auto& [width, height] : options.sizes)
        for (const int threads : options.threads)
            for (const std::string& scene : options.scenes) {
                Options here = options;
                here.threads = {threads};
                json row = options.raster.empty() ? run(options, scene, width, height, threads)
                                                  : run_end_to_end(here, scene, width, height);
                if (row.contains("error"))
                    row.update({{"scene", scene}, {"width", width}, {"height", height}, {"threads", threads}});
                failed = failed || row.contains("error");
                rows.push_back(std::move(row));
                if (!options.as_json) std::fprintf(stderr, "."), std::fflush(stderr);
            }
    if (!options.as_json) std::fprintf(stderr, "\n");
    if (options.as_json) {
        std::printf("%s\n", rows.dump(2).c_str());
    } else {
        print_table(rows);
    }
    return failed ? 1 : 0;
}
