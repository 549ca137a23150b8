// files.h: every file of this folder that is made by a program: its name and its bytes.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include <raster/scene/shapes.h>

#include "obj_text.h"
#include "plain_png.h"

namespace raster::models {

/// A texture that shows how it lies: 8 x 8 squares, light ones and dark ones, the dark ones redder to the
/// right and bluer upwards, and the lower left one, at u = v = 0, orange.
inline Image8 checker() {
    Image8 image(64, 64, 3);
    for (int y = 0; y < 64; ++y) {
        for (int x = 0; x < 64; ++x) {
            const int column = x / 8, row = 7 - y / 8;
            std::uint8_t* p = image.pixel(x, y);
            const bool dark = (column + row) % 2 == 0;
            p[0] = dark ? std::uint8_t(30 + 16 * column) : 235;
            p[1] = dark ? 70 : 230;
            p[2] = dark ? std::uint8_t(60 + 20 * row) : 215;
            if (column == 0 && row == 0) p[0] = 240, p[1] = 130, p[2] = 20;
        }
    }
    return image;
}

/// A cube with that texture on every face.
inline Model checker_cube() {
    Model model = cube();
    Material material;
    material.name = "checker";
    material.ambient = material.diffuse = glm::vec3(1.0f);
    material.specular = glm::vec3(0.2f);
    material.diffuse_texture = 0;
    model.materials.push_back(material);
    model.textures.push_back({"checker.png", checker()});
    model.parts[0].material = 0;
    return model;
}

/// A model and what its file says about itself.
struct Entry {
    std::string name;
    Model model;
    std::string title;
};

inline std::vector<Entry> entries() {
    return {
        {"cube", cube(), "A cube of side 2."},
        {"tetrahedron", tetrahedron(), "The regular tetrahedron on four corners of a cube of side 2."},
        {"sphere", sphere(32, 16), "A sphere of radius 1: 32 meridians, 16 bands."},
        {"torus", torus(0.4f, 48, 24), "A ring of radius 1 with a tube of radius 0.4."},
        {"plane", plane(8), "A square of side 2, 8 x 8 quads, facing up."},
        {"bowl", bowl(32, 8), "The lower half of a sphere of radius 1, open, its front outside."},
        {"teapot", teapot(10),
         "The Utah teapot: Martin Newell's 32 Bezier patches (University of Utah, 1975)."},
        {"cornell_box", cornell_box(),
         "The Cornell box as measured by the Cornell University Program of Computer Graphics.\n"
         "# Camera: position 278 273 -800, focal point 278 273 0, view angle 39.3 degrees, square picture."},
        {"cyclic_trio", cyclic_trio(),
         "Three triangles, each partly in front of the next: no order of painting is right."},
        {"checker_cube", checker_cube(), "A cube of side 2 with a texture on every face."},
    };
}

/// File names and contents.
inline std::vector<std::pair<std::string, std::string>> all_files() {
    std::vector<std::pair<std::string, std::string>> files;
    for (const Entry& e : entries()) {
        const std::string comment =
            "# " + e.title + "\n# Made by models/generate.cpp of raster; see models/README.md.\n";
        files.emplace_back(e.name + ".obj", obj_text(e.model, comment, e.name + ".mtl"));
        if (!e.model.materials.empty()) files.emplace_back(e.name + ".mtl", mtl_text(e.model, comment));
    }
    files.emplace_back("checker.png", plain_png(checker()));
    return files;
}

}  // namespace raster::models
