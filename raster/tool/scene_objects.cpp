// scene_objects.cpp: model files and shapes, each with its material, appended to one model.
#include "scene_objects.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>

#include <raster/scene/append.h>
#include <raster/scene/obj_path.h>
#include <raster/scene/shape_list.h>

#include "parse.h"
#include "scene_file.h"
#include "scene_json.h"
#include "specs.h"

namespace raster::tool {
namespace {

using Kind = JsonNode::Kind;

void add_to(LoadReport& sum, const LoadReport& one) {
    sum.warnings.insert(sum.warnings.end(), one.warnings.begin(), one.warnings.end());
    sum.warnings_left_out += one.warnings_left_out;
    sum.positions += one.positions;
    sum.texture_coordinates += one.texture_coordinates;
    sum.normals += one.normals;
    sum.faces += one.faces;
    sum.dropped_faces += one.dropped_faces;
    sum.lines += one.lines;
    sum.points += one.points;
    sum.has_vertex_colors |= one.has_vertex_colors;
    sum.made_normals |= one.made_normals;
}

/// What has no material gets the default one, changed; what has one is changed.
void paint(Model& model, const MaterialChange& change, const std::string& name) {
    const bool has_bare_parts =
        model.parts.empty() || std::ranges::any_of(model.parts, [](const Part& part) { return part.material < 0; });
    if (has_bare_parts) {
        for (Part& part : model.parts)
            if (part.material < 0) part.material = int(model.materials.size());
        model.materials.push_back(default_material());
        if (!name.empty()) model.materials.back().name = name;
    }
    for (Material& material : model.materials) change.apply_to(material);
}

class Objects {
public:
    Objects(const JsonDocument& document, const ObjOptions& options, LoadReport& report)
        : document_(document),
          options_(options),
          report_(report),
          finder_(obj::folder_of(document.path), options.allow_outside) {}

    Result<Model> load() {
        const JsonNode* objects = document_.root.find("objects");
        if (!objects) return at(document_.root, "a scene has \"objects\", a list");
        if (!objects->is(Kind::array)) return at(*objects, "\"objects\" is no list of objects");
        if (objects->items.empty()) return at(*objects, "there is no object in \"objects\"");
        if (const Status status = read_materials(); !status) return status.error();
        count_ = objects->items.size();
        for (const JsonNode& object : objects->items) {
            if (const Status status = add(object); !status) return status.error();
            ++done_;
        }
        return std::move(scene_);
    }

private:
    Error at(const JsonNode& node, const std::string& what) const { return document_.error_at(node, what); }

    Status read_materials() {
        const JsonNode* materials = document_.root.find("materials");
        if (!materials) return Done{};
        if (!materials->is(Kind::object)) return at(*materials, "here an object {...} of materials is expected");
        for (std::size_t i = 0; i < materials->keys.size(); ++i) {
            const Result<MaterialChange> change = read_material(materials->items[i]);
            if (!change) return change.error();
            materials_[materials->keys[i]] = *change;
        }
        return Done{};
    }

    Result<MaterialChange> read_material(const JsonNode& node) const {
        if (node.is(Kind::text))
            if (const auto named = materials_.find(node.text); named != materials_.end()) return named->second;
        const auto find = [&](const std::string& name) { return find_file(name); };
        std::vector<std::string> own_names;
        for (const auto& material : materials_) own_names.push_back(material.first);
        const auto parse = [&](std::string_view text) { return parse_material_finding(text, find, own_names); };
        return read_spec(document_, node, "name", parse);
    }

    /// The path of a file beside the scene, for messages as the scene was named. The error is a text for them.
    Result<std::string> find_file(const std::string& name) const {
        if (const auto found = finder_.find(name, finder_.folder()); !found) {
            const std::string& why = found.error().message;
            const bool outside = why.starts_with("refused: leads out");
            const char* const refused = "refused: leads out of the scene's folder; see --allow-outside";
            return Error{found.error().kind, name + ": " + (outside ? refused : why)};
        }
        return (std::filesystem::path(document_.path).parent_path() / name).string();
    }

    Status add(const JsonNode& object) {
        if (const Status status =
                check_members(document_, object, {"name", "model", "shape", "material", "transform"});
            !status)
            return status;
        const JsonNode *file = object.find("model"), *shape = object.find("shape");
        if (!file == !shape) return at(object, "an object has either a model or a shape");
        Result<Model> model = file ? load_file(*file) : make(*shape);
        if (!model) return model.error();

        glm::mat4 world_from_object(1.0f);
        if (const JsonNode* transform = object.find("transform")) {
            const Result<glm::mat4> read = read_transform(document_, *transform);
            if (!read) return read.error();
            world_from_object = *read;
        }
        if (const JsonNode* material = object.find("material")) {
            const Result<MaterialChange> change = read_material(*material);
            if (!change) return change.error();
            paint(*model, *change, material->text);
        }
        if (const JsonNode* name = object.find("name")) {
            if (!name->is(Kind::text)) return at(*name, "here a text is expected");
            for (Part& part : model->parts)
                part.name = model->parts.size() == 1 || part.name.empty() ? name->text : name->text + "/" + part.name;
        }
        if (scene_.triangle_count() + model->triangle_count() > options_.max_triangles)
            return at(object, "with this object there are more than " + std::to_string(options_.max_triangles) +
                                  " triangles");
        if (const Status added = append(scene_, *model, world_from_object); !added)
            return at(object, added.error().message);
        return Done{};
    }

