// catalogue_primitives.cpp: scenes about what is drawn.
#include <raster/math.h>

#include "catalogue_parts.h"

namespace raster::conformance {

namespace {

template <Group group>
Scene group_scene(std::uint64_t seed) {
    Random random(seed);
    Scene scene = empty_scene(random);
    for (int i = 0; i < 3; ++i) {
        scene.draws.push_back(make_draw(group, random, 16, scene.width, scene.height));
        scene.draws.back().state.blend = random_blend(random);
    }
    return scene;
}

template <Coloring coloring>
Scene coloring_scene(std::uint64_t seed) {
    Random random(seed);
    Scene scene = empty_scene(random);
    for (int i = 0; i < 4; ++i) {
        const Group group = random_group(random, coloring == Coloring::noperspective);
        scene.draws.push_back(make_draw(group, random, 8, scene.width, scene.height, coloring));
    }
    return scene;
}

Texture random_texture(Random& random, Filter filter) {
    Texture texture;
    const bool power_of_two = random.integer(0, 1);
    const auto size = [&] { return power_of_two ? 1 << random.integer(0, 6) : random.integer(1, 70); };
    texture.image.width = size();
    texture.image.height = size();
    for (int i = 0; i < texture.image.width * texture.image.height; ++i)
        texture.image.texels.push_back(std::int32_t(std::uint32_t(random.bits())));
    texture.wrap = Wrap(random.integer(0, 2));
    texture.filter = filter;
    return texture;
}

template <Filter filter>
Scene textured_scene(std::uint64_t seed) {
    Random random(seed);
    Scene scene = empty_scene(random);
    for (int i = 0; i < 3; ++i) {
        scene.draws.push_back(
            make_draw(random_group(random), random, 6, scene.width, scene.height, Coloring::textured));
        scene.draws.back().texture = random_texture(random, filter);
        scene.draws.back().state.blend = filter == Filter::nearest ? random_blend(random) : Blend::off;
    }
    return scene;
}

template <Blend blend>
Scene blend_scene(std::uint64_t seed) {
    Random random(seed);
    Scene scene = empty_scene(random);
    scene.draws = {make_draw(random_group(random), random, 60, scene.width, scene.height)};
    scene.draws[0].state.blend = blend;
    scene.draws[0].state.depth_compare = Compare::always;
    return scene;
}

/// Closed fans of one flat colour, added up: where a pixel got more than one layer of a fan, the colour tells.
Scene fan_scene(std::uint64_t seed) {
    Random random(seed);
    Scene scene = empty_scene(random);
    for (int i = 0; i < 4; ++i) {
        Draw draw;
        draw.state.topology = Topology::triangle_fan;
        draw.state.blend = Blend::additive;
        draw.state.depth_compare = Compare::always;
        const float x = random.uniform(0, float(scene.width)), y = random.uniform(0, float(scene.height));
        const float radius = random.uniform(1, float(scene.height));
        const int sides = random.integer(3, 40);
        const auto add = [&](float dx, float dy) {
            const float w = random.uniform(0.5f, 4);
            const glm::vec4 position = raster::testing::clip_at(x + dx, y + dy, 0, w, scene.width, scene.height);
            draw.vertices.push_back({position, glm::vec4(float(1 << i) * 16 / 255.0f), {0, 0}});
        };
        add(0, 0);
        for (int side = 0; side < sides; ++side) {
            const float angle = float(side) * 6.2831853f / float(sides);
            add(radius * raster::cos(angle), radius * raster::sin(angle));
        }
        draw.vertices.push_back(draw.vertices[1]);
        scene.draws.push_back(draw);
    }
    return scene;
}

Scene topology_scene(std::uint64_t seed) {
    Random random(seed);
    Scene scene = empty_scene(random);
    for (int i = 0; i < 4; ++i) {
        const Coloring coloring = random.integer(0, 1) ? Coloring::smooth : Coloring::flat;
        Draw draw = make_draw(random_group(random), random, 5, scene.width, scene.height, coloring);
        draw.state.topology = Topology(random.integer(0, 2));
        if (random.integer(0, 1))
            for (int index = 0; index < 12; ++index)
                draw.indices.push_back(std::uint32_t(random.integer(0, int(draw.vertices.size()) - 1)));
        scene.draws.push_back(draw);
    }
    return scene;
}

/// Lines or points of one kind, with their widths and sizes, in small targets now and then.
template <Topology first, Topology last>
Scene stroke_scene(std::uint64_t seed) {
    Random random(seed);
    Scene scene = empty_scene(random);
    if (random.integer(0, 3) == 0) scene.width = random.integer(1, 500), scene.height = random.integer(1, 300);
    for (int i = 0; i < 3; ++i) {
        const Coloring coloring = random.integer(0, 3) ? Coloring::smooth : Coloring::flat;
        Draw draw = make_draw(random_group(random), random, 10, scene.width, scene.height, coloring);
        draw.state.topology = Topology(random.integer(int(first), int(last)));
        draw.state.line_width = random.integer(1, 5);
        draw.state.point_size = random.integer(0, 1) ? float(random.integer(1, 7)) : random.uniform(0.5f, 7.4f);
        draw.state.blend = random_blend(random);
        Viewport& v = draw.state.viewport;
        if (random.integer(0, 3) == 0) {
            v.x = random.integer(0, scene.width / 2), v.y = random.integer(0, scene.height / 2);
            v.width = random.integer(1, scene.width), v.height = random.integer(1, scene.height);
        }
        scene.draws.push_back(draw);
    }
    return scene;
}

}  // namespace

std::vector<Kind> primitive_kinds() {
    return {
        {"big", group_scene<Group::big>},
        {"perspective", group_scene<Group::perspective>},
        {"small", group_scene<Group::small>},
        {"slivers", group_scene<Group::slivers>},
        {"half_pixel_grid", group_scene<Group::half_pixel_grid>},
        {"ties", group_scene<Group::ties>},
        {"axis_aligned", group_scene<Group::axis_aligned>},
        {"clip_near", group_scene<Group::clip_near>},
        {"clip_far", group_scene<Group::clip_far>},
        {"clip_sides", group_scene<Group::clip_sides>},
        {"clip_all", group_scene<Group::clip_all>},
        {"clip_slivers", group_scene<Group::clip_slivers>},
        {"collinear", group_scene<Group::collinear>},
        {"huge", group_scene<Group::huge>},
        {"flat", coloring_scene<Coloring::flat>},
        {"noperspective", coloring_scene<Coloring::noperspective>},
        {"fixed_function", coloring_scene<Coloring::fixed_function>},
        {"textured_nearest", textured_scene<Filter::nearest>},
        {"source_over", blend_scene<Blend::source_over>},
        {"additive", blend_scene<Blend::additive>},
        {"fans", fan_scene},
        {"strips_and_fans", topology_scene},
        {"lines", stroke_scene<Topology::lines, Topology::lines>},
        {"line_strips_and_loops", stroke_scene<Topology::line_strip, Topology::line_loop>},
        {"points", stroke_scene<Topology::points, Topology::points>},
    };
}

const std::vector<Kind>& close_kinds() {
    static const std::vector<Kind> kinds = {{"textured_bilinear", textured_scene<Filter::bilinear>}};
    return kinds;
}

}  // namespace raster::conformance
