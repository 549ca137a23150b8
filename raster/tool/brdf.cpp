// brdf.cpp: `raster brdf`: tables of materials in the MERL layout, whole or of a few principal components.
#include <cstdio>

#include <raster/image/file.h>
#include <raster/scene/material_model.h>
#include <raster/shading/materials.h>
#include <raster/shading/measured_bake.h>

#include "commands.h"
#include "flags.h"
#include "report.h"
#include "parse.h"
#include "specs.h"

namespace raster::tool {
namespace {

constexpr int max_components = 64;

struct BrdfArguments {
    std::vector<std::string> materials;
    std::string output;
    MeasuredSize size;
    std::optional<int> components;
    bool quiet = false;
};

Result<MeasuredSize> parse_table_size(std::string_view text) {
    const std::vector<std::string_view> parts = split(text, 'x');
    const auto expected = in_quotes(text) + " is not HxDxP, three whole numbers from 2 to 360";
    if (parts.size() != 3) return Error{ErrorKind::usage, expected};
    int n[3];
    for (std::size_t i = 0; i < 3; ++i) {
        const Result<int> count = parse_count(parts[i], 2, 360);
        if (!count) return Error{ErrorKind::usage, expected};
        n[i] = *count;
    }
    const MeasuredSize size{n[0], n[1], n[2]};
    if (size.cells() > max_measured_cells) return Error{ErrorKind::usage, in_quotes(text) + " has too many cells"};
    return size;
}

/// A table file as it is, anything else as --material takes it, baked.
Result<MeasuredTable> table_of(const std::string& text, const MeasuredSize& size) {
    if (text.ends_with(".binary")) return read_measured(text);
    const Result<MaterialChange> change = parse_material(text);
    if (!change) return change.error();
    Material material = default_material();
    change->apply_to(material);
    material = physically_based(material);
    const AnyReflectance asked = find_reflectance(material.reflectance).value_or(BlinnPhong{});
    const AnyReflectance model = RuntimeModel{asked}.with_material(material).model;
    const MaterialModel finished = finish(material, model);
    return bake_measured(finished.reflectance, material.diffuse, finished.specular, size);
}

Result<int> run_brdf(const BrdfArguments& a) {
    if (!a.components && a.materials.size() > 1)
        return Error{ErrorKind::usage, in_quotes(a.materials[1]) + " is one material too many without --components"};
    if (a.output.empty()) return Error{ErrorKind::usage, "--output is required: the table's file"};
    if (const Status status = check_writable(a.output); !status) return status.error();
    std::vector<MeasuredTable> tables;
    for (const std::string& material : a.materials) {
        Result<MeasuredTable> table = table_of(material, a.size);
        if (!table) return table.error();
        if (!tables.empty() && table->size != tables[0].size)
            return Error{ErrorKind::usage, in_quotes(material) + " has another size than " + in_quotes(a.materials[0])};
        tables.push_back(std::move(*table));
    }
    MeasuredTable& first = tables[0];
    std::string line = a.output + ": " + std::to_string(first.size.theta_h) + "x" + std::to_string(first.size.theta_d) +
                       "x" + std::to_string(first.size.phi_d) + " cells";
    if (a.components) {
        const MeasuredBasis basis(tables);
        const auto count = std::min(std::size_t(*a.components), basis.components());
        MeasuredTable few = basis.reconstruct(basis.project(first), count);
        char text[128];
        std::snprintf(text, sizeof text, ", %zu of %zu components with %.3f of the variance, relative error %.4f",
                      count, basis.components(), basis.variance(count), relative_error(first, few));
        line += text;
        first = std::move(few);
    }
    if (const Status status = write_measured(a.output, first); !status) return status.error();
    if (!a.quiet) say(line);
    return exit_done;
}

}  // namespace

Run add_brdf(CLI::App& app) {
    const auto a = std::make_shared<BrdfArguments>();
    app.add_option("MATERIAL", a->materials,
                   "A material as --material of `raster render` takes it, or the .binary file of a table. With"
                   " --components several, of which the first is written.")
        ->required()
        ->group("Arguments");
    add_value(app, "-o,--output", "FILE", a->output, parse_path,
              "The table, in the layout of the MERL database; 35 MB at the full size. `--material brdf=FILE` draws it.")
        ->group("Table");
    add_value(app, "--table-size", "HxDxP", a->size, parse_table_size,
              "Cells of the half angle, of the difference angle and of the difference's azimuth. [90x90x180, the"
              " database's]")
        ->group("Table");
    const auto count = [](std::string_view text) { return parse_count(text, 0, max_components); };
    add_value(app, "--components", "K", a->components, count,
              "Write what the first K principal components of all the materials keep of the first one, 0 to 64, and say"
              " the error.")
        ->group("Table");
    add_switch(app, "-q,--quiet", a->quiet, "Say nothing but errors.")->group("Other flags");
    app.footer(
        "Examples:\n"
        "  raster brdf gold:roughness=0.2 -o gold.binary\n"
        "  raster render teapot.obj --material brdf=gold.binary\n"
        "  raster brdf gold silver copper iron plastic -o gold2.binary --components 2");
    return [a] { return run_brdf(*a); };
}

}  // namespace raster::tool
