// scene_file.cpp: a scene's objects become one model, the rest of it flags.
#include "scene_file.h"

#include <raster/image/file.h>

#include "scene_json.h"
#include "scene_objects.h"
#include "specs.h"

namespace raster::tool {
namespace {

using Kind = JsonNode::Kind;

constexpr std::size_t max_scene_bytes = std::size_t(16) << 20;

/// Members of "camera", "picture" and "display", and the flags they stand in for.
struct FlagMember {
    const char* key;
    const char* flag;
    char separator = ',';
};
const std::vector<FlagMember> camera_members = {{"position", "--camera-position"},
                                                {"focal_point", "--camera-focal-point"},
                                                {"up", "--up"},
                                                {"view_angle", "--camera-view-angle"},
                                                {"azimuth", "--camera-azimuth-angle"},
                                                {"elevation", "--camera-elevation-angle"},
                                                {"near", "--near"},
                                                {"far", "--far"}};
const std::vector<FlagMember> picture_members = {{"size", "--size", 'x'},
                                                 {"background", "--background"},
                                                 {"shade", "--shade"},
                                                 {"reflectance", "--reflectance"},
                                                 {"two_sided", "--two-sided"},
                                                 {"hidden", "--hidden"},
                                                 {"cull", "--cull"},
                                                 {"fill_rule", "--fill-rule"},
                                                 {"samples", "--samples"},
                                                 {"textures", "--textures"},
                                                 {"texture_filter", "--texture-filter"},
                                                 {"texture_wrap", "--texture-wrap"}};
const std::vector<FlagMember> display_members = {{"encoding", "--display"}, {"exposure", "--exposure"}};

struct Section {
    const char* name;
    const std::vector<FlagMember>& members;
};
const std::vector<Section> sections = {
    {"camera", camera_members}, {"picture", picture_members}, {"display", display_members}};

std::vector<std::string> keys_of(const std::vector<FlagMember>& members) {
    std::vector<std::string> keys;
    for (const FlagMember& member : members) keys.emplace_back(member.key);
    return keys;
}

bool is_given(const CLI::App& app, const std::string& flag) {
    const CLI::Option* option = app.get_option_no_throw(flag);
    return option && option->count() > 0;
}

/// Sets a flag that is not given; `place` is where the scene says so.
Status set_flag(CLI::App& app, const std::string& flag, const std::vector<std::string>& texts,
                const JsonDocument& document, const JsonNode& place) {
    CLI::Option* option = app.get_option_no_throw(flag);
    if (!option || option->count() > 0) return Done{};
    try {
        for (const std::string& text : texts) option->add_result(text);
        option->run_callback();
    } catch (const CLI::ParseError& error) {
        return document.error_at(place, error.what());
    }
    return Done{};
}

}  // namespace

bool is_scene(const std::string& path) { return path.ends_with(".json") || path.ends_with(".JSON"); }

Result<SceneFile> SceneFile::read(const std::string& path) {
    const Result<Bytes> bytes = read_file(path, max_scene_bytes);
    if (!bytes) return bytes.error();
    return parse(path, std::string(reinterpret_cast<const char*>(bytes->data()), bytes->size()));
}

Result<SceneFile> SceneFile::parse(const std::string& path, std::string text) {
    Result<JsonDocument> parsed = parse_json(path, std::move(text));
    if (!parsed) return parsed.error();
    SceneFile scene;
    scene.document_ = std::make_shared<const JsonDocument>(std::move(*parsed));
    if (const Status status = scene.check_keys(); !status) return status.error();
    return scene;
}

Status SceneFile::check_keys() const {
    const JsonDocument& document = *document_;
    const JsonNode& root = document.root;
    const JsonNode *format = root.find("format"), *version = root.find("version");
    if (!format || !format->is(Kind::text) || format->text != "raster-scene")
        return document.error_at(format ? *format : root,
                                 "no scene file: \"format\" is not \"raster-scene\"" +
                                     std::string(format && format->text == "raster-camera"
                                                     ? "; a camera file goes with --camera-json"
                                                     : ""));
    if (!version || !version->is(Kind::number) || version->number != 1)
        return document.error_at(version ? *version : root, "\"version\" is not 1, which is what this program reads");
    if (const Status status = check_members(document, root,
                                            {"$schema", "format", "version", "description", "materials", "objects",
                                             "lights", "camera", "picture", "display"});
        !status)
        return status;
    for (const Section& section : sections) {
        const JsonNode* node = root.find(section.name);
        if (!node) continue;
        if (const Status status = check_members(document, *node, keys_of(section.members)); !status) return status;
    }
    return Done{};
}

Status SceneFile::set_flags(CLI::App& app) const {
    const JsonDocument& document = *document_;
    const bool camera_is_given = is_given(app, "--camera-json");
    for (const Section& section : sections) {
        const JsonNode* node = document.root.find(section.name);
        if (!node || (camera_is_given && section.name == std::string_view("camera"))) continue;
        for (const FlagMember& member : section.members) {
            const JsonNode* value = node->find(member.key);
            if (!value || (camera_is_given && member.flag == std::string_view("--size"))) continue;
            const Result<std::string> text = flag_text(document, *value, member.separator);
            if (!text) return text.error();
            if (const Status status = set_flag(app, member.flag, {*text}, document, *value); !status) return status;
        }
    }
    const JsonNode* lights = document.root.find("lights");
    if (!lights) return Done{};
    if (!lights->is(Kind::array)) return document.error_at(*lights, "here a list of lights is expected");
    // Lights that are none must not become the default ones.
    std::vector<std::string> texts;
    if (lights->items.empty()) texts.emplace_back("ambient:color=0");
    for (const JsonNode& light : lights->items) {
        if (const auto read = read_spec(document, light, "kind", parse_light); !read) return read.error();
        const std::size_t members = light.items.size();
        texts.push_back(*detail::spec_text(document, light, "kind", members));
    }
    return set_flag(app, "--light", texts, document, *lights);
}

Result<Model> SceneFile::load(const ObjOptions& options, LoadReport& report) const {
    return load_scene_objects(*document_, options, report);
}

}  // namespace raster::tool
