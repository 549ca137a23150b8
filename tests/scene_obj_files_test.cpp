// scene_obj_files_test.cpp: OBJ files that others wrote: those of Debian's packages. Skipped where one is absent.
#include "scene_obj_testing.h"

namespace raster {
namespace {

using ::testing::ElementsAre;
using testing::expect_sound;
using ::testing::HasSubstr;
using testing::Loaded;

/// What a file must give: triangles and parts, or an error with this text; and how many warnings.
struct Expected {
    const char* file;
    std::size_t triangles, parts, materials, textures, warnings;
    const char* error = "";
};

void check(const std::string& folder, const Expected& expected) {
    const std::string path = folder + "/" + expected.file;
    SCOPED_TRACE(path);
    if (!std::filesystem::exists(path)) GTEST_SKIP() << path << " is not installed";
    const Loaded l = testing::load(path);
    EXPECT_EQ(l.report.warnings.size(), expected.warnings) << ::testing::PrintToString(l.warnings());
    if (*expected.error != '\0') {
        EXPECT_FALSE(l.ok());
        EXPECT_THAT(l.error(), HasSubstr(path + ":"));
        EXPECT_THAT(l.error(), HasSubstr(expected.error));
        return;
    }
    ASSERT_TRUE(l.ok()) << l.error();
    expect_sound(*l.model);
    EXPECT_EQ(l.triangles(), expected.triangles);
    EXPECT_EQ(l.model->parts.size(), expected.parts);
    EXPECT_EQ(l.model->materials.size(), expected.materials);
    EXPECT_EQ(l.model->textures.size(), expected.textures);
}

class ObjFiles : public ::testing::TestWithParam<Expected> {};

const std::string assimp = "/usr/share/assimp/models";

TEST_P(ObjFiles, LoadOrFailClearly) { check(assimp, GetParam()); }

// Counted in the files themselves, not by this program: triangles are corners - 2 a face, less those without area.
INSTANTIATE_TEST_SUITE_P(
    Assimp, ObjFiles,
    ::testing::Values(
        Expected{"OBJ/WusonOBJ.obj", 3732, 1, 0, 0, 0}, Expected{"OBJ/box.obj", 12, 1, 0, 0, 1},
        Expected{"OBJ/box_UTF16BE.obj", 0, 0, 0, 0, 0, "no drawable geometry: this is UTF-16 text"},
        // One face goes around its four corners more than a hundred times.
        Expected{"OBJ/box_longline.obj", 478, 1, 0, 0, 1}, Expected{"OBJ/box_mat_with_spaces.obj", 12, 1, 12, 0, 0},
        Expected{"OBJ/box_without_lineending.obj", 12, 1, 0, 0, 1}, Expected{"OBJ/concave_polygon.obj", 64, 1, 1, 0, 1},
        // It names a file that ends with .mat and is not there.
        Expected{"OBJ/cube_mtllib_after_g.obj", 12, 1, 0, 0, 2}, Expected{"OBJ/cube_usemtl.obj", 12, 4, 2, 0, 1},
        Expected{"OBJ/cube_with_vertexcolors.obj", 12, 1, 0, 0, 0},
        Expected{"OBJ/cube_with_vertexcolors_uni.obj", 12, 1, 0, 0, 0}, Expected{"OBJ/empty_mat.obj", 256, 1, 1, 0, 0},
        Expected{"OBJ/multiple_spaces.obj", 1, 1, 0, 0, 0},
        // Its only face is three points of one line; six vertices are spelt like 3.1+e2.
        Expected{"OBJ/number_formats.obj", 0, 0, 0, 0, 2, "its only face was dropped: zero area (line 23)"},
        Expected{"OBJ/point_cloud.obj", 0, 0, 0, 0, 0, "no drawable geometry: no faces"},
        Expected{"OBJ/regr01.obj", 2706, 55, 12, 0, 1}, Expected{"OBJ/regr_3429812.obj", 4, 3, 1, 0, 1},
        Expected{"OBJ/space_in_material_name.obj", 64, 1, 1, 0, 1}, Expected{"OBJ/spider.obj", 1312, 19, 5, 4, 2},
        Expected{"OBJ/testline.obj", 0, 0, 0, 0, 0, "no drawable geometry: no faces, only 6 lines"},
        Expected{"OBJ/testmixed.obj", 12, 1, 0, 0, 1},
        Expected{"OBJ/testpoints.obj", 0, 0, 0, 0, 0, "no drawable geometry: no faces, only 0 lines and 6 points"},
        Expected{"invalid/empty.obj", 0, 0, 0, 0, 0, "no drawable geometry: the file is empty"},
        Expected{"invalid/malformed.obj", 0, 0, 0, 0, 0, ":28: '0' is not the number of a vertex"},
        Expected{"invalid/malformed2.obj", 10, 1, 0, 0, 2}),
    [](const auto& test) {
        std::string name = test.param.file;
        for (char& c : name)
            if (!std::isalnum(static_cast<unsigned char>(c))) c = '_';
        return name;
    });

TEST(ObjFile, Bunny) { check("/usr/share/glmark2/models", {"bunny.obj", 69666, 1, 0, 0, 0}); }

TEST(ObjFile, CornellBox) { check("/usr/share/doc/embree3/models", {"cornell_box.obj", 34, 7, 5, 0, 0}); }

TEST(ObjFile, TheSpidersTexturesAreNamedByTheWindowsWay) {
    const std::string path = assimp + "/OBJ/spider.obj";
    if (!std::filesystem::exists(path)) GTEST_SKIP() << path << " is not installed";
    const Loaded l = testing::load(path);
    ASSERT_TRUE(l.ok());
    for (const Texture& texture : l.model->textures) EXPECT_NE(texture.image, missing_texture()) << texture.name;
    EXPECT_THAT(l.warnings(), ElementsAre(HasSubstr("1 normal without a direction, taken for missing (line 1560)"),
                                          HasSubstr("56 faces dropped: zero area (first at line 2902)")));
}

TEST(ObjFile, AConcavePolygonKeepsItsArea) {
    const std::string path = assimp + "/OBJ/concave_polygon.obj";
    if (!std::filesystem::exists(path)) GTEST_SKIP() << path << " is not installed";
    const Loaded l = testing::load(path);
    ASSERT_TRUE(l.ok());
    // A ring in the plane x = -1.146, reached by a bridge. No two triangles overlap if each turns the same way and
    // their areas add up to that of the ring, which the shoelace formula gives for the 66 corners of the file.
    double area = 0;
    for (std::size_t i = 0; i < l.model->indices.size(); i += 3) {
        const glm::dvec3 a(l.position(i)), b(l.position(i + 1)), c(l.position(i + 2));
        const double twice = glm::cross(b - a, c - a).x;
        EXPECT_GT(twice, 0) << "triangle " << i / 3;
        area += twice / 2;
    }
    EXPECT_NEAR(area, 0.2454967, 1e-6);
}

}  // namespace
}  // namespace raster
