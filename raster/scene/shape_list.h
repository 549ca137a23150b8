// shape_list.h: the generated shapes by name, with their parameters: what a command line or a scene file can ask for.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <raster/result.h>
#include <raster/scene/shapes.h>

namespace raster {

struct ShapeParameter {
    std::string_view name;
    double default_value, low, high;  ///< both included
    bool whole;                       ///< a count
};

struct Shape {
    std::string_view name;
    std::string_view summary;  ///< a few words
    std::vector<ShapeParameter> parameters;
    Model (*make)(std::span<const double> values);  ///< in the order of the parameters
};

/// All shapes: box, sphere, vase, teapot, ... A new one is one entry.
std::span<const Shape> shape_list();

/// Makes a shape; what `values` leaves out has its default. Errors, of kind usage: a name that there is not, a
/// parameter that it does not have, a value out of its range.
Result<Model> make_shape(std::string_view name, std::span<const std::pair<std::string, double>> values = {});

}  // namespace raster
