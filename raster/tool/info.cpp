// info.cpp: `raster info`: what was read from a model file, and the camera that frames it.
#include <algorithm>
#include <cstdio>

#include "commands.h"
#include "picture.h"
#include "report.h"
#include "view.h"
#include "view_json.h"

namespace raster::tool {
namespace {

struct InfoArguments {
    LoadFlags load;
    ViewFlags view;
    ProgressMode progress = ProgressMode::automatic;
    bool json = false;
};

/// Lists longer than this are cut in the text; JSON has all.
constexpr std::size_t max_lines = 20;

std::string material_name(const Model& model, int material) {
    const bool known = material >= 0 && std::size_t(material) < model.materials.size();
    return known ? model.materials[std::size_t(material)].name : "";
}

struct NamedTexture {
    const char* role;
    int texture;
};
std::vector<NamedTexture> textures_of(const Model& model, const Material& m) {
    std::vector<NamedTexture> used;
    for (const NamedTexture& t : {NamedTexture{"diffuse", m.diffuse_texture},
                                  {"ambient", m.ambient_texture},
                                  {"specular", m.specular_texture},
                                  {"emission", m.emission_texture},
                                  {"alpha", m.alpha_texture}})
        if (t.texture >= 0 && std::size_t(t.texture) < model.textures.size()) used.push_back(t);
    return used;
}

// ---- for programs

Json materials_json(const Model& model) {
    Json list = Json::array();
    for (const Material& m : model.materials) {
        Json json;
        json["name"] = m.name;
        json["ambient"] = to_json(m.ambient);
        json["diffuse"] = to_json(m.diffuse);
        json["specular"] = to_json(m.specular);
        json["emission"] = to_json(m.emission);
        json["shininess"] = m.shininess;
        json["alpha"] = m.alpha;
        json["illumination"] = m.illumination;
        json["textures"] = Json::object();
        for (const NamedTexture& t : textures_of(model, m))
            json["textures"][t.role] = model.textures[std::size_t(t.texture)].name;
        list.push_back(std::move(json));
    }
    return list;
}

Json info_json(const std::string& path, const Loaded& loaded, const View& view) {
    const Model& model = loaded.model;
    const LoadReport& report = loaded.report;
    const Box box = bounding_box(model);
    Json json;
    json["format"] = "raster-info";
    json["version"] = 1;
    json["file"] = path;
    json["file_statements"] = {{"positions", report.positions},
                               {"texture_coordinates", report.texture_coordinates},
                               {"normals", report.normals},
                               {"faces", report.faces},
                               {"faces_dropped", report.dropped_faces},
                               {"lines", report.lines},
                               {"points", report.points}};
    json["vertices"] = model.vertices.size();
    json["triangles"] = model.triangle_count();
    json["normals_made"] = report.made_normals;
    json["vertex_colors"] = report.has_vertex_colors;
    json["bounding_box"]["min"] = to_json(box.min);
    json["bounding_box"]["max"] = to_json(box.max);
    json["parts"] = Json::array();
    for (const Part& part : model.parts)
        json["parts"].push_back({{"name", part.name},
                                 {"triangles", part.index_count / 3},
                                 {"material", material_name(model, part.material)}});
    json["materials"] = materials_json(model);
    json["textures"] = Json::array();
    for (const Texture& t : model.textures)
        json["textures"].push_back(
            {{"name", t.name}, {"width", t.image.width}, {"height", t.image.height}, {"channels", t.image.channels}});
    json["warnings"] = Json::array();
    for (const LoadWarning& w : report.warnings)
        json["warnings"].push_back({{"file", w.file}, {"line", w.line}, {"count", w.count}, {"message", w.message()}});
    json["warnings_left_out"] = report.warnings_left_out;
    json["camera"] = to_json(view);
    return json;
}

// ---- for people

class InfoText {
public:
    InfoText(const std::string& path, const Loaded& loaded, const View& view)
        : model_(loaded.model), report_(loaded.report) {
        out_ = path + "\n";
        add_counts();
        add_parts();
        add_materials();
        add_textures();
        add_warnings();
        add_view(view);
    }
    std::string take() { return std::move(out_); }

private:
    void row(const std::string& name, const std::string& text) {
        std::string left = "  " + name;
        left.resize(std::max<std::size_t>(left.size() + 1, 16), ' ');
        out_ += left + text + "\n";
    }

    /// Calls line(i) for the first items and counts the rest.
    template <class Line>
    void list(const std::string& title, std::size_t count, const Line& line) {
        if (count == 0) return;
        out_ += title + " (" + with_separators(std::int64_t(count)) + ")\n";
        for (std::size_t i = 0; i < std::min(count, max_lines); ++i) line(i);
        if (count > max_lines)
            out_ += "  and " + with_separators(std::int64_t(count - max_lines)) + " more, all listed by --json\n";
    }

