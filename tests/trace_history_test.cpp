// The history of a pixel: it ends in the picture's own colour, its verdict is right, and its numbers are the run's.
#include <gtest/gtest.h>
#include <raster/stages/coverage.h>
#include <raster/trace/history_text.h>

#include "trace_scenes.h"

namespace {

using namespace raster;
using namespace raster::testing;

PixelHistory history_of(const TraceScene& scene, int x, int y) {
    Target target = scene.target();
    return pixel_history(target, scene.model, scene.camera, scene.options, x, y);
}

/// A picture of 16 by 16 whose pixel (x, y) has its centre at (x + 0.5 - 8, 7.5 - y) of the model's x and y. z 1 is
/// near.
TraceScene flat_scene() {
    TraceScene scene = trace_scenes().back();
    scene.model = {};
    return scene;
}

void add(TraceScene& scene, glm::vec3 a, glm::vec3 b, glm::vec3 c) {
    for (const glm::vec3& p : {a, b, c}) {
        scene.model.indices.push_back(std::uint32_t(scene.model.vertices.size()));
        scene.model.vertices.push_back({p, {0, 0, 1}, {0, 0}, glm::vec3(1)});
    }
}

TEST(History, OfEveryPixelEndsInThePicturesColourAndDepth) {
    std::array<int, 7> verdicts{};
    std::array<int, 6> fates{};
    for (const TraceScene& scene : trace_scenes()) {
        SCOPED_TRACE(scene.name);
        Target picture = scene.picture();
        for (int y = 0; y < scene.height; ++y)
            for (int x = 0; x < scene.width; ++x) {
                SCOPED_TRACE(::testing::Message() << x << ", " << y);
                const PixelHistory h = history_of(scene, x, y);
                ++verdicts[std::size_t(h.verdict)];
                glm::vec4 color = h.color_before;
                std::uint32_t depth = h.depth_before;
                const HistoryEntry* last = nullptr;
                for (const HistoryEntry& e : h.entries) {
                    ++fates[std::size_t(e.fate)];
                    if (e.pixel() && e.pixel()->depth) {
                        EXPECT_EQ(e.pixel()->depth->stored, depth);
                        if (e.pixel()->depth->passed && h.draw_of(e).state.depth_write)
                            depth = e.pixel()->depth->incoming;
                    }
                    ASSERT_EQ(e.fate == PixelFate::wrote, e.pixel() && e.pixel()->blend);
                    if (e.fate != PixelFate::wrote) continue;
                    EXPECT_EQ(e.pixel()->blend->before, color);
                    color = e.pixel()->blend->after;
                    last = &e;
                }
                EXPECT_EQ(color, picture.color(x, y));
                EXPECT_EQ(depth, picture.depth()[picture.index(x, y)]);
                EXPECT_EQ(h.color, color);
                EXPECT_EQ(h.depth, depth);
                EXPECT_EQ(h.verdict == PixelVerdict::won, last != nullptr);
                if (last) {
                    EXPECT_EQ(&h.entries[*h.decisive], last);
                    EXPECT_TRUE(last->visible);
                }
                if (::testing::Test::HasFailure()) return;
            }
    }
    for (const auto v : {PixelVerdict::won, PixelVerdict::never_covered, PixelVerdict::clipped, PixelVerdict::culled,
                         PixelVerdict::background})
        EXPECT_GT(verdicts[std::size_t(v)], 0) << to_string(v);
    for (std::size_t i = 0; i < fates.size(); ++i) EXPECT_GT(fates[i], 0) << to_string(PixelFate(i));
}

TEST(History, TermsAddUpToTheFragmentsColour) {
    int seen = 0;
    for (const TraceScene& scene : trace_scenes()) {
        SCOPED_TRACE(scene.name);
        const float rounding = scene.options.frequency == ShadingFrequency::gouraud ? 1e-5f : 0;
        for (int x = 2; x < scene.width; x += 3)
            for (const HistoryEntry& e : history_of(scene, x, scene.height / 2).entries) {
                EXPECT_EQ(e.terms.has_value(), e.fate == PixelFate::wrote);
                if (!e.terms) continue;
                ++seen;
                const glm::vec4 source = e.pixel()->blend->source;
                for (int i = 0; i < 4; ++i) EXPECT_NEAR(e.terms->color[i], source[i], rounding);
                const FragmentTerms& t = *e.terms;
                for (int i = 0; i < 3; ++i)
                    EXPECT_EQ(t.color[i], std::max(((t.emission + t.ambient) + t.diffuse)[i] + t.specular[i], 0.0f));
            }
    }
    EXPECT_GT(seen, 20);
}

TEST(History, GouraudsCornersMixToTheLightOfTheTerms) {
    int seen = 0, cut = 0;
    for (TraceScene scene : trace_scenes()) {
        SCOPED_TRACE(scene.name);
        scene.options.frequency = ShadingFrequency::gouraud;
        scene.model.materials.clear();
        scene.options.default_material.diffuse = glm::vec3(1.0f);
        scene.options.default_material.specular = glm::vec3(1.0f);
        scene.options.vertex_colors = false;
        for (int x = 0; x < scene.width; x += 2)
            for (const HistoryEntry& e : history_of(scene, x, scene.height / 2).entries) {
                EXPECT_EQ(e.corners.size(), e.fate == PixelFate::wrote ? 3u : 0u);
                if (e.corners.empty()) continue;
                ++seen;
                cut += !e.triangle.cuts.empty();
                glm::vec3 diffuse(0), specular(0);
                for (const CornerLight& c : e.corners)
                    diffuse += c.weight * c.diffuse, specular += c.weight * c.specular;
                for (int i = 0; i < 3; ++i) {
                    EXPECT_NEAR(diffuse[i], e.terms->diffuse[i], 1e-4f);
                    EXPECT_NEAR(specular[i], e.terms->specular[i], 1e-4f);
                }
            }
    }
    EXPECT_GT(seen, 20);
    EXPECT_GT(cut, 0);
}

TEST(History, TheDeeperTriangleLosesByDepthWhicheverComesFirst) {
    for (const bool nearer_first : {true, false}) {
        TraceScene scene = flat_scene();
        for (const float z : {nearer_first ? 0.5f : -0.5f, nearer_first ? -0.5f : 0.5f})
            add(scene, {-6, -6, z}, {6, -6, z}, {0, 6, z});
        const PixelHistory h = history_of(scene, 8, 8);
        ASSERT_EQ(h.entries.size(), 2u);
        const HistoryEntry& winner = h.entries[*h.decisive];
        EXPECT_EQ(h.verdict, PixelVerdict::won);
        EXPECT_EQ(winner.triangle.number, nearer_first ? 0 : 1);
        EXPECT_EQ(h.entries[0].fate, PixelFate::wrote);
        EXPECT_EQ(h.entries[0].visible, nearer_first);
        EXPECT_EQ(h.entries[1].fate, nearer_first ? PixelFate::lost : PixelFate::wrote);
        EXPECT_EQ(winner.pixel()->depth->z, 0.25f) << "z 0.5 of -1..1 with the eye at the 1 side";
        EXPECT_NE(history_text(h).find("by depth; 1 other lost"), std::string::npos) << history_text(h);
    }
}

TEST(History, OfEqualDepthsTheFirstStaysAndTheTextSaysSo) {
    TraceScene scene = flat_scene();
    for (int i = 0; i < 2; ++i) add(scene, {-6, -6, 0}, {6, -6, 0}, {0, 6, 0});
    const PixelHistory h = history_of(scene, 8, 8);
    EXPECT_EQ(h.entries[*h.decisive].triangle.number, 0);
    EXPECT_EQ(h.entries[1].pixel()->depth->incoming, h.entries[1].pixel()->depth->stored);
    EXPECT_NE(history_text(h).find("(equal depths)"), std::string::npos);
}

TEST(History, ACentreOnASharedEdgeHasOneOwnerAndTheOtherSaysWho) {
    for (const FillRule rule : {FillRule::bottom_left, FillRule::top_left}) {
        TraceScene scene = flat_scene();
        scene.options.fill_rule = rule;
        // Two halves of a square; the row of centres y = -0.5 lies on their border.
        add(scene, {-6, -6, 0}, {6, -0.5f, 0}, {-6, -0.5f, 0});
        add(scene, {-6, -0.5f, 0}, {6, -0.5f, 0}, {6, 6, 0});
        const PixelHistory h = history_of(scene, 8, 8);
        ASSERT_EQ(h.entries.size(), 2u);
        const std::size_t owner = rule == FillRule::bottom_left ? 1 : 0;  // the border is the upper one's bottom edge
        EXPECT_EQ(*h.decisive, owner);
        for (std::size_t i = 0; i < 2; ++i) {
            const HistoryEntry& e = h.entries[i];
            EXPECT_EQ(int(e.is_tie(0)) + int(e.is_tie(1)) + int(e.is_tie(2)), 1);
            EXPECT_EQ(e.fate, i == owner ? PixelFate::wrote : PixelFate::near);
            EXPECT_EQ(e.distance, 0);
            if (i == owner) continue;
            ASSERT_GE(e.rejecting_edge(), 0);
            EXPECT_TRUE(e.is_tie(e.rejecting_edge()));
            EXPECT_EQ(side_of(e.setup()->setup.edges[std::size_t(e.rejecting_edge())]),
                      i == 0 ? EdgeSide::top : EdgeSide::bottom);
        }
        const std::string text = history_text(h), name = "#" + std::to_string(owner + 1);
        EXPECT_NE(text.find("not owned"), std::string::npos) << text;
        EXPECT_NE(text.find(name + " owns it"), std::string::npos) << text;
        EXPECT_NE(text.find("* tie: e"), std::string::npos) << text;
    }
}

TEST(History, EdgeValuesAreExact) {
    TraceScene scene = flat_scene();
    add(scene, {-6, -6, 0}, {6, -6, 0}, {-6, 6, 0});
    // In subpixels, y down: corners (256 * 1.5, 256 * 13.5), 3072 to the right, 3072 up. Pixel (4, 10)'s centre is
    // (4 - 1.5) pixels right of the left edge and (13.5 - 10) above the lower one.
    const PixelHistory h = history_of(scene, 4, 10);
    ASSERT_EQ(h.entries.size(), 1u);
    const auto& e = h.entries[0].pixel()->coverage.edges;
    EXPECT_EQ(e[0], 3072 * 896) << "the lower edge";
    EXPECT_EQ(e[1], 3072 * (3072 - 640 - 896)) << "the slanted one";
    EXPECT_EQ(e[2], 3072 * 640) << "the left one";
}

TEST(History, NearMissesAreListedWithTheEdgeThatRejectsThem) {
    TraceScene scene = flat_scene();
    add(scene, {-6, -6, 0}, {6, -6, 0}, {-6, 6, 0});
    EXPECT_EQ(history_of(scene, 2, 14).verdict, PixelVerdict::never_covered) << "half a pixel below the lower edge";
    const PixelHistory h = history_of(scene, 2, 14);
    ASSERT_EQ(h.entries.size(), 1u);
    EXPECT_EQ(h.entries[0].distance, 0.5);
    EXPECT_EQ(h.entries[0].rejecting_edge(), 0);
    EXPECT_NE(history_text(h).find("e0 is a bottom edge and -393216 < 0"), std::string::npos) << history_text(h);
    const PixelHistory far = history_of(scene, 12, 3);
    EXPECT_EQ(far.verdict, PixelVerdict::background);
    EXPECT_TRUE(far.entries.empty());
    ASSERT_TRUE(far.nearest);
    EXPECT_NEAR(far.nearest->distance, 9 / std::sqrt(2.0), 1e-9);
}

TEST(History, WhatIsClippedAwayHereIsNamedWithItsPlane) {
    for (const auto& [z, plane] : {std::pair(3.0f, ClipPlane::near), {-3.0f, ClipPlane::far}}) {
        TraceScene scene = flat_scene();
        add(scene, {-6, -6, z}, {6, -6, z}, {0, 6, 0});  // its lower part lies outside, its tip inside
        const PixelHistory low = history_of(scene, 8, 12);
        EXPECT_EQ(low.verdict, PixelVerdict::clipped);
        ASSERT_EQ(low.entries.size(), 1u);
        EXPECT_EQ(low.entries[0].cut_by, std::vector{plane});
        EXPECT_EQ(low.entries[0].pixel(), nullptr) << "not reached";
        EXPECT_NE(history_text(low).find(plane == ClipPlane::near ? "CLIPPED(near)" : "CLIPPED(far)"),
                  std::string::npos);
        const PixelHistory tip = history_of(scene, 8, 3);
        EXPECT_EQ(tip.verdict, PixelVerdict::won);
        ASSERT_FALSE(tip.entries.empty());
        EXPECT_EQ(tip.entries[*tip.decisive].triangle.cuts.size(), 1u);
        EXPECT_EQ(history_of(scene, 0, 8).verdict, PixelVerdict::background) << "beside the triangle";
    }
}

TEST(History, PiecesOfOneTriangleAreNotNearMissesOfEachOther) {
    TraceScene scene = flat_scene();
    add(scene, {-6, -6, 0}, {6, -6, 0}, {0, 6, 3});  // its tip is cut away, which leaves two pieces
    int covered = 0;
    for (int y = 0; y < 16; ++y)
        for (int x = 0; x < 16; ++x) {
            const PixelHistory h = history_of(scene, x, y);
            if (h.verdict != PixelVerdict::won) continue;
            ++covered;
            EXPECT_EQ(h.entries.size(), 1u) << x << " " << y;
        }
    EXPECT_GT(covered, 20);
}

TEST(History, WhatIsCulledHereIsNamedAndNothingIsMadeUpForIt) {
    TraceScene scene = flat_scene();
    scene.options.cull = Cull::back;
    add(scene, {-6, -6, 0}, {0, 6, 0}, {6, -6, 0});
    const PixelHistory h = history_of(scene, 8, 8);
    EXPECT_EQ(h.verdict, PixelVerdict::culled);
    ASSERT_EQ(h.entries.size(), 1u);
    EXPECT_EQ(h.entries[0].pixel(), nullptr);
    EXPECT_NE(history_text(h).find("coverage was not reached"), std::string::npos);
    EXPECT_NE(history_json(h).find("\"coverage\":null"), std::string::npos);
    EXPECT_EQ(history_of(scene, 1, 1).verdict, PixelVerdict::background);
}

TEST(History, AllRejectedWhenNothingPassesTheDepthTest) {
    TraceScene scene = flat_scene();
    add(scene, {-6, -6, -1}, {6, -6, -1}, {0, 6, -1});  // at the far plane, depth 1, which is not less than 1
    const PixelHistory h = history_of(scene, 8, 8);
    EXPECT_EQ(h.verdict, PixelVerdict::all_rejected);
    EXPECT_NE(history_text(h).find("ALL_REJECTED(depth), 1 covered it"), std::string::npos) << history_text(h);
    EXPECT_EQ(h.color, h.color_before);
}

TEST(History, NotANumberIsAVerdict) {
    TraceScene scene = flat_scene();
    add(scene, {-6, -6, 0}, {6, -6, 0}, {0, 6, 0});
    scene.options.default_material.alpha = NAN;
    EXPECT_EQ(history_of(scene, 8, 8).verdict, PixelVerdict::nan);
    scene.options.default_material.alpha = 1;
    EXPECT_EQ(history_of(scene, 8, 8).verdict, PixelVerdict::won);
    scene.model.vertices[1].position.x = NAN;
    const PixelHistory dropped = history_of(scene, 8, 8);
    EXPECT_EQ(dropped.verdict, PixelVerdict::background);
    EXPECT_NE(history_text(dropped).find("1 dropped"), std::string::npos);
}

TEST(History, SeeThroughLayersAreAllVisibleDownToTheOpaqueOne) {
    TraceScene scene = flat_scene();
    scene.model.materials.resize(2);
    scene.model.materials[1].alpha = 0.5f;
    for (const auto& [z, material] : {std::pair(-0.8f, 0), {-0.4f, 0}, {0.4f, 1}, {0.8f, 1}, {-0.6f, 1}}) {
        const auto first = std::uint32_t(scene.model.indices.size());
        add(scene, {-6, -6, z}, {6, -6, z}, {0, 6, z});
        scene.model.parts.push_back({"", material, first, 3});
    }
    const PixelHistory h = history_of(scene, 8, 8);
    std::vector<int> numbers, visible;
    for (const HistoryEntry& e : h.entries) {
        numbers.push_back(int(e.triangle.number));
        visible.push_back(e.visible);
    }
    EXPECT_EQ(numbers, (std::vector{0, 1, 4, 2, 3})) << "opaque ones as in the file, then back to front";
    EXPECT_EQ(visible, (std::vector{0, 1, 0, 1, 1})) << "the fourth lies behind an opaque one";
    EXPECT_EQ(h.entries[2].fate, PixelFate::lost);
    EXPECT_NE(history_text(h).find("triangle 4 on top, with 2 seen through it"), std::string::npos) << history_text(h);
}

TEST(History, LongListsAreCutInTheTextAndWholeInJson) {
    TraceScene scene = flat_scene();
    for (int i = 0; i < 100; ++i) add(scene, {-6, -6, 0}, {6, -6, 0}, {0, 6, 0});
    const PixelHistory h = history_of(scene, 8, 8);
    const std::string text = history_text(h), json = history_json(h);
    EXPECT_LT(std::count(text.begin(), text.end(), '\n'), 40);
    EXPECT_NE(text.find("and 75 more"), std::string::npos) << text;
    std::size_t entries = 0;
    for (std::size_t at = json.find("\"fate\""); at != std::string::npos; at = json.find("\"fate\"", at + 1)) ++entries;
    EXPECT_EQ(entries, 100u);
}

}  // namespace
