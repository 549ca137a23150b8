// render_picture.cpp: draw, write, count.
#include "render_picture.h"

#include <cstdio>
#include <optional>

#include <raster/image/file.h>

#include "bug.h"
#include "hash.h"
#include "planes.h"
#include "report.h"

namespace raster::tool {
namespace {

ImageF float_picture_of(const Target& target) {
    ImageF image(target.width(), target.height(), 3);
    float* out = image.samples.data();
    for (const glm::vec4& color : target.color_float()) {
        for (int c = 0; c < 3; ++c) *out++ = color[c];
    }
    return image;
}

std::string milliseconds(double seconds) {
    char text[32];
    std::snprintf(text, sizeof text, "%.*f ms", seconds < 0.01 ? 1 : 0, seconds * 1000);
    return text;
}

class Pictures {
public:
    Pictures(const PictureJob& job, Progress& progress) : job_(job), progress_(progress) {}

    Status run() {
        const OutputPlan& outputs = job_.outputs;
        const int frames = std::max(outputs.frames, 1);
        progress_.begin("render");
        for (int frame = 0; frame < frames; ++frame) {
            const Result<View> view = outputs.frames > 0 ? job_.view.turned_view_of(job_.model, frame, frames)
                                                         : job_.view.view_of(job_.model);
            if (!view) return view.error();
            if (const Status status = draw_frame(frame, *view); !status) return status;
            progress_.update(double(frame + 1) / frames);
        }
        progress_.end();
        return Done{};
    }

    void say_summary() const {
        const OutputPlan& outputs = job_.outputs;
        std::string line = outputs.picture == "-" ? "standard output" : outputs.picture_path(0);
        if (outputs.frames > 1) line += " to " + outputs.picture_path(outputs.frames - 1);
        line +=
            ": " + to_text(job_.view.size()) + ", " + counted(std::int64_t(job_.model.triangle_count()), "triangle");
        line += outputs.frames > 0 ? " a picture: " : ": ";
        const Style style = job_.options.style;
        line += with_separators(counts_.drawn) +
                (style == Style::wireframe ? " edges"
                 : style == Style::points  ? " corners"
                                           : "") +
                " drawn, " + with_separators(counts_.culled) + " culled, " + with_separators(counts_.outside) +
                " outside the view";
        if (counts_.zero_area > 0) line += ", " + with_separators(counts_.zero_area) + " too small for the pixel grid";
        if (counts_.not_finite > 0) line += ", " + with_separators(counts_.not_finite) + " not finite";
        if (outputs.frames > 1) line += " in all";
        say(line);
        for (const PlaneChoice& plane : outputs.planes) say(outputs.plane_path(0, plane));
        if (!outputs.camera_json.empty() && outputs.camera_json != "-") say(outputs.camera_json);
        if (job_.bug) say(bug_words_);
        if (counts_.drawn == 0) say("warning: nothing of the model is in view");
        std::string times = "load " + milliseconds(job_.load_time) + ", render " + milliseconds(render_time_) +
                            ", write " + milliseconds(write_time_);
        if (job_.warnings > 0) times += "; " + counted(std::int64_t(job_.warnings), "warning");
        say(times);
    }

private:
    Status draw_frame(int frame, const View& view) {
        const OutputPlan& outputs = job_.outputs;
        const bool floats = outputs.format == OutputFormat::pfm;
        timer_.lap();
        const Display& display = job_.display;
        const bool as_light = floats || !display.is_plain();
        Target target(view.size.width, view.size.height, as_light ? ColorFormat::rgba_float : ColorFormat::rgba8);
        RenderOptions options = job_.options;
        options.background = light_for(options.background, display);
        counts_ += job_.bug ? render_with_bug(*job_.bug, target, job_.model, view, options)
                            : render(target, job_.model, view.matrices, options);
        std::optional<Target> shown;
        if (floats && display.exposure != 0) expose(target, display.exposure);
        if (!floats && as_light) shown = displayed(target, display);
        const Target& picture = shown ? *shown : target;
        render_time_ += timer_.lap();

        const std::string path = outputs.picture_path(frame);
        const bool with_alpha = job_.options.background.a < 1.0f;
        if (const Status status = floats ? write_image(path, float_picture_of(picture))
                                         : write_image(path, PackedImage{picture.width(), picture.height(),
                                                                         picture.color8(), with_alpha});
            !status)
            return status;
        if (const Status status = write_planes(frame, view, target); !status) return status;
        if (job_.bug) {
            Result<std::string> words = write_bug_difference(*job_.bug, target, job_.model, view, options,
                                                             beside(path, ".difference.png"));
            if (!words) return words.error();
            bug_words_ = std::move(*words);
        }
        if (frame == 0 && !outputs.camera_json.empty()) {
            const std::string text = camera_json(view);
            if (const Status status = write_file(outputs.camera_json, std::as_bytes(std::span(text))); !status)
                return status;
        }
        write_time_ += timer_.lap();
        if (!job_.hash) return Done{};
        const std::string line = content_hash(picture) + "  " + path;
        if (is_standard_output(path) || is_standard_output(outputs.camera_json)) {
            say(line);
            return Done{};
        }
        return print(line + "\n");
    }

    Status write_planes(int frame, const View& view, const Target& target) {
        PlaneRenderer planes(job_.model, view, job_.options);
        for (const PlaneChoice& plane : job_.outputs.planes) {
            const std::string path = job_.outputs.plane_path(frame, plane);
            const Status status = plane.as_floats ? write_image(path, planes.floats(plane, target))
                                                  : write_image(path, planes.colors(plane, target));
            if (!status) return status;
        }
        return Done{};
    }

    const PictureJob& job_;
    Progress& progress_;
    DrawCounts counts_;
    Timer timer_;
    std::string bug_words_;
    double render_time_ = 0, write_time_ = 0;
};

}  // namespace

Status render_pictures(const PictureJob& job, Progress& progress) {
    Pictures pictures(job, progress);
    const Status status = pictures.run();
    if (status && !job.quiet) pictures.say_summary();
    return status;
}

}  // namespace raster::tool
