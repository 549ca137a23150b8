// obj.h: Wavefront OBJ and MTL files into a Model, whatever is in them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <raster/image/limits.h>
#include <raster/result.h>
#include <raster/scene/model.h>

namespace raster {

struct ObjOptions {
    /// A fault in the data is an error with its line, instead of a warning.
    bool strict = false;
    /// Material files and textures may lie outside the model's folder: absolute paths, `..`, symbolic links.
    /// Folders, FIFOs and devices stay refused.
    bool allow_outside = false;
    /// For faces without normals: edges sharper than this many degrees (0 to 180) stay sharp. Without a value, 60
    /// where the file has no smoothing groups, and inside a group all is smooth.
    std::optional<float> crease_angle;
    bool load_textures = true;

    /// What goes beyond these is refused before the memory for it is taken. A grid of 2 million triangles takes
    /// 320 MB at the peak of loading, one of 10 million 1.6 GB: about 160 bytes a triangle. Where no two corners are
    /// alike it can be 400 bytes.
    std::size_t max_file_bytes = sizeof(std::size_t) > 4 ? std::size_t(std::uint64_t(4) << 30) : SIZE_MAX;
    std::size_t max_triangles = 16'000'000;
    std::size_t max_line_bytes = std::size_t(4) << 20;       ///< after continuations are joined; comments are free
    std::size_t max_material_bytes = std::size_t(16) << 20;  ///< of one MTL file
    std::size_t max_texture_bytes = std::size_t(1) << 30;    ///< decoded, of all textures together
    ImageLimits texture_limits;

    /// Called now and then with the part that is done: from 0, never falling, 1 at the end. May be empty.
    std::function<void(double)> progress;
};

/// One kind of fault, however often it was met.
struct LoadWarning {
    std::string file;      ///< the OBJ, MTL or texture file it is about
    std::size_t line = 0;  ///< of the first, from 1; 0 if it is about the file as a whole
    std::size_t count = 1;
    std::string text;    ///< "face dropped: zero area"
    std::string plural;  ///< "faces dropped: zero area"; empty for a fault with a name in its text

    /// "bunny.obj: 3 faces dropped: zero area (first at line 12)", "bunny.obj:7: unknown material 'gold' (4 times)"
    std::string message() const;
};

/// What was found while loading, filled also when loading fails.
struct LoadReport {
    std::vector<LoadWarning> warnings;  ///< in the order of their first occurrence
    std::size_t warnings_left_out = 0;  ///< kinds beyond the first 100, as binary junk has them

    std::size_t positions = 0;            ///< v statements
    std::size_t texture_coordinates = 0;  ///< vt
    std::size_t normals = 0;              ///< vn
    std::size_t faces = 0;                ///< f, dropped ones included
    std::size_t dropped_faces = 0;
    std::size_t lines = 0;   ///< l statements, not drawn
    std::size_t points = 0;  ///< p statements, not drawn
    bool has_vertex_colors = false;
    bool made_normals = false;  ///< for some corner at least

    /// All warnings as text, one a line, without line ends.
    std::vector<std::string> messages() const;
};

/// Loads an OBJ file with its materials and textures.
///
/// The report is an argument, and no part of the result, because it matters most when there is no result.
///
/// What a Model made here always satisfies: all numbers are finite, all indices in range, normals have unit
/// length, no triangle has zero area, there is at least one triangle. Triangles stand in the order of the file;
/// equal vertices are one. Texture coordinates that are missing are (0, 0), colours white; colours that are given are
/// taken as they are. A new part starts where
/// the material or the last o or g name changes.
///
/// Faults in the data give warnings, or errors with ObjOptions::strict. Always errors are: a file that cannot be
/// read (input_output), an option out of range (usage), a position index that is 0, out of range or no number, a
/// line beyond the limit, too many triangles, and no drawable geometry (bad_input). The message of an error starts
/// with FILE: or FILE:LINE:. A texture that cannot be used becomes `missing_texture()`.
///
/// The result depends on the bytes of the files only: not on the locale, not on the machine.
Result<Model> load_obj(const std::string& path, const ObjOptions& options, LoadReport& report);

/// The same for bytes in memory. `name` is for messages. `folder` is where materials and textures are looked for;
/// without one none are opened.
Result<Model> parse_obj(std::span<const std::byte> bytes, const std::string& name,
                        const std::optional<std::string>& folder, const ObjOptions& options, LoadReport& report);

/// What stands in for a texture that is missing or cannot be used: 8x8 pixels, magenta and black by turns.
Image8 missing_texture();

}  // namespace raster
