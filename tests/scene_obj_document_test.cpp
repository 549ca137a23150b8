// scene_obj_document_test.cpp: OBJ text to models: the text around the numbers, names, smoothing, limits and options.
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

// ---------------------------------------------------------------------------- nothing that can be drawn

TEST(ObjDocument, NothingToDrawIsAnErrorThatSaysWhy) {
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

TEST(ObjDocument, LineEndsByteOrderMarkTabsAndContinuationsMakeNoDifference) {
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

TEST(ObjDocument, ErrorsNameTheLineThatAnEditorShows) {
    for (const std::string end : {"\n", "\r\n", "\r"}) {
        std::string text = "\xef\xbb\xbf# a" + end + end + "v 0 0 \\" + end + " 0" + end + "f 1 2 x" + end;
        EXPECT_THAT(parse(text).error(), HasSubstr("m.obj:5: 'x'"));
        text = "v 0 0 0" + end + "f 1 \\" + end + "2 \\" + end + "x" + end;
        EXPECT_THAT(parse(text).error(), HasSubstr("m.obj:2: 'x'"));
    }
}

TEST(ObjDocument, ZeroBytesAreBlanksWithAWarning) {
    std::string text = triangle + "f 1 2 3\n";
    text[text.find("f 1") + 1] = '\0';
    const Loaded l = parse(text);
    ASSERT_TRUE(l.ok()) << l.error();
    EXPECT_EQ(l.triangles(), 1u);
    EXPECT_THAT(l.warnings(), ElementsAre("m.obj:4: zero bytes, taken for blanks"));
    EXPECT_EQ(parse(text, strict()).error(), "m.obj:4: zero bytes, taken for blanks");
}

TEST(ObjDocument, BinaryJunkGivesAnErrorAndFewWarnings) {
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

TEST(ObjDocument, ALineOfTwentyMegabytesIsAnError) {
    const std::string line(20'000'000, '1');
    for (const std::string start : {"f ", "v ", "", "usemtl "})
        EXPECT_EQ(parse(triangle + start + line + "\n").error(),
                  "m.obj:4: a line of more than 4194304 bytes; is this an OBJ file?");
    EXPECT_TRUE(parse(triangle + "f 1 2 3\n#" + line).ok());
}

TEST(ObjDocument, UnknownStatementsAreCountedByName) {
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

TEST(ObjDocument, PartsFollowNamesAndMaterials) {
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

TEST(ObjDocument, APartWhoseFacesWereAllDroppedIsNone) {
    const Loaded l = parse(triangle + "g a\nf 1 1 2\ng b\nf 1 2 3\ng c\nf 1 2\nf 2 2 2\n");
    ASSERT_TRUE(l.ok());
    expect_sound(*l.model);
    ASSERT_EQ(l.model->parts.size(), 1u);
    EXPECT_EQ(l.model->parts[0].name, "b");
}

TEST(ObjDocument, LongNamesAreCutSoThatManyPartsDoNotFillTheMemory) {
    const Loaded l = parse(triangle + "g " + std::string(100'000, 'x') + "\nf 1 2 3\n");
    ASSERT_TRUE(l.ok()) << l.error();
    EXPECT_EQ(l.model->parts[0].name.size(), 127u);
}

const std::string cube = "v -1 -1 -1\nv 1 -1 -1\nv 1 1 -1\nv -1 1 -1\nv -1 -1 1\nv 1 -1 1\nv 1 1 1\nv -1 1 1\n";
const std::string cube_faces = "f 1 4 3 2\nf 5 6 7 8\nf 1 2 6 5\nf 3 4 8 7\nf 2 3 7 6\nf 1 5 8 4\n";

TEST(ObjDocument, MadeUpNormalsFollowSmoothingGroupsAndTheCreaseAngle) {
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

TEST(ObjDocument, NormalsAreMadeUpOnlyWhereTheyAreMissing) {
    const Loaded l = parse(triangle + "vn 0 1 0\nf 1//1 2//1 3//1\nf 1 3 2\n");
    ASSERT_TRUE(l.ok());
    EXPECT_TRUE(l.report.made_normals);
    for (int i = 0; i < 3; ++i) {
        EXPECT_EQ(l.model->vertices[l.model->indices[i]].normal, glm::vec3(0, 1, 0));
        EXPECT_EQ(l.model->vertices[l.model->indices[3 + i]].normal, glm::vec3(0, 0, -1));
    }
}

// ------------------------------------------------------------------------------------ limits and options

TEST(ObjDocument, MoreTrianglesThanTheLimitIsAnErrorAtTheLine) {
    ObjOptions options;
    options.max_triangles = 2;
    const std::string quad = triangle + "v 1 1 0\nf 1 2 4 3\n";
    EXPECT_TRUE(parse(quad, options).ok());
    EXPECT_EQ(parse(quad + "f 1 2 3\n", options).error(), "m.obj:6: more triangles than the limit of 2");
    EXPECT_EQ(parse(quad + triangle, options).error(),
              "m.obj:8: more v statements than the limit of 6, three times that of triangles");
}

TEST(ObjDocument, CreaseAnglesOutOfRangeAreUsageErrors) {
    for (const float angle : {-1.0f, 180.5f, std::nanf("")}) {
        ObjOptions options;
        options.crease_angle = angle;
        const Loaded l = parse(triangle + "f 1 2 3\n", options);
        ASSERT_FALSE(l.ok());
        EXPECT_EQ(l.model.error().kind, ErrorKind::usage);
    }
}

TEST(ObjDocument, ProgressGoesFromZeroToOneAndNeverBack) {
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

TEST(ObjDocument, AReportStartsAnewEachTime) {
    LoadReport report;
    report.faces = 77;
    report.warnings.push_back({"old", 1, 1, "old", ""});
    const std::string text = triangle + "f 1 2 3\n";
    ASSERT_TRUE(parse_obj(std::as_bytes(std::span(text)), "m.obj", std::nullopt, {}, report));
    EXPECT_EQ(report.faces, 1u);
    EXPECT_THAT(report.warnings, IsEmpty());
}

TEST(ObjDocument, LoadingTwiceGivesTheSameBytes) {
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

TEST(ObjDocument, TheFileItselfMustBeARegularOne) {
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
