// A trace is all that happened, or just what was asked for; its numbers are read back as they were.
#include <bit>
#include <cstdlib>
#include <set>
#include <sstream>

#include <gtest/gtest.h>
#include <raster/trace/json.h>
#include <raster/trace/record.h>
#include <raster/trace/scene_hash.h>
#include <raster/trace/trace.h>

#include "random.h"
#include "trace_scenes.h"

namespace {

using namespace raster;
using namespace raster::testing;

std::vector<std::string> trace(const TraceScene& scene, const TraceFilter& filter = {}) {
    Target target = scene.target();
    const Result<std::string> text =
        trace_picture(target, scene.model, scene.camera, scene.options, filter, {"p", "m"});
    EXPECT_TRUE(text);
    std::vector<std::string> lines;
    std::istringstream in(*text);
    for (std::string line; std::getline(in, line);) lines.push_back(line);
    return lines;
}

bool has(const std::string& line, const std::string& words) { return line.find(words) != std::string::npos; }

std::string stage_of_line(const std::string& line) {
    const std::string key = "{\"stage\":\"";
    if (line.compare(0, key.size(), key) != 0) return "";
    return line.substr(key.size(), line.find('"', key.size()) - key.size());
}

std::vector<std::string> lines_with(const std::vector<std::string>& lines, const std::string& words) {
    std::vector<std::string> result;
    for (const std::string& line : lines)
        if (has(line, words)) result.push_back(line);
    return result;
}

/// Counts events of each stage.
struct Counter {
    std::map<std::string, std::size_t> of;
    void on(const DrawEvent&) { ++of["draw"]; }
    void on(const VertexEvent&) { ++of["vertex"]; }
    void on(const AssembleEvent&) { ++of["assemble"]; }
    void on(const ClipEvent&) { ++of["clip"]; }
    void on(const ClipPlaneEvent&) { ++of["clip_plane"]; }
    void on(const ProjectEvent&) { ++of["project"]; }
    void on(const CullEvent&) { ++of["cull"]; }
    void on(const SetupEvent&) { ++of["setup"]; }
    void on(const CoverageEvent&) { ++of["coverage"]; }
    void on(const DepthEvent&) { ++of["depth"]; }
    void on(const InterpolateEvent&) { ++of["interpolate"]; }
    void on(const FragmentEvent&) { ++of["fragment"]; }
    void on(const BlendEvent&) { ++of["blend"]; }
};

TEST(Trace, HasALineForEveryEventBetweenAHeaderAndAnEnd) {
    for (const TraceScene& scene : trace_scenes()) {
        SCOPED_TRACE(scene.name);
        Counter expected, found;
        Target target = scene.target();
        render_observed(target, scene.model, scene.camera, scene.options, expected);
        const auto lines = trace(scene);
        ASSERT_GT(lines.size(), 2u);
        EXPECT_TRUE(has(lines.front(), "\"format\":\"raster-trace\""));
        EXPECT_TRUE(
            has(lines.back(), "{\"stage\":\"end\",\"submitted\":" + std::to_string(scene.model.triangle_count())));
        for (std::size_t i = 1; i + 1 < lines.size(); ++i) ++found.of[stage_of_line(lines[i])];
        EXPECT_EQ(found.of, expected.of);
    }
}

TEST(Trace, OfOnePixelHasItsLinesAndTheTrianglesThatReachIt) {
    for (const TraceScene& scene : trace_scenes()) {
        SCOPED_TRACE(scene.name);
        const auto all = trace(scene);
        const std::string place = "\"x\":10,\"y\":9,";
        const auto one = trace(scene, {PixelBox{10, 9, 10, 9}, {}, {}});
        EXPECT_EQ(lines_with(one, place), lines_with(all, place));
        EXPECT_EQ(lines_with(one, "\"x\":"), lines_with(one, place)) << "no other pixel";
        // Each line is one of all, in the same order.
        auto at = all.begin() + 1;
        std::set<std::string> triangles, assembled;
        for (std::size_t i = 1; i < one.size(); ++i) {
            const auto triangle = one[i].substr(0, one[i].find(',', one[i].find("\"triangle\":")));
            if (has(one[i], "\"stage\":\"coverage\"")) triangles.insert(triangle.substr(triangle.find("\"draw\"")));
            if (has(one[i], "\"stage\":\"assemble\"")) assembled.insert(triangle.substr(triangle.find("\"draw\"")));
            if (has(one[i], "\"stage\":\"vertex\"")) {
                EXPECT_NE(std::find(all.begin(), all.end(), one[i]), all.end());
                continue;
            }
            at = std::find(at, all.end(), one[i]);
            ASSERT_NE(at, all.end()) << one[i];
        }
        EXPECT_EQ(triangles, assembled);
        EXPECT_FALSE(lines_with(one, "\"stage\":\"end\"").empty());
    }
}

TEST(Trace, OfOneTriangleHasItsLinesAndItsVerticesOnce) {
    const TraceScene scene = trace_scenes()[0];
    const auto all = trace(scene), some = trace(scene, {{}, {20, 21}, {}});
    for (const std::string number : {"21", "22"})
        EXPECT_EQ(lines_with(some, "\"triangle\":" + number + ","), lines_with(all, "\"triangle\":" + number + ","));
    EXPECT_TRUE(lines_with(some, "\"triangle\":20,").empty());
    const auto vertices = lines_with(some, "\"stage\":\"vertex\"");
    const std::set<std::uint32_t> used(scene.model.indices.begin() + 60, scene.model.indices.begin() + 66);
    EXPECT_EQ(vertices.size(), used.size());
    for (const std::string& line : vertices) EXPECT_NE(std::find(all.begin(), all.end(), line), all.end());
    EXPECT_TRUE(has(some.front(), "\"triangles\":[21,22]"));
}

TEST(Trace, OfSomeStagesHasTheseAlone) {
    for (const TraceScene& scene : trace_scenes()) {
        const auto all = trace(scene);
        const auto some = trace(scene, {{}, {}, {"clip", "depth"}});
        std::vector<std::string> expected;
        for (const std::string& line : all)
            for (const std::string stage : {"draw", "clip", "clip_plane", "depth", "end"})
                if (stage_of_line(line) == stage) expected.push_back(line);
        EXPECT_EQ(std::vector(some.begin() + 1, some.end()), expected);
    }
}

TEST(Trace, NumbersAreThoseOfTheRun) {
    const TraceScene scene = trace_scenes()[4];
    std::vector<float> z;
    Recorder recorder({}, [&](const RecordedDraw&, RecordedTriangle& t) {
        for (const RecordedPiece& piece : t.pieces)
            for (const RecordedPixel& pixel : piece.pixels)
                if (pixel.depth) z.push_back(pixel.depth->z);
    });
    Target target = scene.target();
    render_observed(target, scene.model, scene.camera, scene.options, recorder);
    recorder.finish();
    const auto lines = trace(scene, {{}, {}, {"depth"}});
    ASSERT_EQ(lines.size(), z.size() + 3) << "header, draw, end";
    for (std::size_t i = 0; i < z.size(); ++i) {
        const std::string& line = lines[i + 2];
        EXPECT_EQ(float(std::atof(line.c_str() + line.find("\"z\":") + 4)), z[i]);
    }
}

TEST(Trace, ThatIsTooLongIsAnError) {
    const TraceScene scene = trace_scenes()[0];
    TraceFilter filter;
    filter.max_bytes = 20000;
    Target target = scene.target();
    const auto result = trace_picture(target, scene.model, scene.camera, scene.options, filter, {"p", "m"});
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().kind, ErrorKind::usage);
}

