// outputs.cpp: names of files, and what speaks against writing them.
#include "outputs.h"

#include <algorithm>
#include <filesystem>
#include <set>

#include <raster/image/file.h>

#include "parse.h"

namespace raster::tool {
namespace {

namespace fs = std::filesystem;

/// Whether two names lead to one file, by whatever links.
bool same_file(const std::string& a, const std::string& b) {
    std::error_code ignored;
    return fs::equivalent(a, b, ignored);
}

/// A name by which two spellings of a path, which need not exist, can be compared.
std::string canonical(const std::string& path) {
    std::error_code error;
    const fs::path name = fs::weakly_canonical(path, error);
    return error ? path : name.string();
}

}  // namespace

bool is_standard_output(const std::string& path) { return path == "-" || path == "/dev/stdout"; }

std::string default_picture_path(const std::string& model) {
    // shape:NAME:KEY=VALUE is named like its shape.
    const bool is_shape = model.starts_with("shape:");
    const std::string stem = is_shape ? model.substr(6, model.find(':', 6) - 6) : fs::path(model).stem().string();
    return (stem.empty() || stem == "." || stem == ".." ? "picture" : stem) + ".png";
}

std::string beside(const std::string& path, const std::string& suffix) {
    const fs::path p(path);
    return (p.parent_path() / p.stem()).string() + suffix;
}

std::string OutputPlan::picture_path(int frame) const {
    if (frames == 0) return picture;
    std::string number = std::to_string(frame);
    const std::size_t digits = std::max<std::size_t>(3, std::to_string(frames - 1).size());
    number.insert(0, digits - number.size(), '0');
    return beside(picture, "." + number + fs::path(picture).extension().string());
}

std::vector<std::string> OutputPlan::paths() const {
    std::vector<std::string> all;
    for (int frame = 0; frame < std::max(frames, 1); ++frame) {
        all.push_back(picture_path(frame));
        for (const PlaneChoice& plane : planes) all.push_back(plane_path(frame, plane));
    }
    if (!camera_json.empty()) all.push_back(camera_json);
    return all;
}

Status check_no_input(const std::vector<std::string>& outputs, const std::vector<std::string>& inputs) {
    for (const std::string& output : outputs)
        for (const std::string& input : inputs)
            if (!input.empty() && same_file(output, input))
                return usage(output + ": would be written over, and is read too");
    return Done{};
}

Status check(OutputPlan& plan, const std::vector<std::string>& inputs) {
    // Redirected to a file, /dev/stdout looks like a file without an extension.
    if (is_standard_output(plan.picture)) plan.picture = "-";
    if (is_standard_output(plan.camera_json)) plan.camera_json = "-";
    const Result<OutputFormat> format = output_format(plan.picture, OutputFormat::png);
    // A folder is no wrong extension: the system has words for it.
    std::error_code ignored;
    if (!format && fs::is_directory(plan.picture, ignored)) {
        if (const Status status = check_writable(plan.picture); !status) return status;
    }
    if (!format || *format == OutputFormat::pgm)
        return usage("--output: " + in_quotes(plan.picture) +
                     " must end in .png, .ppm or .pfm, or be - for standard output");
    plan.format = *format;

    if (!plan.camera_json.empty() && plan.camera_json != "-" && !plan.camera_json.ends_with(".json"))
        return usage("--camera-json-out: " + in_quotes(plan.camera_json) +
                     " must end in .json, or be - for standard output");
    const bool several = plan.frames > 0 || !plan.planes.empty();
    if (is_standard_output(plan.picture) && several)
        return usage("--output: several pictures cannot go to standard output; give a file name");
    // The frames of a turntable are made beside the name that is given.
    if (fs::status(plan.picture, ignored).type() == fs::file_type::character && several)
        return usage("--output: several pictures cannot go to " + plan.picture);

    const std::vector<std::string> paths = plan.paths();
    std::set<std::string> seen;
    for (const std::string& path : paths) {
        const std::string name = is_standard_output(path) ? "-" : canonical(path);
        if (!seen.insert(name).second) return usage(path + ": two outputs cannot have one name");
    }
    if (const Status status = check_no_input(paths, inputs); !status) return status;
    for (const std::string& path : paths)
        if (const Status status = check_writable(path); !status) return status;
    return Done{};
}

std::vector<std::string> texture_paths(const std::string& model_path, const Model& model) {
    std::vector<std::string> paths;
    const fs::path folder = fs::path(model_path).parent_path();
    for (const Texture& texture : model.textures) {
        std::string name = texture.name;
        std::ranges::replace(name, '\\', '/');
        paths.push_back((folder / name).string());
    }
    return paths;
}

}  // namespace raster::tool
