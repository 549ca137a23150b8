// obj.cpp: loading an OBJ file, step by step.
#include <raster/scene/obj.h>

#include <new>
#include <stdexcept>

#include <raster/image/file.h>
#include <raster/scene/obj_build.h>
#include <raster/scene/obj_lines.h>
#include <raster/scene/obj_parse.h>
#include <raster/scene/obj_texture.h>

namespace raster {
namespace {

using namespace obj;

/// Why there is nothing to draw.
std::string no_geometry(const LoadReport& report, bool is_empty_file) {
    const auto counted = [](std::size_t n, const char* what) {
        return std::to_string(n) + " " + what + (n == 1 ? "" : "s");
    };
    std::string text = "no drawable geometry: ";
    if (is_empty_file) return text + "the file is empty";
    if (report.faces > 0) {
        text +=
            report.faces == 1 ? "its only face was dropped" : "all " + counted(report.faces, "face") + " were dropped";
        for (const LoadWarning& warning : report.warnings) {
            constexpr std::string_view dropped = "face dropped: ";
            if (warning.text.starts_with(dropped))
                return text + ": " + warning.text.substr(dropped.size()) + " (line " + std::to_string(warning.line) +
                       ")";
        }
        return text;
    }
    text += "no faces";
    if (report.lines + report.points > 0)
        return text + ", only " + counted(report.lines, "line") + " and " + counted(report.points, "point");
    return text + (report.positions == 0 ? " and no vertices; is this an OBJ file?" : "");
}

/// From names to materials. A name that no file defines, and none at all, is the default material.
void assign_materials(const ObjData& data, std::string_view file, Model& model, Log& log) {
    for (const MaterialEntry& entry : data.material_library.entries) model.materials.push_back(entry.material);
    std::vector<bool> is_reported(data.material_names.size());
    for (Part& part : model.parts) {
        if (part.material < 0) continue;
        const auto name = std::size_t(part.material);
        const auto found = data.material_library.index.find(data.material_names[name]);
        part.material = found == data.material_library.index.end() ? -1 : found->second;
        if (part.material >= 0 || is_reported[name]) continue;
        is_reported[name] = true;
        log.warn({file, data.material_lines[name]},
                 "unknown material " + in_quotes(data.material_names[name]) + "; the default takes its place");
    }
}

void load_textures(const ObjData& data, const Finder* finder, const ObjOptions& options, Model& model, Log& log) {
    std::vector<bool> is_used(model.materials.size());
    for (const Part& part : model.parts)
        if (part.material >= 0) is_used[std::size_t(part.material)] = true;
    Textures textures(finder, options, model, log);
    for (std::size_t m = 0; m < is_used.size(); ++m)
        if (is_used[m]) textures.load(data.material_library.entries[m], model.materials[m]);
}

/// The steps, in order. After an error the log has it, and the rest does not matter. `free_text` is called when
/// the text is not needed any more.
Model load(std::string_view text, std::string_view file, const Finder* finder, const ObjOptions& options, Log& log,
           const std::function<void()>& free_text) {
    const bool is_empty = text.empty();
    if (is_utf16(text)) log.fail({file}, "no drawable geometry: this is UTF-16 text; save it as UTF-8");
    if (log.failed()) return {};
    ObjData data = parse_statements(text, file, finder, options, log);
    free_text();
    if (log.failed()) return {};
    Model model = build_model(data, file, options, log);
    if (!log.failed() && model.indices.empty()) log.fail({file}, no_geometry(log.report(), is_empty));
    if (!log.failed()) assign_materials(data, file, model, log);
    if (!log.failed() && options.load_textures) load_textures(data, finder, options, model, log);
    return model;
}

Result<Model> load_checked(std::string_view text, const std::string& name, const std::optional<std::string>& folder,
                           const ObjOptions& options, LoadReport& report, const std::function<void()>& free_text) {
    report = {};
    if (options.crease_angle && !(*options.crease_angle >= 0 && *options.crease_angle <= 180))
        return Error{ErrorKind::usage,
                     "crease angle " + std::to_string(*options.crease_angle) + ": 0 to 180 degrees are possible"};
    try {
        Log log(report, options.strict);
        const std::optional<Finder> finder =
            folder ? std::optional<Finder>(std::in_place, *folder, options.allow_outside) : std::nullopt;
        Model model = load(text, name, finder ? &*finder : nullptr, options, log, free_text);
        if (log.failed()) return log.error();
        if (options.progress) options.progress(1.0);
        return model;
    } catch (const std::bad_alloc&) {
        return Error{ErrorKind::input_output, name + ": not enough memory"};
    } catch (const std::length_error&) {
        return Error{ErrorKind::input_output, name + ": not enough memory"};
    }
}

std::string_view as_text(std::span<const std::byte> bytes) {
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

}  // namespace

Result<Model> load_obj(const std::string& path, const ObjOptions& options, LoadReport& report) {
    Result<Bytes> bytes = read_file(path, options.max_file_bytes);
    if (!bytes) return bytes.error();
    return load_checked(as_text(*bytes), path, folder_of(path), options, report, [&] { Bytes().swap(*bytes); });
}

Result<Model> parse_obj(std::span<const std::byte> bytes, const std::string& name,
                        const std::optional<std::string>& folder, const ObjOptions& options, LoadReport& report) {
    return load_checked(as_text(bytes), name, folder, options, report, [] {});
}

}  // namespace raster
