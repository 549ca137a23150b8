// end_to_end.h: whole processes, from an OBJ file to a PNG file: `raster render` against OSMesa and stb_image_write.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "scenes.h"

namespace bench {

/// The rival's process: draws the scene once and writes it by stb_image_write as that is. False where either fails.
bool write_rival_picture(const Scene& scene, int width, int height, const std::string& path);

/// Runs the `raster` command and `rival`, each a shell command but for its output file, `runs` times in turn; milliseconds
/// on the clock of the best runs, and their ratio.
nlohmann::json end_to_end(const std::string& ours, const std::string& rival, int runs);

}  // namespace bench
