// scene_obj_testing.h: OBJ text in, model and warnings out; and a folder to put files in.
#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <stdlib.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <raster/scene/obj.h>

namespace raster::testing {

/// A loading and all that came of it.
struct Loaded {
    Result<Model> model;
    LoadReport report;

    bool ok() const { return bool(model); }
    std::string error() const { return ok() ? "" : model.error().message; }
    std::vector<std::string> warnings() const { return report.messages(); }
    std::size_t triangles() const { return ok() ? model->triangle_count() : 0; }
    glm::vec3 position(std::size_t index) const { return model->vertices[model->indices[index]].position; }
};

inline Loaded parse(const std::string& text, const ObjOptions& options = {}) {
    LoadReport report;
    Result<Model> model = parse_obj(std::as_bytes(std::span(text)), "m.obj", std::nullopt, options, report);
    return {std::move(model), std::move(report)};
}

inline Loaded load(const std::string& path, const ObjOptions& options = {}) {
    LoadReport report;
    Result<Model> model = load_obj(path, options, report);
    return {std::move(model), std::move(report)};
}

inline ObjOptions strict() {
    ObjOptions options;
    options.strict = true;
    return options;
}

/// What every loaded model promises.
inline void expect_sound(const Model& m) {
    ASSERT_GT(m.indices.size(), 0u);
    ASSERT_EQ(m.indices.size() % 3, 0u);
    for (const std::uint32_t i : m.indices) ASSERT_LT(i, m.vertices.size());
    for (const auto& v : m.vertices) {
        for (const float f :
             {v.position.x, v.position.y, v.position.z, v.uv.x, v.uv.y, v.color.x, v.color.y, v.color.z})
            ASSERT_TRUE(std::isfinite(f));
        ASSERT_NEAR(glm::length(v.normal), 1, 1e-5);
    }
    std::uint32_t next = 0;
    for (const Part& part : m.parts) {
        ASSERT_EQ(part.first_index, next);
        ASSERT_GT(part.index_count, 0u);
        ASSERT_EQ(part.index_count % 3, 0u);
        ASSERT_GE(part.material, -1);
        ASSERT_LT(part.material, int(m.materials.size()));
        next += part.index_count;
    }
    ASSERT_EQ(next, m.indices.size());
    for (const Material& material : m.materials)
        for (const int texture : {material.ambient_texture, material.diffuse_texture, material.specular_texture,
                                  material.emission_texture, material.alpha_texture})
            ASSERT_LT(texture, int(m.textures.size()));
    for (const Texture& texture : m.textures) ASSERT_FALSE(texture.image.empty());
}

/// A new folder below the system's temporary one, removed at the end.
class Folder {
public:
    Folder() {
        std::string name = (std::filesystem::temp_directory_path() / "raster-test-XXXXXX").string();
        path_ = ::mkdtemp(name.data());
    }
    Folder(const Folder&) = delete;
    ~Folder() {
        std::error_code ignored;
        std::filesystem::remove_all(path_, ignored);
    }
    std::string path(const std::string& name) const { return (path_ / name).string(); }
    /// Writes a file, and the folders it needs.
    std::string write(const std::string& name, const std::string& content) const {
        std::filesystem::create_directories((path_ / name).parent_path());
        std::ofstream(path_ / name, std::ios::binary) << content;
        return path(name);
    }

private:
    std::filesystem::path path_;
};

}  // namespace raster::testing
