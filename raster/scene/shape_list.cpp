// shape_list.cpp: the table of shapes.
#include <raster/scene/shape_list.h>

#include <algorithm>
#include <charconv>
#include <cmath>

namespace raster {
namespace {

using Values = std::span<const double>;

ShapeParameter count(std::string_view name, double value, double low, double high = 1024) {
    return {name, value, low, high, true};
}
ShapeParameter length(std::string_view name, double value, double low = 1e-6, double high = 1e6) {
    return {name, value, low, high, false};
}

std::string number(double value) {
    char text[32];
    return {text, std::to_chars(text, text + sizeof text, value).ptr};
}

Error usage(const std::string& text) { return {ErrorKind::usage, text}; }

std::string names_of(const auto& list) {
    std::string names;
    for (const auto& item : list) names += (names.empty() ? "" : ", ") + std::string(item.name);
    return names.empty() ? "nothing to choose" : names;
}

}  // namespace

std::span<const Shape> shape_list() {
    static const std::vector<Shape> list = {
        {"box", "around the origin",
         {length("width", 2), length("height", 2), length("depth", 2), count("divisions", 1, 1, 256)},
         [](Values v) {
             const glm::vec3 half = glm::vec3(glm::dvec3(v[0], v[1], v[2]) * 0.5);
             return box(-half, half, int(v[3]));
         }},
        {"bowl", "the lower half of a sphere, open",
         {count("segments", 48, 3), count("rings", 12, 1)},
         [](Values v) { return bowl(int(v[0]), int(v[1])); }},
        {"cornell_box", "as measured, in millimetres", {}, [](Values) { return cornell_box(); }},
        {"cyclic_trio", "three triangles, each in front of the next", {}, [](Values) { return cyclic_trio(); }},
        {"cylinder", "radius 1, height 2, closed",
         {count("segments", 96, 3)},
         [](Values v) { return cylinder(int(v[0])); }},
        {"icosphere", "radius 1, even triangles",
         {count("divisions", 8, 1, 256)},
         [](Values v) { return icosphere(int(v[0])); }},
        {"plane", "the square from -1 to 1, facing up",
         {count("divisions", 8, 1)},
         [](Values v) { return plane(int(v[0])); }},
        {"sphere", "radius 1, meridians and parallels",
         {count("segments", 96, 3), count("rings", 48, 2)},
         [](Values v) { return sphere(int(v[0]), int(v[1])); }},
        {"teapot", "the Utah teapot",
         {count("subdivisions", 10, 1, 256)},
         [](Values v) { return teapot(int(v[0])); }},
        {"tetrahedron", "on corners of the cube from -1 to 1", {}, [](Values) { return tetrahedron(); }},
        {"torus", "radius 1 around the y axis",
         {length("tube", 0.4, 0.001, 0.999), count("segments", 64, 3), count("sides", 32, 3)},
         [](Values v) { return torus(float(v[0]), int(v[1]), int(v[2])); }},
        {"vase", "2.4 high, with a wall",
         {count("segments", 96, 3), count("steps", 8, 1, 64)},
         [](Values v) { return vase(int(v[0]), int(v[1])); }},
    };
    return list;
}

Result<Model> make_shape(std::string_view name, std::span<const std::pair<std::string, double>> values) {
    const auto shape = std::ranges::find(shape_list(), name, &Shape::name);
    if (shape == shape_list().end())
        return usage("there is no shape '" + std::string(name) + "', but " + names_of(shape_list()));
    std::vector<double> all;
    for (const ShapeParameter& p : shape->parameters) all.push_back(p.default_value);
    for (const auto& [key, value] : values) {
        const auto p = std::ranges::find(shape->parameters, key, &ShapeParameter::name);
        if (p == shape->parameters.end())
            return usage("the shape " + std::string(name) + " has no '" + key + "', but " +
                         names_of(shape->parameters));
        if (!(value >= p->low && value <= p->high) || (p->whole && value != std::floor(value)))
            return usage(key + " of the shape " + std::string(name) + " is " + (p->whole ? "a whole number " : "") +
                         "from " + number(p->low) + " to " + number(p->high) + ", not " + number(value));
        all[std::size_t(p - shape->parameters.begin())] = value;
    }
    return shape->make(all);
}

}  // namespace raster
