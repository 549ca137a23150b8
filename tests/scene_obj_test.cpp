// scene_obj_test.cpp: OBJ text to models: numbers, indices, faces and polygons, and what bad ones must give.
#include <cstring>

#include "random.h"
#include "scene_obj_testing.h"

namespace raster {
namespace {

using ::testing::ElementsAre;
using testing::expect_sound;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using testing::Loaded;
using testing::parse;
using testing::strict;

const std::string triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";  // lines 1 to 3

/// The same model, up to nothing.
void expect_same(const Model& a, const Model& b) {
    ASSERT_EQ(a.vertices.size(), b.vertices.size());
    EXPECT_EQ(std::memcmp(a.vertices.data(), b.vertices.data(), a.vertices.size() * sizeof a.vertices[0]), 0);
    EXPECT_EQ(a.indices, b.indices);
    ASSERT_EQ(a.parts.size(), b.parts.size());
    for (std::size_t i = 0; i < a.parts.size(); ++i) {
        EXPECT_EQ(a.parts[i].name, b.parts[i].name);
        EXPECT_EQ(a.parts[i].index_count, b.parts[i].index_count);
    }
}

TEST(Obj, ATriangle) {
    const Loaded l = parse(triangle + "f 1 2 3\n");
    ASSERT_TRUE(l.ok()) << l.error();
    EXPECT_THAT(l.warnings(), IsEmpty());
    expect_sound(*l.model);
    EXPECT_THAT(l.model->indices, ElementsAre(0u, 1u, 2u));
    EXPECT_EQ(l.position(1), glm::vec3(1, 0, 0));
    for (const auto& v : l.model->vertices) {
        EXPECT_EQ(v.normal, glm::vec3(0, 0, 1));
        EXPECT_EQ(v.uv, glm::vec2(0));
        EXPECT_EQ(v.color, glm::vec3(1));
    }
    ASSERT_EQ(l.model->parts.size(), 1u);
    EXPECT_EQ(l.model->parts[0].material, -1);
    EXPECT_EQ(l.report.positions, 3u);
    EXPECT_EQ(l.report.faces, 1u);
    EXPECT_TRUE(l.report.made_normals);
}

TEST(Obj, TextureCoordinatesNormalsAndColors) {
    const Loaded l = parse(
        "v 0 0 0 1 0 0\nv 1 0 0 0 0.5 0\nv 0 1 0\nvt 0.25 0.75\nvt 0.5\nvn 0 0 -2\n"
        "f 1/1/1 2/2/1 3//1\n");
    ASSERT_TRUE(l.ok()) << l.error();
    EXPECT_THAT(l.warnings(), IsEmpty());
    const auto& v = l.model->vertices;
    ASSERT_EQ(v.size(), 3u);
    EXPECT_EQ(v[0].uv, glm::vec2(0.25f, 0.75f));
    EXPECT_EQ(v[1].uv, glm::vec2(0.5f, 0));
    EXPECT_EQ(v[2].uv, glm::vec2(0));
    EXPECT_EQ(v[0].normal, glm::vec3(0, 0, -1));
    EXPECT_EQ(v[0].color, glm::vec3(1, 0, 0));
    EXPECT_EQ(v[1].color, glm::vec3(0, 0.5f, 0));
    EXPECT_EQ(v[2].color, glm::vec3(1));
    EXPECT_TRUE(l.report.has_vertex_colors);
    EXPECT_FALSE(l.report.made_normals);
}

TEST(Obj, VerticesAreSharedWhereAllIsEqualAndOnlyThere) {
    // Position 4 repeats position 2; normals are given, so that the seam differs by its texture coordinate only.
    const std::string quad = triangle + "v 1 0 0\nv 1 1 0\nvn 0 0 1\nvt 0 0\nvt 1 1\n";
    EXPECT_EQ(parse(quad + "f 1//1 2//1 3//1\nf 3//1 4//1 5//1\n").model->vertices.size(), 4u);
    EXPECT_EQ(parse(quad + "f 1/1/1 2/1/1 3/1/1\nf 3/1/1 4/2/1 5/1/1\n").model->vertices.size(), 5u);
}

TEST(Obj, NegativeIndicesCountBackFromWhereTheyStand) {
    const Loaded l =
        parse(triangle + "vn 0 0 1\nvn 0 0 -1\nf -3//-1 -2//-1 -1//-1\nv 5 5 5\nv 6 6 6\nf -5//1 -4//1 -3//1\n");
    ASSERT_TRUE(l.ok()) << l.error();
    EXPECT_EQ(l.position(0), l.position(3));
    EXPECT_EQ(l.position(2), glm::vec3(0, 1, 0));
    EXPECT_EQ(l.model->vertices[l.model->indices[0]].normal, glm::vec3(0, 0, -1));
    EXPECT_EQ(l.model->vertices[l.model->indices[3]].normal, glm::vec3(0, 0, 1));
}

TEST(Obj, AFaceMayComeBeforeItsVertices) {
    const Loaded l = parse("f 1 2 3\n" + triangle);
    ASSERT_TRUE(l.ok()) << l.error();
    expect_same(*l.model, *parse(triangle + "f 1 2 3\n").model);
}

// ------------------------------------------------------------------------------- numbers that are none

TEST(Obj, NotFiniteVerticesDropTheirFacesWithOneWarning) {
    for (const std::string word : {"1e999", "nan", "inf", "-inf", "x", "1,5"}) {
        const std::string text = triangle + "v 0 0 " + word + "\nf 1 2 3\nf 1 2 4\nf 2 3 4\n";
        const Loaded l = parse(text);
        ASSERT_TRUE(l.ok()) << l.error();
        expect_sound(*l.model);
        EXPECT_EQ(l.triangles(), 1u);
        EXPECT_EQ(l.report.dropped_faces, 2u);
        EXPECT_THAT(l.warnings(), ElementsAre("m.obj: 2 faces dropped: a corner has no finite position ('" + word +
                                              "' in line 4) (first at line 6)"));
        EXPECT_EQ(parse(text, strict()).error(), "m.obj:4: no finite position: '" + word + "'");
    }
    EXPECT_THAT(parse(triangle + "v 1 2\nf 1 2 3\n").warnings(),
                ElementsAre("m.obj: 1 vertex without a finite position, which no face uses (line 4)"));
    EXPECT_THAT(parse(triangle + "v\nf 1 2 3\n").warnings().size(), 1u);
    EXPECT_EQ(
        parse(triangle + "v\nf 1 2 4\n").error(),
        "m.obj: no drawable geometry: its only face was dropped: a corner has no finite position (too few numbers "
        "in line 4) (line 5)");
}

TEST(Obj, NormalsTextureCoordinatesAndColorsThatAreNoNumbersAreMissing) {
    const std::string text =
        "v 0 0 0 1 nan 0\nv 1 0 0 1 1 1\nv 0 1 0 1 1 1\nvn 0 0 0\nvn 1e999 0 0\nvn 1\nvt nan 0\nvt\n"
        "f 1/1/1 2/2/2 3/1/3\n";
    const Loaded l = parse(text);
    ASSERT_TRUE(l.ok()) << l.error();
    expect_sound(*l.model);
    EXPECT_THAT(l.warnings(),
                ElementsAre("m.obj: 1 vertex colour that is no number, taken for white (line 1)",
                            "m.obj: 3 normals without a direction, taken for missing (first at line 4)",
                            "m.obj: 2 texture coordinates that are no numbers, taken for missing (first at line 7)"));
    EXPECT_EQ(l.model->vertices[0].color, glm::vec3(1));
    EXPECT_EQ(l.model->vertices[0].normal, glm::vec3(0, 0, 1));
    EXPECT_EQ(l.model->vertices[0].uv, glm::vec2(0));
    EXPECT_EQ(parse(text, strict()).error(), "m.obj:1: vertex colour that is no number, taken for white");
}

TEST(Obj, HugeAndTinyCoordinatesAreKept) {
    const Loaded l = parse("v 0 0 0\nv 3e38 0 0\nv 0 3e38 0\nv 1e-40 0 0\nv 0 1e-40 0\nf 1 2 3\nf 1 4 5\n");
    ASSERT_TRUE(l.ok()) << l.error();
    expect_sound(*l.model);
    EXPECT_EQ(l.triangles(), 2u);
}

// ------------------------------------------------------------------------------------------- indices

TEST(Obj, APositionIndexThatCannotBeIsAnErrorWithItsLine) {
    const auto error = [](const std::string& corner) { return parse(triangle + "f 1 2 " + corner + "\n").error(); };
    EXPECT_EQ(error("0"), "m.obj:4: '0' is not the number of a vertex; they count from 1");
    EXPECT_EQ(error("4"), "m.obj:4: vertex 4 does not exist: the file has 3");
    EXPECT_EQ(error("-4"), "m.obj:4: vertex -4 does not exist: 3 were given so far");
    EXPECT_EQ(error("2147483647"), "m.obj:4: vertex 2147483647 does not exist: the file has 3");
    EXPECT_EQ(error("-2147483647"), "m.obj:4: vertex -2147483647 does not exist: 3 were given so far");
    EXPECT_EQ(error("-2147483648"), "m.obj:4: '-2147483648' is not the number of a vertex; they count from 1");
    // As 32 bits this would be 1.
    EXPECT_EQ(error("4294967297"), "m.obj:4: '4294967297' is not the number of a vertex; they count from 1");
    EXPECT_EQ(error("1.5"), "m.obj:4: '1.5' is not the number of a vertex; they count from 1");
    EXPECT_EQ(error("a"), "m.obj:4: 'a' is not the number of a vertex; they count from 1");
    EXPECT_EQ(error("/1"), "m.obj:4: '/1' is not a corner such as 7, 7/2, 7//3 or 7/2/3");
    EXPECT_EQ(error("1/2/3/4"), "m.obj:4: '1/2/3/4' is not a corner such as 7, 7/2, 7//3 or 7/2/3");
    EXPECT_EQ(parse("f 1 2 3\nf 1 2 5\nf 9 9 9\n" + triangle).error(),
              "m.obj:2: vertex 5 does not exist: the file has 3");
    EXPECT_EQ(parse(triangle + "f 1 2 9\n").model.error().kind, ErrorKind::bad_input);
}

TEST(Obj, OtherIndicesThatCannotBeAreMissingAndCounted) {
    const std::string good = triangle + "vt 0.5 0.5\nvn 0 0 -1\n";
    for (const std::string bad : {"0", "2", "-2", "2147483648", "99999999999999999999", "x", "-2147483648"}) {
        const std::string face = "f 1/" + bad + "/1 2/1/" + bad + " 3/" + bad + "/" + bad + "\n";
        const Loaded l = parse(good + face);
        ASSERT_TRUE(l.ok()) << bad << ": " << l.error();
        expect_sound(*l.model);
        const auto& v = l.model->vertices;
        EXPECT_EQ(v[0].uv, glm::vec2(0));
        EXPECT_EQ(v[0].normal, glm::vec3(0, 0, -1));
        EXPECT_EQ(v[1].uv, glm::vec2(0.5f));
        EXPECT_EQ(v[1].normal, glm::vec3(0, 0, 1));
        EXPECT_THAT(l.warnings(), ElementsAre(HasSubstr("m.obj: 2 texture coordinate indices that are 0, out of range"),
                                              HasSubstr("m.obj: 2 normal indices that are 0, out of range")));
        EXPECT_THAT(parse(good + face, strict()).error(), HasSubstr("m.obj:6: texture coordinate index that is 0"));
    }
    EXPECT_THAT(parse(good + "f 1/ 2// 3//1\n").warnings(), IsEmpty());
}

// ------------------------------------------------------------------------------- faces without area

TEST(Obj, FacesWithoutAreaAreDroppedAndCounted) {
    const std::string text = triangle + "v 2 0 0\nf 1 2 3\nf 1 1 2\nf 1 2 4\nf 1 2\nf 3\nf\nf 1 2 1 2\n";
    const Loaded l = parse(text);
    ASSERT_TRUE(l.ok()) << l.error();
    EXPECT_EQ(l.triangles(), 1u);
    EXPECT_EQ(l.report.faces, 7u);
    EXPECT_EQ(l.report.dropped_faces, 6u);
    EXPECT_THAT(l.warnings(), ElementsAre("m.obj: 3 faces dropped: fewer than 3 corners (first at line 8)",
                                          "m.obj: 3 faces dropped: zero area (first at line 6)"));
    EXPECT_EQ(parse(triangle + "f 1 1 2\nf 1 2 3\n", strict()).error(), "m.obj:4: face dropped: zero area");
    EXPECT_EQ(parse(triangle + "f 1 2 3\nf 1 2\n", strict()).error(), "m.obj:5: face dropped: fewer than 3 corners");
}

TEST(Obj, ARepeatedCornerInAPolygonIsHarmless) {
    const Loaded l = parse(triangle + "v 1 1 0\nf 1 2 2 4 3 3 1\n");
    ASSERT_TRUE(l.ok());
    EXPECT_EQ(l.triangles(), 2u);
    EXPECT_THAT(l.warnings(), IsEmpty());
}

// ------------------------------------------------------------------------------------------ polygons

TEST(Obj, PolygonsBecomeTrianglesInTheOrderOfTheFile) {
    const Loaded l = parse("v 0 0 0\nv 2 0 0\nv 2 2 0\nv 1 0.5 0\nv 0 2 0\nv 9 9 9\nf 1 2 3 4 5\nf 1 2 6\n");
    ASSERT_TRUE(l.ok());
    expect_sound(*l.model);
    ASSERT_EQ(l.triangles(), 4u);
    double area = 0;
    for (std::size_t t = 0; t < 3; ++t) {
        const glm::vec3 n =
            glm::cross(l.position(3 * t + 1) - l.position(3 * t), l.position(3 * t + 2) - l.position(3 * t));
        EXPECT_GT(n.z, 0);
        area += double(n.z) / 2;
    }
    EXPECT_DOUBLE_EQ(area, 2.5);  // concave: the dent stays open
    EXPECT_EQ(l.position(11), glm::vec3(9));
}

TEST(Obj, SelfIntersectingNonPlanarNonManifoldAndDuplicateFacesLoad) {
    const Loaded l = parse(triangle + "v 1 1 0\nv 0 0 1\nv 0 0 -1\n" +
                           "f 1 4 2 3\n"                  // a bow tie
                           "f 1 2 5 3\n"                  // bent
                           "f 1 2 5\nf 1 2 6\nf 1 2 4\n"  // three faces on one edge
                           "f 1 2 3\nf 1 2 3\nf 3 2 1\n");
    ASSERT_TRUE(l.ok()) << l.error();
    expect_sound(*l.model);
    EXPECT_EQ(l.triangles(), 10u);
    EXPECT_THAT(l.warnings(), IsEmpty());
}

TEST(Obj, APolygonOfThirtyThousandCornersInOneLine) {
    std::string text, face = "f";
    for (int i = 0; i < 30000; ++i) {
        const double angle = 2 * 3.14159265358979 * i / 30000, r = i % 2 ? 1.0 : 0.8;
        text += "v " + std::to_string(r * std::cos(angle)) + " " + std::to_string(r * std::sin(angle)) + " 0\n";
        face += " " + std::to_string(i + 1);
    }
    const Loaded l = parse(text + face);
    ASSERT_TRUE(l.ok()) << l.error();
    EXPECT_EQ(l.triangles(), 29998u);
}

}  // namespace
}  // namespace raster
