// write_pictures.cpp: the pictures of the page, and the mesh of its 3D view.
#include <algorithm>

#include <raster/image/data_url.h>
#include <raster/image/diff_picture.h>
#include <raster/image/png.h>
#include <raster/step/parts.h>

namespace raster::step {
namespace {

constexpr std::size_t max_mesh_triangles = 8000;

struct Rectangle {
    int x, y, width, height;
};

/// Of at most that size around the pixel, within the picture.
Rectangle cut_around(const Record& r, int max_width, int max_height) {
    const int width = std::min(r.width, max_width), height = std::min(r.height, max_height);
    return {std::clamp(r.pixel.x - width / 2, 0, r.width - width),
            std::clamp(r.pixel.y - height / 2, 0, r.height - height), width, height};
}

/// An RGB picture whose samples are value(index of the pixel, channel), 0 to 255.
template <class Value>
Image8 picture_of(const Target& target, const Rectangle& cut, const Value& value) {
    Image8 image(cut.width, cut.height, 3);
    for (int y = 0; y < cut.height; ++y)
        for (int x = 0; x < cut.width; ++x)
            for (int c = 0; c < 3; ++c)
                image.pixel(x, y)[c] = std::uint8_t(value(target.index(cut.x + x, cut.y + y), c));
    return image;
}

Image8 colors_of(const Target& target, const Rectangle& cut) {
    return picture_of(target, cut, [&](std::size_t i, int c) { return target.color8()[i] >> (8 * c) & 255; });
}

Status write_picture(JsonText& json, const char* name, const Image8& image) {
    const Result<Bytes> png = encode_png(image);
    if (!png) return png.error();
    json.member(name, data_url("image/png", *png));
    return Done{};
}

template <class T>
void write_bytes(JsonText& json, const char* name, const std::vector<T>& numbers) {
    const auto bytes = std::as_bytes(std::span(numbers));
    const std::string url = data_url("", Bytes(bytes.begin(), bytes.end()));
    json.member(name, std::string_view(url).substr(url.find(',') + 1));
}

}  // namespace

Status write_pictures(JsonText& json, const Scene& scene, const Record& record) {
    const Rectangle cut = cut_around(record, scene.step.max_picture_width, scene.step.max_picture_height);
    Status status = Done{};
    const auto add = [&](const char* name, const Image8& image) {
        if (status) status = write_picture(json, name, image);
    };
    json.object("pictures", [&] {
        json.array("rect",
                   [&] { json.value(cut.x), json.value(cut.y), json.value(cut.width), json.value(cut.height); });
        struct Frequency {
            ShadingFrequency frequency;
            const char* name;
        };
        const Display& display = scene.step.display;
        const auto draw = [&](ShadingFrequency frequency, Visibility visibility, const std::optional<Bug>& bug,
                              int planes) {
            RenderOptions options = scene.options;
            options.frequency = frequency;
            options.visibility = visibility;
            options.background = light_for(options.background, display);
            Target target(record.width, record.height,
                          display.is_plain() ? ColorFormat::rgba8 : ColorFormat::rgba_float, DepthFormat::unorm24,
                          planes);
            bug ? render_bug(*bug, target, scene.model, scene.camera, options)
                : render(target, scene.model, scene.camera, options);
            return target;
        };
        const auto shown = [&](Target target) { return display.is_plain() ? target : displayed(target, display); };
        const ShadingFrequency in_force = scene.options.frequency;
        const Visibility visibility = scene.options.visibility;
        const std::optional<Bug>& bug = scene.step.bug;
        for (const auto& [frequency, name] : {Frequency{ShadingFrequency::flat, "flat"},
                                              Frequency{ShadingFrequency::gouraud, "gouraud"},
                                              Frequency{ShadingFrequency::phong, "phong"}}) {
            add(name, colors_of(shown(draw(frequency, visibility, bug, 0)), cut));
            if (frequency != in_force) continue;
            const Target target = draw(frequency, visibility, bug, shaded_plane::count);
            struct Term {
                int plane;
                const char* name;
            };
            for (const Term& term : {Term{shaded_plane::ambient, "ambient"}, Term{shaded_plane::diffuse, "diffuse"},
                                     Term{shaded_plane::specular, "specular"}}) {
                add(term.name, picture_of(target, cut, [&](std::size_t i, int c) {
                        return to_unorm8(shown_value(target.extra(term.plane + c)[i], display));
                    }));
            }
        }
        add("painter", colors_of(shown(draw(in_force, Visibility::painter, bug, 0)), cut));
        if (visibility == Visibility::painter)
            add("zbuffer", colors_of(shown(draw(in_force, Visibility::zbuffer, bug, 0)), cut));
        if (!bug) return;
        const Image8 right = colors_of(shown(draw(in_force, visibility, {}, 0)), cut);
        const Image8 wrong = colors_of(shown(draw(in_force, visibility, bug, 0)), cut);
        add("right", right);
        const AnyImage expected = right, actual = wrong;
        if (const Result<Diff> diff = diff_images(expected, actual)) {
            add("difference", difference_picture(expected, *diff));
            json.member("differing", diff->figures ? diff->figures->differing : 0);
        }
    });
    return status;
}

void write_mesh(JsonText& json, const Model& model, const glm::mat4& world_from_object,
                std::vector<std::string>& left_out) {
    const std::size_t count = model.triangle_count();
    const std::size_t every = (count + max_mesh_triangles - 1) / max_mesh_triangles;
    if (every > 1)
        left_out.push_back("The 3D view shows one of " + std::to_string(every) + " of the model's " +
                           std::to_string(count) + " triangles.");
    const Box box = bounding_box(model);
    const glm::vec3 extent = box.max - box.min;
    std::vector<std::uint16_t> positions, triangles;
    std::vector<std::int32_t> numbers(model.vertices.size(), -1);
    for (std::size_t t = 0; t < count; t += every) {
        for (std::size_t c = 0; c < 3; ++c) {
            const std::uint32_t v = model.indices[3 * t + c];
            if (numbers[v] < 0) {
                numbers[v] = std::int32_t(positions.size() / 3);
                for (int i = 0; i < 3; ++i) {
                    const float along = extent[i] > 0 ? (model.vertices[v].position[i] - box.min[i]) / extent[i] : 0.0f;
                    positions.push_back(std::uint16_t(std::clamp(along, 0.0f, 1.0f) * 65535.0f + 0.5f));
                }
            }
            triangles.push_back(std::uint16_t(numbers[v]));
        }
    }
    json.object("mesh", [&] {
        json.member("min", count > 0 ? box.min : glm::vec3(0.0f));
        json.member("max", count > 0 ? box.max : glm::vec3(0.0f));
        json.member("world_from_object", world_from_object);
        json.member("every", every);
        write_bytes(json, "positions", positions);
        write_bytes(json, "triangles", triangles);
    });
}

}  // namespace raster::step