    Result<Model> load_file(const JsonNode& node) {
        if (!node.is(Kind::text)) return at(node, "here the name of a model file is expected");
        if (const auto known = files_.find(node.text); known != files_.end()) return known->second;
        const Result<std::string> path = find_file(node.text);
        if (!path) return at(node, path.error().message);
        ObjOptions options = options_;
        options.progress = [&](double part) {
            if (options_.progress) options_.progress((double(done_) + part) / double(count_));
        };
        LoadReport report;
        Result<Model> model = load_obj(*path, options, report);
        add_to(report_, report);
        if (!model) return model;
        // Textures are named from the scene's folder, as the model's names are.
        const std::filesystem::path folder = std::filesystem::path(node.text).parent_path();
        for (Texture& texture : model->textures) texture.name = (folder / texture.name).generic_string();
        files_[node.text] = *model;
        return model;
    }

    Result<Model> make(const JsonNode& node) const {
        if (!node.is(Kind::text) && !node.is(Kind::object)) return at(node, "here a shape is expected");
        const JsonNode* kind = node.is(Kind::text) ? &node : node.find("kind");
        if (!kind || !kind->is(Kind::text)) return at(node, "a shape has a \"kind\"");
        if (kind->text == "revolution") return turn(node);
        std::vector<std::pair<std::string, double>> values;
        for (std::size_t i = 0; i < node.keys.size(); ++i) {
            if (node.keys[i] == "kind") continue;
            const Result<float> number = read_number(document_, node.items[i]);
            if (!number) return number.error();
            values.emplace_back(node.keys[i], node.items[i].number);
        }
        Result<Model> model = make_shape(kind->text, values);
        if (!model) return at(node, model.error().message);
        return model;
    }

    Result<Model> turn(const JsonNode& node) const {
        if (const Status status = check_members(document_, node, {"kind", "profile", "segments", "steps"}); !status)
            return status.error();
        const JsonNode* profile = node.find("profile");
        if (!profile || !profile->is(Kind::array) || profile->items.size() < 2)
            return at(profile ? *profile : node, "a profile is a list of two or more points [radius, height]");
        std::vector<glm::dvec2> points;
        for (const JsonNode& item : profile->items) {
            if (!item.is(Kind::array) || item.items.size() != 2) return at(item, "a point is [radius, height]");
            const Result<float> radius = read_number(document_, item.items[0]);
            const Result<float> height = read_number(document_, item.items[1]);
            if (!radius) return radius.error();
            if (!height) return height.error();
            if (*radius < 0) return at(item.items[0], "a radius is 0 or more");
            points.emplace_back(item.items[0].number, item.items[1].number);
        }
        const auto whole = [&](const char* name, int value, int low, int high) -> Result<int> {
            const JsonNode* number = node.find(name);
            if (!number) return value;
            if (!number->is(Kind::number) || !(number->number >= low && number->number <= high) ||
                number->number != std::floor(number->number))
                return at(*number, std::string(name) + " is a whole number from " + std::to_string(low) + " to " +
                                       std::to_string(high));
            return int(number->number);
        };
        const Result<int> segments = whole("segments", 96, 3, 1024), steps = whole("steps", 8, 1, 64);
        if (!segments) return segments.error();
        if (!steps) return steps.error();
        constexpr std::size_t most_points = 1024;
        if (points.size() * std::size_t(*steps) > most_points)
            return at(*profile, "points times steps are more than " + std::to_string(most_points));
        Model model = surface_of_revolution(smooth_profile(curve_through(points, *steps)), *segments);
        if (model.triangle_count() == 0) return at(*profile, "this profile makes no surface");
        return model;
    }

    const JsonDocument& document_;
    const ObjOptions& options_;
    LoadReport& report_;
    obj::Finder finder_;
    std::map<std::string, MaterialChange> materials_;
    std::map<std::string, Model> files_;  ///< read already
    Model scene_;
    std::size_t count_ = 0, done_ = 0;
};

}  // namespace

Result<Model> load_scene_objects(const JsonDocument& document, const ObjOptions& options, LoadReport& report) {
    return Objects(document, options, report).load();
}

bool is_shape(const std::string& model) { return model.starts_with("shape:"); }

Result<Model> load_shape(const std::string& model) {
    const Result<Spec> spec = parse_spec(std::string_view(model).substr(6));
    if (!spec) return spec.error();
    std::vector<std::pair<std::string, double>> values;
    for (const auto& [key, text] : spec->values) {
        const Result<float> number = parse_number(text);
        if (!number) return Error{ErrorKind::usage, in_quotes(model) + ": " + key + "=" + number.error().message};
        values.emplace_back(key, double(*number));
    }
    return make_shape(spec->name, values);
}

}  // namespace raster::tool
