// step.cpp: two observed runs, the choice between them, and the page.
#include <raster/step/step.h>

#include <algorithm>
#include <numeric>

#include <raster/step/parts.h>
#include <raster/step/recorder.h>
#include <raster/step/survey.h>

namespace raster {
namespace step {
namespace {

std::string comma(std::int64_t number) {
    std::string text = std::to_string(number);
    for (std::size_t i = text.size(); i > 3; i -= 3) text.insert(i - 3, ",");
    return text;
}

Region region_around(glm::ivec2 pixel, int width, int height, const StepOptions& options) {
    const int w = std::min(options.region_width, width), h = std::min(options.region_height, height);
    const int x = std::clamp(pixel.x - w / 2, 0, width - w), y = std::clamp(pixel.y - h / 2, 0, height - h);
    return {x, y, x + w - 1, y + h - 1};
}

/// All numbers of the fragments nearest to the pixel of interest, whole pixels at a time.
void choose_detail(Record& record, int max_fragments) {
    const auto distance = [&](int x, int y) {
        return std::max(std::abs(x - record.pixel.x), std::abs(y - record.pixel.y));
    };
    std::vector<int> fragments(std::size_t(std::max(record.width, record.height)) + 1);
    for (const FragmentRecord& f : record.fragments) ++fragments[std::size_t(distance(f.x, f.y))];
    int radius = 0;
    for (int sum = 0; radius < int(fragments.size()); ++radius) {
        sum += fragments[std::size_t(radius)];
        if (radius > 0 && sum > max_fragments) break;
    }
    std::size_t without = 0;
    for (FragmentRecord& f : record.fragments) {
        f.detailed = distance(f.x, f.y) < radius;
        without += !f.detailed;
    }
    if (without > 0)
        record.left_out.push_back("All numbers are kept of the fragments up to " + std::to_string(radius - 1) +
                                  " pixels from the pixel of interest; of " + comma(std::int64_t(without)) +
                                  " others in the grid depth and colour alone.");
    std::erase_if(record.painted, [&](const PaintedRecord& p) { return distance(p.x, p.y) >= radius; });
}

/// Names of materials, by the triangles of the draws.
void name_draws(Record& record, const Model& model) {
    for (std::size_t d = 0; d < record.draws.size(); ++d) record.draws[d].material = "draw " + std::to_string(d);
    for (const TriangleRecord& t : record.triangles) {
        for (const Part& part : model.parts) {
            const std::int64_t index = 3 * t.number;
            if (index < part.first_index || index >= std::int64_t(part.first_index) + part.index_count) continue;
            const bool known = part.material >= 0 && std::size_t(part.material) < model.materials.size();
            record.draws[std::size_t(t.draw)].material =
                known ? model.materials[std::size_t(part.material)].name : std::string("default");
        }
    }
}

/// The one that was asked for, or one that has something to show: where the bug shows, nearest to its first triangle;
/// in the triangle; where surfaces overlap. `shown` has the picture of the survey.
glm::ivec2 pixel_of_interest(const Scene& scene, const Record& record, const Survey& survey,
                             const std::optional<std::int64_t>& triangle, const Target& shown,
                             const RenderOptions& options) {
    if (scene.step.pixel) return *scene.step.pixel;
    const int width = record.width, height = record.height;
    glm::ivec2 pixel = survey.busy_pixel();
    if (triangle) pixel = survey.pixel_of(*triangle).value_or(glm::ivec2(width / 2, height / 2));
    if (!scene.step.bug || scene.step.triangle) return pixel;
    if (record.first_difference && record.first_difference->place.pixel) pixel = *record.first_difference->place.pixel;
    Target right = watched_target(width, height, options, scene.step.display);
    render(right, scene.model, scene.camera, options);
    std::int64_t nearest = INT64_MAX;
    glm::ivec2 found = pixel;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const std::int64_t dx = x - pixel.x, dy = y - pixel.y, square = dx * dx + dy * dy;
            if (square < nearest && right.color(x, y) != shown.color(x, y)) nearest = square, found = {x, y};
        }
    return found;
}

Result<Record> make_record(const Scene& scene, int width, int height) {
    const StepOptions& step = scene.step;
    const auto wrong = [](const std::string& what) { return Error{ErrorKind::usage, what}; };
    if (step.pixel && (step.pixel->x < 0 || step.pixel->x >= width || step.pixel->y < 0 || step.pixel->y >= height))
        return wrong("pixel " + std::to_string(step.pixel->x) + "," + std::to_string(step.pixel->y) +
                     " lies outside the picture of " + std::to_string(width) + "x" + std::to_string(height));
    const auto triangles = std::int64_t(scene.model.triangle_count());
    if (step.triangle && (*step.triangle < 0 || *step.triangle >= triangles))
        return wrong("there is no triangle " + comma(*step.triangle + 1) + "; the model has " + comma(triangles));

    RenderOptions options = scene.options;
    options.background = light_for(options.background, step.display);
    Target target = watched_target(width, height, options, step.display);
    Survey survey(width, height);
    Record record{};
    record.width = width;
    record.height = height;
    record.bug = step.bug;
    record.counts = watch(target, scene.model, scene.camera, options, survey, step.bug);
    if (step.bug)
        record.first_difference = first_difference(*step.bug, width, height, scene.model, scene.camera, options);
    std::optional<std::int64_t> triangle = step.triangle;
    if (!triangle && record.first_difference) triangle = record.first_difference->place.triangle;
    record.pixel = pixel_of_interest(scene, record, survey, triangle, target, options);
    record.region = region_around(record.pixel, width, height, step);

    auto chosen = survey.choose(step.max_triangles, triangle, record.pixel, record.region);
    const auto kept = std::int64_t(chosen.size());
    Recorder recorder(record, std::move(chosen), options.world_from_object);
    watch(target, scene.model, scene.camera, options, recorder, step.bug);
    RenderOptions painted = options;
    painted.visibility = Visibility::painter;
    PaintRecorder painter(record);
    watch(target, scene.model, scene.camera, painted, painter, step.bug);

    record.focus = triangle.value_or(-1);
    if (!triangle) {
        for (const FragmentRecord& f : record.fragments)
            if (f.passed && f.x == record.pixel.x && f.y == record.pixel.y) record.focus = f.triangle;
        if (record.focus < 0 && !record.triangles.empty()) record.focus = record.triangles.front().number;
    }
    if (kept < triangles)
        record.left_out.push_back("Of " + comma(triangles) + " triangles " + comma(kept) +
                                  " are followed from vertex to pixel: those that cover the pixel of interest, some of"
                                  " each fate, and neighbours. " + comma(survey.count_in(record.region)) +
                                  " have their bounding box in the grid.");
    choose_detail(record, step.max_fragments);
    name_draws(record, scene.model);
    return record;
}

void replace(std::string& text, std::string_view what, std::string_view with) {
    const std::size_t place = text.find(what);
    if (place != std::string::npos) text.replace(place, what.size(), with);
}

/// In a script element `<` may end the script; in JSON it stands in strings only, where it can be escaped.
std::string for_script(const std::string& json) {
    std::string out;
    out.reserve(json.size());
    for (const char c : json) {
        if (c == '<') out += "\\u003c";
        else out += c;
    }
    return out;
}

std::string escaped(std::string_view text) {
    std::string out;
    for (const char c : text) {
        switch (c) {
            case '<': out += "&lt;"; break;
            case '>': out += "&gt;"; break;
            case '&': out += "&amp;"; break;
            default: out += c;
        }
    }
    return out;
}

}  // namespace
}  // namespace step

Result<std::string> step_page(const Model& model, const CameraMatrices& camera, int width, int height,
                              const RenderOptions& options, const StepOptions& step_options) {
    using namespace step;
    if (!step_options.stage.empty() && std::ranges::find(stage_names, step_options.stage) == std::end(stage_names))
        return Error{ErrorKind::usage, "there is no stage '" + step_options.stage + "'"};
    const Scene scene{model, camera, options, step_options};
    Result<Record> record = make_record(scene, width, height);
    if (!record) return record.error();

    JsonText json;
    Status status = Done{};
    json.object([&] {
        write_scene(json, scene, *record);
        write_triangles(json, *record);
        write_fragments(json, scene, *record);
        status = write_pictures(json, scene, *record);
        write_mesh(json, model, options.world_from_object, record->left_out);
        json.member("left_out", record->left_out);
    });
    if (!status) return status.error();

    std::string page = page_source::html;
    replace(page, "{{title}}", escaped(step_options.name));
    replace(page, "{{style}}", page_source::style);
    replace(page, "{{script}}", page_source::script);
    replace(page, "{{data}}", for_script(json.text()));  // last: what it holds is not looked at again
    return page;
}

}  // namespace raster
