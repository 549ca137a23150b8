// shapes_cornell.cpp: the Cornell box from its published measurements.
//
// Geometry and camera: Cornell University Program of Computer Graphics, "Cornell Box Data". The reflectances
// were measured as spectra; the RGB values here are those that renderers commonly use for them (white, red
// and green as in Mitsuba's scene), and the light is 17 : 12 : 4.
#include <raster/scene/shapes.h>

#include <raster/scene/shapes_builder.h>

namespace raster {

Model cornell_box() {
    detail::ModelBuilder room;
    const auto material = [&](const char* name, const glm::vec3& diffuse, const glm::vec3& emission) {
        Material m;
        m.name = name;
        m.ambient = m.diffuse = diffuse;
        m.emission = emission;
        m.illumination = 1;  // no highlights
        return room.material(m);
    };
    const int white = material("white", {0.725f, 0.71f, 0.68f}, glm::vec3(0.0f));
    const int red = material("red", {0.63f, 0.065f, 0.05f}, glm::vec3(0.0f));
    const int green = material("green", {0.14f, 0.45f, 0.091f}, glm::vec3(0.0f));
    const int light = material("light", {0.78f, 0.78f, 0.78f}, {17.0f, 12.0f, 4.0f});

    room.face({552.8, 0, 0}, {0, 0, 0}, {0, 0, 559.2}, {549.6, 0, 559.2});
    room.part("floor", white);

    // Four strips from the walls to the hole: without the hole, light and ceiling would lie in one plane.
    const glm::dvec3 outer[] = {{556, 548.8, 0}, {556, 548.8, 559.2}, {0, 548.8, 559.2}, {0, 548.8, 0}};
    const glm::dvec3 hole[] = {{343, 548.8, 227}, {343, 548.8, 332}, {213, 548.8, 332}, {213, 548.8, 227}};
    for (int i = 0; i < 4; ++i) room.face(outer[i], outer[(i + 1) % 4], hole[(i + 1) % 4], hole[i]);
    room.part("ceiling", white);
    room.face(hole[0], hole[1], hole[2], hole[3]);
    room.part("light", light);

    room.face({549.6, 0, 559.2}, {0, 0, 559.2}, {0, 548.8, 559.2}, {556, 548.8, 559.2});
    room.part("back_wall", white);
    room.face({0, 0, 559.2}, {0, 0, 0}, {0, 548.8, 0}, {0, 548.8, 559.2});
    room.part("right_wall", green);
    room.face({552.8, 0, 0}, {549.6, 0, 559.2}, {556, 548.8, 559.2}, {556, 548.8, 0});
    room.part("left_wall", red);

    const auto block = [&](const glm::dvec2 (&base)[4], double height) {
        const auto at = [&](int i, double y) { return glm::dvec3(base[i % 4].x, y, base[i % 4].y); };
        room.face(at(0, height), at(1, height), at(2, height), at(3, height));
        for (int i = 0; i < 4; ++i) room.face(at(i, 0), at(i + 1, 0), at(i + 1, height), at(i, height));
    };
    block({{130, 65}, {82, 225}, {240, 272}, {290, 114}}, 165);
    room.part("short_block", white);
    block({{423, 247}, {265, 296}, {314, 456}, {472, 406}}, 330);
    room.part("tall_block", white);
    return room.take();
}

Camera cornell_camera() {
    Camera camera;
    camera.position = {278.0f, 273.0f, -800.0f};
    camera.focal_point = {278.0f, 273.0f, 0.0f};
    camera.view_angle = 39.3077f;  // 2 atan(0.025 / 2 / 0.035): a picture 25 mm high behind a lens of 35 mm
    camera.near_plane = 100.0f;
    camera.far_plane = 2000.0f;
    return camera;
}

}  // namespace raster
