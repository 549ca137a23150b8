// models_test.cpp: the files in models/ are what their generator makes, and the loader gives the models back.
#include "../models/files.h"

#include <array>
#include <filesystem>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include <raster/image/file.h>
#include <raster/math.h>
#include <raster/scene/obj.h>
#include <raster/testing/matchers.h>

#include "random.h"

namespace raster::models {
namespace {

const std::string folder = std::string(RASTER_SOURCE_DIR) + "/models/";

std::string read(const std::string& name) {
    const auto bytes = read_file(folder + name, std::size_t(1) << 24);
    if (!bytes) return "";
    return {reinterpret_cast<const char*>(bytes->data()), bytes->size()};
}

TEST(Models, CommittedFilesAreByteForByteWhatTheGeneratorMakes) {
    for (const auto& [name, bytes] : all_files()) {
        const std::string committed = read(name);
        ASSERT_FALSE(committed.empty()) << name << " is missing; run raster_models " << folder;
        std::size_t at = 0;
        while (at < bytes.size() && at < committed.size() && bytes[at] == committed[at]) ++at;
        EXPECT_TRUE(bytes == committed) << name << " differs at byte " << at << "; run raster_models";
    }
}

TEST(Models, EveryModelFileInTheFolderHasAGenerator) {
    std::set<std::string> made;
    for (const auto& [name, bytes] : all_files()) made.insert(name);
    std::uintmax_t total = 0;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        total += entry.file_size();
        const std::string name = entry.path().filename().string(), suffix = entry.path().extension().string();
        if (suffix == ".obj" || suffix == ".mtl" || suffix == ".png") {
            EXPECT_EQ(made.count(name), 1u) << name;
        }
    }
    EXPECT_LT(total, 1500000u) << "the folder stays small";
}

TEST(Models, TheLoaderGivesBackTheSameFloats) {
    for (const Entry& e : entries()) {
        SCOPED_TRACE(e.name);
        LoadReport report;
        ObjOptions options;
        options.strict = true;
        const auto loaded = load_obj(folder + e.name + ".obj", options, report);
        ASSERT_TRUE(loaded) << loaded.error().message;
        EXPECT_TRUE(report.messages().empty()) << report.messages().front();
        EXPECT_FALSE(report.made_normals);
        ASSERT_EQ(loaded->indices.size(), e.model.indices.size());
        for (std::size_t i = 0; i < e.model.indices.size(); ++i) {
            const auto& made = e.model.vertices[e.model.indices[i]];
            const auto& read = loaded->vertices[loaded->indices[i]];
            ASSERT_EQ(made.position, read.position);
            ASSERT_EQ(made.uv, read.uv);
            // The loader brings normals to unit length, which may move the last bit.
            for (int k = 0; k < 3; ++k) ASSERT_NEAR(made.normal[k], read.normal[k], 1.2e-7);
        }
        ASSERT_EQ(loaded->parts.size(), e.model.parts.size());
        for (std::size_t i = 0; i < e.model.parts.size(); ++i) {
            EXPECT_EQ(loaded->parts[i].name, e.model.parts[i].name);
            EXPECT_EQ(loaded->parts[i].index_count, e.model.parts[i].index_count);
            if (e.model.parts[i].material < 0) continue;
            const Material& made = e.model.materials[e.model.parts[i].material];
            const Material& read = loaded->materials[loaded->parts[i].material];
            EXPECT_EQ(made.name, read.name);
            EXPECT_EQ(made.ambient, read.ambient);
            EXPECT_EQ(made.diffuse, read.diffuse);
            EXPECT_EQ(made.specular, read.specular);
            EXPECT_EQ(made.emission, read.emission);
            EXPECT_EQ(made.illumination, read.illumination);
        }
    }
}

TEST(Models, TheCheckerIsReadAsItWasMadeAndShowsItsLowerLeftCorner) {
    LoadReport report;
    const auto loaded = load_obj(folder + "checker_cube.obj", {}, report);
    ASSERT_TRUE(loaded);
    ASSERT_EQ(loaded->textures.size(), 1u);
    const Image8& image = loaded->textures[0].image;
    EXPECT_EQ(image, checker());
    const std::uint8_t* lower_left = image.pixel(0, image.height - 1);
    EXPECT_EQ(lower_left[0], 240);
    EXPECT_EQ(lower_left[1], 130);
    EXPECT_EQ(lower_left[2], 20);
    std::set<std::array<int, 3>> colors;
    for (int i = 0; i < 64; ++i) {
        const std::uint8_t* p = image.pixel(i % 8 * 8, i / 8 * 8);
        colors.insert({p[0], p[1], p[2]});
    }
    EXPECT_EQ(colors.size(), 32u + 1u) << "every dark square has a colour of its own";
}

TEST(Models, NumbersAreTheShortestThatReadBackTheSame) {
    EXPECT_EQ(number(0.1f), "0.1");
    EXPECT_EQ(number(3.0f), "3");
    EXPECT_EQ(number(-552.8f), "-552.8");
    testing::Random random(1);
    for (int i = 0; i < 20000; ++i) {
        const float x = random.uniform(-2.0f, 2.0f);
        ASSERT_EQ(std::stof(number(x)), x) << number(x);
    }
}

TEST(Models, TheReadmeNamesEveryFileAndItsTriangles) {
    const std::string readme = read("README.md");
    for (const auto& [name, bytes] : all_files())
        EXPECT_NE(readme.find("`" + name + "`"), std::string::npos) << name;
    for (const Entry& e : entries()) {
        const std::size_t begin = readme.find("| `" + e.name + ".obj`");
        ASSERT_NE(begin, std::string::npos) << e.name;
        const std::string row = readme.substr(begin, readme.find('\n', begin) - begin);
        EXPECT_NE(row.find("| " + std::to_string(e.model.triangle_count()) + " |"), std::string::npos) << row;
    }
}

}  // namespace
}  // namespace raster::models