    void add_counts() {
        const LoadReport& r = report_;
        const auto n = [](std::size_t count) { return with_separators(std::int64_t(count)); };
        row("in the file", n(r.positions) + " positions, " + n(r.texture_coordinates) + " texture coordinates, " +
                               n(r.normals) + " normals, " + n(r.faces) + " faces" +
                               (r.dropped_faces > 0 ? " (" + n(r.dropped_faces) + " dropped)" : ""));
        if (r.lines + r.points > 0) row("not drawn", n(r.lines) + " lines, " + n(r.points) + " point statements");
        row("vertices", n(model_.vertices.size()));
        row("triangles", n(model_.triangle_count()));
        row("normals", r.made_normals ? "made here, at least in part" : "from the file");
        row("vertex colours", r.has_vertex_colors ? "yes" : "no");
        const Box box = bounding_box(model_);
        row("bounding box", to_text(box.min) + " to " + to_text(box.max));
        row("box size", to_text(box.max - box.min));
    }

    void add_parts() {
        list("parts", model_.parts.size(), [&](std::size_t i) {
            const Part& part = model_.parts[i];
            const std::string material = material_name(model_, part.material);
            row(part.name.empty() ? "(no name)" : part.name,
                counted(part.index_count / 3, "triangle") + ", " +
                    (material.empty() ? "default material" : "material " + material));
        });
    }

    void add_materials() {
        list("materials", model_.materials.size(), [&](std::size_t i) {
            const Material& m = model_.materials[i];
            std::string text = "diffuse " + to_text(m.diffuse) + "  specular " + to_text(m.specular);
            if (m.specular != glm::vec3(0.0f)) text += "  shininess " + to_text(m.shininess);
            if (m.alpha < 1) text += "  alpha " + to_text(m.alpha);
            for (const NamedTexture& t : textures_of(model_, m))
                text += std::string("  ") + t.role + " " + model_.textures[std::size_t(t.texture)].name;
            row(m.name, text);
        });
    }

    void add_textures() {
        list("textures", model_.textures.size(), [&](std::size_t i) {
            const Texture& t = model_.textures[i];
            row(t.name, to_text(Size{t.image.width, t.image.height}) + ", " + counted(t.image.channels, "channel"));
        });
    }

    void add_warnings() {
        list("warnings", report_.warnings.size() + report_.warnings_left_out, [&](std::size_t i) {
            if (i < report_.warnings.size()) out_ += "  " + report_.warnings[i].message() + "\n";
        });
    }

    void add_matrix(const std::string& name, const glm::mat4& m) {
        out_ += "  " + name + "\n";
        for (int r = 0; r < 4; ++r) {
            char line[128];
            std::snprintf(line, sizeof line, "   %15.9g %15.9g %15.9g %15.9g\n", double(m[0][r]), double(m[1][r]),
                          double(m[2][r]), double(m[3][r]));
            out_ += line;
        }
    }

    void add_view(const View& view) {
        out_ += "camera for a picture of " + to_text(view.size) + "\n";
        if (view.camera) {
            row("position", to_text(view.camera->position));
            row("focal point", to_text(view.camera->focal_point));
            row("up", to_text(view.camera->up));
            row("view angle", to_text(view.camera->view_angle) + " degrees");
            row("near, far", to_text(view.camera->near_plane) + ", " + to_text(view.camera->far_plane));
        }
        add_matrix("eye_from_world", view.matrices.eye_from_world);
        add_matrix("clip_from_eye", view.matrices.clip_from_eye);
        add_matrix("clip_from_world", view.matrices.clip_from_world);
    }

    const Model& model_;
    const LoadReport& report_;
    std::string out_;
};

Result<int> run_info(const InfoArguments& a) {
    const Result<ViewPlan> plan = ViewPlan::make(a.view);
    if (!plan) return plan.error();
    Progress progress(a.progress);
    const Result<Loaded> loaded = load(a.load, progress, true);
    if (!loaded) return loaded.error();
    const Result<View> view = plan->view_of(loaded->model);
    if (!view) return view.error();
    const Status printed = print(a.json ? json_text(info_json(a.load.model, *loaded, *view))
                                        : InfoText(a.load.model, *loaded, *view).take());
    return printed ? Result<int>(exit_done) : printed.error();
}

}  // namespace

Run add_info(CLI::App& app) {
    const auto a = std::make_shared<InfoArguments>();
    add_load_flags(app, a->load);
    add_switch(app, "--json", a->json,
               "Everything as one JSON object, the camera's matrices also as hexadecimal floats. Its \"camera\" is what"
               " --camera-json reads.")
        ->group("Other flags");
    add_view_flags(app, a->view);
    add_progress_flags(app, a->progress);
    return [a] { return run_info(*a); };
}

}  // namespace raster::tool
