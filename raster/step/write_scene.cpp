// write_scene.cpp: what holds for all draws: camera, lights, state, and what was left out.
#include <raster/step/parts.h>

#include <raster/stages/project.h>
#include <raster/trace/event_json.h>

namespace raster::step {
namespace {

constexpr const char* faces[] = {"counter_clockwise", "clockwise"};
constexpr const char* light_kinds[] = {"ambient", "directional", "point", "spot"};

void write_camera(JsonText& json, const Scene& scene, const Record& record) {
    const CameraMatrices& camera = scene.camera;
    const glm::mat4& object = scene.options.world_from_object;
    // For drawing the 3D view only, so that doubles do.
    const glm::dmat4 back = glm::inverse(glm::dmat4(camera.clip_from_world));
    const glm::dmat4 world_from_eye = glm::inverse(glm::dmat4(camera.eye_from_world));
    const ViewportTransform viewport(effective_viewport({}, record.width, record.height));
    json.object("view", [&] {
        json.member("width", record.width);
        json.member("height", record.height);
        json.member("world_from_object", object);
        json.member("eye_from_world", camera.eye_from_world);
        json.member("clip_from_eye", camera.clip_from_eye);
        json.member("world_from_clip", glm::mat4(back));
        json.member("world_from_eye", glm::mat4(world_from_eye));
        json.member("scale", viewport.scale);
        json.member("offset", viewport.offset);
        json.member("perspective", camera.clip_from_eye[2][3] != 0.0f);
    });
}

void write_lights(JsonText& json, const Scene& scene) {
    const Lighting lighting = make_lighting(scene.options.lights, scene.camera.eye_from_world);
    json.object("lighting", [&] {
        json.member("ambient", lighting.ambient);
        json.array("lights", [&] {
            for (const EyeLight& l : lighting.lights) {
                json.object([&] {
                    json.member("kind", light_kinds[int(l.kind)]);
                    json.member("diffuse", l.diffuse);
                    json.member("specular", l.specular);
                    json.member("position_eye", l.position_eye);
                    json.member("direction_eye", l.direction_eye);
                });
            }
        });
    });
}

void write_draws(JsonText& json, const Record& record) {
    json.array("draws", [&] {
        for (const DrawRecord& d : record.draws) {
            json.object([&] {
                json.member("material", d.material);
                json.member("frequency", word_for(d.frequency));
                json.member("level", word_for(d.level));
                json.member("reflectance", d.reflectance);
                if (d.n_h_power) json.member("n_h_power", *d.n_h_power);
                if (d.r_v_power) json.member("r_v_power", *d.r_v_power);
                json.member("triangles", d.triangles);
                json.member("vertices", d.vertices);
                json.member("varyings", d.varyings);
                json.member("clip_from_object", d.clip_from_object);
                json.member("eye_from_object", d.eye_from_object);
                json.member("cull", word_for(d.state.cull));
                json.member("front_face", faces[int(d.state.front_face)]);
                json.member("fill_rule", word_for(d.state.fill_rule));
                json.member("depth_compare", word_for(d.state.depth_compare));
                json.member("depth_write", d.state.depth_write);
                json.member("blend", word_for(d.state.blend));
            });
        }
    });
}

void write_bug(JsonText& json, const Record& record) {
    const BugInfo& info = info_of(*record.bug);
    json.object("bug", [&] {
        json.member("name", info.name);
        json.member("mistake", info.mistake);
        json.member("symptom", info.symptom);
        if (!record.first_difference) return;
        const FirstDifference& first = *record.first_difference;
        json.object("first", [&] {
            json.member("event", first.event);
            json.member("stage", first.place.stage);
            if (first.place.triangle) json.member("triangle", *first.place.triangle + 1);
            if (first.place.pixel) json.member("pixel", *first.place.pixel);
            for (const auto& [name, line] : {std::pair("right", &first.right), {"wrong", &first.wrong}}) {
                json.key(name);
                line->empty() ? json.null() : json.raw(*line);
            }
        });
    });
}

}  // namespace

void write_scene(JsonText& json, const Scene& scene, const Record& record) {
    const RenderOptions& o = scene.options;
    json.member("schema", "raster-step");
    json.member("version", 1);
    json.object("model", [&] {
        json.member("name", scene.step.name);
        json.member("triangles", scene.model.triangle_count());
        json.member("vertices", scene.model.vertices.size());
    });
    json.member("command", scene.step.command);
    json.object("options", [&] {
        json.member("frequency", word_for(o.frequency));
        json.member("visibility", o.visibility == Visibility::zbuffer ? "zbuffer" : "painter");
        json.member("two_sided", o.two_sided);
        json.member("background", o.background);
    });
    json.object("display", [&] {
        json.member("srgb", scene.step.display.srgb);
        json.member("exposure", scene.step.display.exposure);
    });
    if (record.bug) write_bug(json, record);
    json.object("focus", [&] {
        json.member("pixel", record.pixel);
        json.member("triangle", record.focus + 1);
        json.member("stage", scene.step.stage);
    });
    json.member("questions", scene.step.questions);
    json.array("region", [&] {
        json.value(record.region.x0), json.value(record.region.y0), json.value(record.region.x1),
            json.value(record.region.y1);
    });
    json.object("counts", [&] {
        const DrawCounts& c = record.counts;
        json.member("submitted", c.submitted);
        json.member("bad_index", c.bad_index);
        json.member("not_finite", c.not_finite);
        json.member("outside", c.outside);
        json.member("culled", c.culled);
        json.member("zero_area", c.zero_area);
        json.member("drawn", c.drawn);
    });
    write_camera(json, scene, record);
    write_lights(json, scene);
    write_draws(json, record);
}

}  // namespace raster::step
