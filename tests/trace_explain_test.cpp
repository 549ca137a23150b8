// Clusters of differing pixels are found whole, and each cause is told from the others.
#include <gtest/gtest.h>
#include <raster/trace/explain.h>

#include "random.h"
#include "trace_scenes.h"

namespace {

using namespace raster;
using namespace raster::testing;

Diff diff_of_deltas(const std::vector<std::string>& rows) {
    Diff diff;
    diff.figures.emplace();
    diff.deltas = ImageF(int(rows[0].size()), int(rows.size()), 1);
    for (std::size_t i = 0; i < diff.deltas.samples.size(); ++i) {
        const char c = rows[i / rows[0].size()][i % rows[0].size()];
        diff.deltas.samples[i] = c == '.' ? 0 : float(c - '0');
        diff.figures->differing += c != '.';
    }
    return diff;
}

TEST(DiffClusters, ArePixelsThatTouchTheLargestFirst) {
    const auto clusters = diff_clusters(diff_of_deltas({"1......3.",  //
                                                        ".2....3..",  //
                                                        "1....9...",  //
                                                        ".......55",  //
                                                        "..4.....9"}));
    ASSERT_EQ(clusters.size(), 4u);
    const std::array<PixelRect, 4> boxes = {PixelRect{0, 0, 2, 3}, {5, 0, 3, 3}, {7, 3, 2, 2}, {2, 4, 1, 1}};
    const std::array<glm::ivec2, 4> most = {glm::ivec2(1, 1), {5, 2}, {8, 4}, {2, 4}};
    for (std::size_t i = 0; i < 4; ++i) {
        EXPECT_EQ(clusters[i].box, boxes[i]) << i;
        EXPECT_EQ(clusters[i].pixels, i < 3 ? 3 : 1);
        EXPECT_EQ(glm::ivec2(clusters[i].x, clusters[i].y), most[i]);
        EXPECT_EQ(clusters[i].samples[0], most[i]);
    }
}

TEST(DiffClusters, HoldEachDifferingPixelOnce) {
    Random random(3);
    for (int round = 0; round < 50; ++round) {
        std::vector<std::string> rows(13, std::string(17, '.'));
        for (auto& row : rows)
            for (char& c : row)
                if (random.integer(0, 99) < 10 + round) c = char('1' + random.integer(0, 8));
        const Diff diff = diff_of_deltas(rows);
        std::int64_t pixels = 0;
        for (const DiffCluster& cluster : diff_clusters(diff)) {
            pixels += cluster.pixels;
            for (const glm::ivec2 sample : cluster.samples)
                EXPECT_NE(rows[std::size_t(sample.y)][std::size_t(sample.x)], '.');
        }
        EXPECT_EQ(pixels, diff.figures->differing);
    }
}

TEST(DiffClusters, ThatPassTheGatesAreLeftOutUnlessAllPass) {
    Diff diff = diff_of_deltas({"1.1", "..9"});
    diff.allowed_delta = 2;
    diff.figures->failing = 1;
    EXPECT_EQ(diff_clusters(diff).size(), 1u);
    diff.figures->failing = 0;
    EXPECT_EQ(diff_clusters(diff).size(), 2u);
}

/// What is said of two pictures when the first scene is the one that is known.
std::vector<DiffExplanation> explain(const TraceScene& scene, const Image8& expected, const Image8& actual) {
    const Result<Diff> diff = diff_images(expected, actual);
    EXPECT_TRUE(diff);
    Target target = scene.target();
    auto result = explain_diff(target, expected, actual, *diff, scene.model, scene.camera, scene.options);
    EXPECT_TRUE(result);
    return *result;
}

Image8 picture(const TraceScene& scene) { return scene.picture().color_image(); }

void expect_all(const TraceScene& scene, const TraceScene& other, DiffCause cause) {
    // Whichever of the two is the expected one.
    for (const bool swapped : {false, true}) {
        const Image8 ours = picture(scene), theirs = picture(other);
        const auto explanations = swapped ? explain(scene, theirs, ours) : explain(scene, ours, theirs);
        EXPECT_FALSE(explanations.empty());
        for (const DiffExplanation& e : explanations)
            EXPECT_EQ(to_string(e.cause), std::string(to_string(cause))) << e.x << " " << e.y << ": " << e.reason;
    }
}

TraceScene sheets() {
    TraceScene scene = trace_scenes().back();
    scene.model = {};
    scene.model.materials.resize(3);
    scene.model.materials[0].diffuse = {0.9f, 0.1f, 0.1f};
    scene.model.materials[1].diffuse = {0.1f, 0.3f, 0.9f};
    scene.model.materials[2].diffuse = {0.2f, 0.8f, 0.3f};
    add_sheet(scene.model, {-7.2f, -6.8f}, {3.1f, 5.1f}, -0.5f, 0);
    add_sheet(scene.model, {-3.7f, -2.3f}, {6.2f, 6.4f}, 0.25f, 1);
    return scene;
}

TEST(Explain, AnotherFillRuleIsAnEdgeTie) {
    TraceScene scene = trace_scenes().back(), other = scene;
    other.options.fill_rule = FillRule::top_left;
    expect_all(scene, other, DiffCause::edge_tie);
}

TEST(Explain, CoplanarSheetsInAnotherOrderAreADepthTie) {
    TraceScene scene = sheets();
    add_sheet(scene.model, {-2.2f, -5.3f}, {7.1f, 1.2f}, 0.25f, 2);
    TraceScene other = scene;
    std::swap(other.model.parts[1], other.model.parts[2]);
    std::swap_ranges(other.model.indices.begin() + 6, other.model.indices.begin() + 12,
                     other.model.indices.begin() + 12);
    for (std::uint32_t i : {1u, 2u}) other.model.parts[i].first_index = 6 * i;
    expect_all(scene, other, DiffCause::depth_tie);
}

TEST(Explain, ATriangleThatIsNotThereIsMissing) {
    TraceScene scene = sheets(), other = scene;
    other.model.indices.resize(9);
    other.model.parts[1].index_count = 3;
    expect_all(scene, other, DiffCause::missing_triangle);
    const auto explanations = explain(scene, picture(scene), picture(other));
    ASSERT_EQ(explanations.size(), 1u);
    EXPECT_EQ(explanations[0].reason, "the actual picture shows what lies below triangle 4");
}

TEST(Explain, OneStepIsRounding) {
    const TraceScene scene = sheets();
    const Image8 expected = picture(scene);
    Image8 actual = expected;
    for (int y = 6; y < 9; ++y) actual.pixel(9, y)[1] ^= 1;
    const auto explanations = explain(scene, expected, actual);
    ASSERT_EQ(explanations.size(), 1u);
    EXPECT_EQ(explanations[0].cause, DiffCause::rounding);
    EXPECT_EQ(explanations[0].cluster.pixels, 3);
}

TEST(Explain, AnotherMaterialIsShading) {
    TraceScene scene = sheets(), other = scene;
    other.model.materials[1].diffuse = {0.5f, 0.5f, 0.1f};
    expect_all(scene, other, DiffCause::shading);
}

TEST(Explain, PicturesOfSomethingElseAreSaidToBe) {
    const TraceScene scene = sheets();
    Image8 expected = picture(scene), actual = expected;
    for (int c = 0; c < 3; ++c) expected.pixel(8, 8)[c] = 77, actual.pixel(8, 8)[c] = 200;
    EXPECT_EQ(explain(scene, expected, actual)[0].cause, DiffCause::other_scene);
}

TEST(Explain, PicturesOfAnotherSizeAreAnError) {
    const TraceScene scene = sheets();
    const Image8 image(5, 5, 3);
    Target target = scene.target();
    EXPECT_FALSE(explain_diff(target, image, image, {}, scene.model, scene.camera, scene.options));
}

}  // namespace