TEST(TraceJson, EveryFloatIsReadBackTheSame) {
    Random random(20);
    for (int i = 0; i < 200000; ++i) {
        const float value = std::bit_cast<float>(std::uint32_t(random.bits()));
        std::string text;
        JsonWriter(text).value(value);
        if (!std::isfinite(value)) {
            EXPECT_EQ(text, std::isnan(value) ? "\"NaN\"" : value > 0 ? "\"Infinity\"" : "\"-Infinity\"");
            continue;
        }
        // As JavaScript and Python do it: a double, then rounded.
        EXPECT_EQ(std::bit_cast<std::uint32_t>(float(std::atof(text.c_str()))), std::bit_cast<std::uint32_t>(value))
            << text;
    }
}

TEST(TraceJson, BracketsCommasAndQuotesAreInTheirPlaces) {
    std::string text;
    JsonWriter json(text);
    json.open('{');
    json.member("a\"\\\n", "\x01");
    json.key("b");
    json.open('[');
    json.value(1);
    json.null();
    json.open('{');
    json.close('}');
    json.value(true);
    json.close(']');
    json.member("c", std::array{1.5f, -2.0f});
    json.close('}');
    EXPECT_EQ(text, R"({"a\"\\\u000a":"\u0001","b":[1,null,{},true],"c":[1.5,-2]})");
}

TEST(SceneHash, ChangesWithAllThatDecidesThePictureAndNothingElse) {
    const TraceScene scene = trace_scenes()[5];
    const auto hash = [](const TraceScene& s) { return scene_hash(s.model, s.camera, s.options, s.width, s.height); };
    std::set<std::string> hashes = {hash(scene)};
    TraceScene same = scene;
    same.model.parts[0].name = "another name";
    EXPECT_TRUE(hashes.contains(hash(same)));
    const auto changed = [&](const char* what, const auto& change) {
        TraceScene other = scene;
        change(other);
        EXPECT_TRUE(hashes.insert(hash(other)).second) << what;
    };
    changed("a position", [](TraceScene& s) { s.model.vertices[3].position.x += 0.01f; });
    changed("a normal", [](TraceScene& s) { s.model.vertices[3].normal.x += 0.01f; });
    changed("an index", [](TraceScene& s) { std::swap(s.model.indices[0], s.model.indices[1]); });
    changed("the camera", [](TraceScene& s) { s.camera.clip_from_world[3].x += 0.01f; });
    changed("the size", [](TraceScene& s) { ++s.width; });
    changed("the background", [](TraceScene& s) { s.options.background.r += 0.01f; });
    changed("a material", [](TraceScene& s) { s.model.materials[1].diffuse.g += 0.01f; });
    changed("the exponent", [](TraceScene& s) { s.model.materials[1].shininess += 1; });
    changed("a light", [](TraceScene& s) { s.options.lights[0].direction.x += 0.01f; });
    changed("the shading", [](TraceScene& s) { s.options.frequency = ShadingFrequency::flat; });
    changed("the model of reflectance", [](TraceScene& s) { s.options.reflectance = Lambert{}; });
    changed("culling", [](TraceScene& s) { s.options.cull = Cull::back; });
    changed("the fill rule", [](TraceScene& s) { s.options.fill_rule = FillRule::top_left; });
    changed("the order", [](TraceScene& s) { s.options.visibility = Visibility::painter; });
    changed("blending", [](TraceScene& s) { s.options.blend = false; });
    changed("sides", [](TraceScene& s) { s.options.two_sided = false; });
}

}  // namespace
