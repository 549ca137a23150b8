// scene_obj_test.cpp: OBJ text to models, one test a row of what bad input must give.
#include <chrono>
#include <cstring>

#include "random.h"
#include "scene_obj_testing.h"

namespace raster {
namespace {

using ::testing::AllOf;
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

// ---------------------------------------------------------------------------- nothing that can be drawn

TEST(Obj, NothingToDrawIsAnErrorThatSaysWhy) {
    EXPECT_EQ(parse("").error(), "m.obj: no drawable geometry: the file is empty");
    EXPECT_EQ(parse("# nothing\n").error(),
              "m.obj: no drawable geometry: no faces and no vertices; is this an OBJ file?");
    EXPECT_EQ(parse(triangle).error(), "m.obj: no drawable geometry: no faces");
    EXPECT_EQ(parse(triangle + "p 1\np 2\nl 1 2\n").error(),
              "m.obj: no drawable geometry: no faces, only 1 line and 2 points");
    EXPECT_EQ(parse(triangle + "f 1 1 1\n").error(),
              "m.obj: no drawable geometry: its only face was dropped: zero area (line 4)");
    EXPECT_EQ(parse(triangle + "f 1 1 1\nf 1 2\n").error(),
              "m.obj: no drawable geometry: all 2 faces were dropped: fewer than 3 corners (line 5)");
    EXPECT_EQ(parse(std::string("\xff\xfev\0 \0", 6)).error(),
              "m.obj: no drawable geometry: this is UTF-16 text; save it as UTF-8");
}

// ------------------------------------------------------------------------------- the text around it all

TEST(Obj, LineEndsByteOrderMarkTabsAndContinuationsMakeNoDifference) {
    const std::string text = "o thing\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nvn 0 0 1\nf 1//1 2//1 4//1 3//1\n";
    const Loaded plain = parse(text);
    ASSERT_TRUE(plain.ok()) << plain.error();
    const auto replaced = [&](const std::string& from, const std::string& to) {
        std::string result;
        for (std::size_t at = 0; at < text.size();) {
            const bool here = text.compare(at, from.size(), from) == 0;
            result += here ? to : text.substr(at, 1);
            at += here ? from.size() : 1;
        }
        return result;
    };
    for (const std::string& other :
         {replaced("\n", "\r\n"), replaced("\n", "\r"), "\xef\xbb\xbf" + text, replaced(" ", "\t"),
          replaced(" ", " \t "), text.substr(0, text.size() - 1), replaced(" ", " \\\n"), replaced(" ", " \\\r\n"),
          replaced("\n", " \n\n  "), replaced("\n", " # comment\n").substr(18), "\xef\xbb\xbf\r\n" + text}) {
        const Loaded l = parse(other);
        ASSERT_TRUE(l.ok()) << other << l.error();
        EXPECT_THAT(l.warnings(), IsEmpty()) << other;
        ASSERT_EQ(l.model->vertices.size(), 4u);
        EXPECT_EQ(std::memcmp(l.model->vertices.data(), plain.model->vertices.data(), 4 * sizeof(SurfaceVertex<float>)),
                  0);
        EXPECT_EQ(l.model->indices, plain.model->indices);
    }
}

TEST(Obj, ErrorsNameTheLineThatAnEditorShows) {
    for (const std::string end : {"\n", "\r\n", "\r"}) {
        std::string text = "\xef\xbb\xbf# a" + end + end + "v 0 0 \\" + end + " 0" + end + "f 1 2 x" + end;
        EXPECT_THAT(parse(text).error(), HasSubstr("m.obj:5: 'x'"));
        text = "v 0 0 0" + end + "f 1 \\" + end + "2 \\" + end + "x" + end;
        EXPECT_THAT(parse(text).error(), HasSubstr("m.obj:2: 'x'"));
    }
}

TEST(Obj, ZeroBytesAreBlanksWithAWarning) {
    std::string text = triangle + "f 1 2 3\n";
    text[text.find("f 1") + 1] = '\0';
    const Loaded l = parse(text);
    ASSERT_TRUE(l.ok()) << l.error();
    EXPECT_EQ(l.triangles(), 1u);
    EXPECT_THAT(l.warnings(), ElementsAre("m.obj:4: zero bytes, taken for blanks"));
    EXPECT_EQ(parse(text, strict()).error(), "m.obj:4: zero bytes, taken for blanks");
}

TEST(Obj, BinaryJunkGivesAnErrorAndFewWarnings) {
    for (std::uint64_t seed = 0; seed < 50; ++seed) {
        testing::Random random(seed);
        std::string junk(20000, ' ');
        for (char& c : junk) c = char(random.bits());
        const Loaded l = parse(junk);
        EXPECT_FALSE(l.ok());
        EXPECT_THAT(l.error(), HasSubstr("m.obj:"));
        EXPECT_LE(l.report.warnings.size(), 100u);
        for (const std::string& warning : l.warnings()) {
            EXPECT_LT(warning.size(), 700u);
            for (const char c : warning) EXPECT_FALSE(static_cast<unsigned char>(c) < 0x20 || c == 0x7f);
        }
    }
}

TEST(Obj, ALineOfTwentyMegabytesIsAnError) {
    const std::string line(20'000'000, '1');
    for (const std::string start : {"f ", "v ", "", "usemtl "})
        EXPECT_EQ(parse(triangle + start + line + "\n").error(),
                  "m.obj:4: a line of more than 4194304 bytes; is this an OBJ file?");
    EXPECT_TRUE(parse(triangle + "f 1 2 3\n#" + line).ok());
}

TEST(Obj, UnknownStatementsAreCountedByName) {
    const std::string text = triangle + "foo 1\nbar\nfoo 2\nf 1 2 3\n";
    EXPECT_THAT(parse(text).warnings(),
                ElementsAre("m.obj:4: unknown statement 'foo' (2 times)", "m.obj:5: unknown statement 'bar'"));
    EXPECT_EQ(parse(text, strict()).error(), "m.obj:4: unknown statement 'foo'");
    // Right, but not drawn: no fault of the file.
    const Loaded l = parse(triangle + "curv 0 1 1 2\nl 1 2\nf 1 2 3\nv 0 0 0 2\n", strict());
    ASSERT_TRUE(l.ok()) << l.error();
    EXPECT_EQ(l.report.lines, 1u);
    EXPECT_THAT(l.warnings(), ElementsAre("m.obj:4: curv is not drawn here",
                                          "m.obj:7: a weight of a vertex (v x y z w) is not used here"));
}

// --------------------------------------------------------------------------------- parts and smoothing

TEST(Obj, PartsFollowNamesAndMaterials) {
    const Loaded l =
        parse(triangle +
              "f 1 2 3\no thing\ng some group\nf 1 2 3\nf 1 2 3\ng\nf 1 2 3\ng empty\no a b\ns 1\nf 1 2 3\n"
              "s off\nf 1 2 3\n");
    ASSERT_TRUE(l.ok()) << l.error();
    expect_sound(*l.model);
    std::vector<std::pair<std::string, std::uint32_t>> parts;
    for (const Part& part : l.model->parts) parts.emplace_back(part.name, part.index_count);
    using ::testing::Pair;
    EXPECT_THAT(parts, ElementsAre(Pair("", 3u), Pair("some group", 6u), Pair("default", 3u), Pair("a b", 6u)));
}

TEST(Obj, LongNamesAreCutSoThatManyPartsDoNotFillTheMemory) {
    const Loaded l = parse(triangle + "g " + std::string(100'000, 'x') + "\nf 1 2 3\n");
    ASSERT_TRUE(l.ok()) << l.error();
    EXPECT_EQ(l.model->parts[0].name.size(), 127u);
}

const std::string cube = "v -1 -1 -1\nv 1 -1 -1\nv 1 1 -1\nv -1 1 -1\nv -1 -1 1\nv 1 -1 1\nv 1 1 1\nv -1 1 1\n";
const std::string cube_faces = "f 1 4 3 2\nf 5 6 7 8\nf 1 2 6 5\nf 3 4 8 7\nf 2 3 7 6\nf 1 5 8 4\n";

TEST(Obj, MadeUpNormalsFollowSmoothingGroupsAndTheCreaseAngle) {
    const auto vertices = [](const std::string& text, const ObjOptions& options = {}) {
        const Loaded l = parse(text, options);
        if (l.ok()) expect_sound(*l.model);
        return l.ok() ? l.model->vertices.size() : 0;
    };
    ObjOptions round, sharp;
    round.crease_angle = 180.0f;
    sharp.crease_angle = 10.0f;
    EXPECT_EQ(vertices(cube + cube_faces), 24u);  // sharper than 60 degrees
    EXPECT_EQ(vertices(cube + cube_faces, round), 8u);
    EXPECT_EQ(vertices(cube + "s 1\n" + cube_faces), 8u);            // the file says smooth
    EXPECT_EQ(vertices(cube + "s 1\n" + cube_faces, sharp), 24u);    // the user says sharp
    EXPECT_EQ(vertices(cube + "s off\n" + cube_faces, round), 24u);  // flat is flat
    EXPECT_EQ(vertices(cube + "s 0\n" + cube_faces, round), 24u);
    const Loaded l = parse(cube + cube_faces, round);
    for (const auto& v : l.model->vertices) EXPECT_NEAR(glm::dot(v.normal, glm::normalize(v.position)), 1, 1e-6);
    EXPECT_THAT(parse(cube + "s x\n" + cube_faces).warnings(),
                ElementsAre("m.obj:9: s without off or the number of a smoothing group"));
}

TEST(Obj, NormalsAreMadeUpOnlyWhereTheyAreMissing) {
    const Loaded l = parse(triangle + "vn 0 1 0\nf 1//1 2//1 3//1\nf 1 3 2\n");
    ASSERT_TRUE(l.ok());
    EXPECT_TRUE(l.report.made_normals);
    for (int i = 0; i < 3; ++i) {
        EXPECT_EQ(l.model->vertices[l.model->indices[i]].normal, glm::vec3(0, 1, 0));
        EXPECT_EQ(l.model->vertices[l.model->indices[3 + i]].normal, glm::vec3(0, 0, -1));
    }
}

// ------------------------------------------------------------------------------------ limits and options

TEST(Obj, MoreTrianglesThanTheLimitIsAnErrorAtTheLine) {
    ObjOptions options;
    options.max_triangles = 2;
    const std::string quad = triangle + "v 1 1 0\nf 1 2 4 3\n";
    EXPECT_TRUE(parse(quad, options).ok());
    EXPECT_EQ(parse(quad + "f 1 2 3\n", options).error(), "m.obj:6: more triangles than the limit of 2");
    EXPECT_EQ(parse(quad + triangle, options).error(),
              "m.obj:8: more v statements than the limit of 6, three times that of triangles");
}

TEST(Obj, CreaseAnglesOutOfRangeAreUsageErrors) {
    for (const float angle : {-1.0f, 180.5f, std::nanf("")}) {
        ObjOptions options;
        options.crease_angle = angle;
        const Loaded l = parse(triangle + "f 1 2 3\n", options);
        ASSERT_FALSE(l.ok());
        EXPECT_EQ(l.model.error().kind, ErrorKind::usage);
    }
}

TEST(Obj, ProgressGoesFromZeroToOneAndNeverBack) {
    std::vector<double> calls;
    ObjOptions options;
    options.progress = [&](double done) { calls.push_back(done); };
    std::string text = triangle;
    for (int i = 0; i < 1000; ++i) text += "f 1 2 3\n";
    ASSERT_TRUE(parse(text, options).ok());
    ASSERT_GT(calls.size(), 10u);
    EXPECT_LE(calls.size(), 100u);
    EXPECT_LT(calls.front(), 0.05);
    EXPECT_EQ(calls.back(), 1);
    EXPECT_TRUE(std::is_sorted(calls.begin(), calls.end()));
}

TEST(Obj, AReportStartsAnewEachTime) {
    LoadReport report;
    report.faces = 77;
    report.warnings.push_back({"old", 1, 1, "old", ""});
    const std::string text = triangle + "f 1 2 3\n";
    ASSERT_TRUE(parse_obj(std::as_bytes(std::span(text)), "m.obj", std::nullopt, {}, report));
    EXPECT_EQ(report.faces, 1u);
    EXPECT_THAT(report.warnings, IsEmpty());
}

TEST(Obj, LoadingTwiceGivesTheSameBytes) {
    testing::Random random(9);
    std::string text;
    for (int i = 0; i < 200; ++i) {
        text += "v";
        for (int k = 0; k < 3; ++k) text += " " + std::to_string(random.uniform(-1, 1));
        text += "\n";
    }
    for (int i = 0; i < 300; ++i) {
        text += "f";
        for (int k = random.integer(3, 7); k > 0; --k) text += " " + std::to_string(random.integer(1, 200));
        text += "\n";
    }
    const Loaded a = parse(text), b = parse(text);
    ASSERT_TRUE(a.ok()) << a.error();
    expect_sound(*a.model);
    expect_same(*a.model, *b.model);
}

TEST(Obj, TheFileItselfMustBeARegularOne) {
    const testing::Folder folder;
    EXPECT_EQ(testing::load(folder.path("no.obj")).model.error().kind, ErrorKind::input_output);
    EXPECT_EQ(testing::load("/dev/zero").model.error().kind, ErrorKind::input_output);
    EXPECT_EQ(testing::load(std::filesystem::temp_directory_path().string()).model.error().kind,
              ErrorKind::input_output);
    ObjOptions options;
    options.max_file_bytes = 10;
    EXPECT_EQ(testing::load(folder.write("m.obj", triangle), options).model.error().kind, ErrorKind::bad_input);
}

TEST(BoundingBox, HoldsWhatTrianglesUse) {
    Model model = *parse(triangle + "f 1 2 3\n").model;
    model.vertices.push_back({{9, 9, 9}, {}, {}, {}});
    EXPECT_EQ(bounding_box(model).min, glm::vec3(0, 0, 0));
    EXPECT_EQ(bounding_box(model).max, glm::vec3(1, 1, 0));
    const Box empty = bounding_box(Model{});
    EXPECT_GT(empty.min.x, empty.max.x);
}

}  // namespace
}  // namespace raster
