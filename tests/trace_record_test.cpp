// What is recorded of a picture: the very picture that is drawn, and of each chosen triangle all that happened to it.
#include <gtest/gtest.h>
#include <raster/trace/record.h>

#include "trace_scenes.h"

namespace {

using namespace raster;
using namespace raster::testing;

std::vector<RecordedTriangle> record(const TraceScene& scene, RecordChoice choice = {}) {
    std::vector<RecordedTriangle> triangles;
    Recorder recorder(std::move(choice), [&](const RecordedDraw& draw, RecordedTriangle& t) {
        EXPECT_EQ(draw.draw, t.draw);
        triangles.push_back(t);
    });
    Target target = scene.target();
    render_observed(target, scene.model, scene.camera, scene.options, recorder);
    recorder.finish();
    return triangles;
}

TEST(Record, AnObservedPictureIsThePicture) {
    struct Nothing {};
    for (const TraceScene& scene : trace_scenes()) {
        for (const int planes : {0, shaded_plane::count}) {
            SCOPED_TRACE(scene.name + (planes ? ", with planes" : ""));
            Target expected = scene.target(planes), observed = scene.target(planes);
            const DrawCounts counts = render(expected, scene.model, scene.camera, scene.options);
            Nothing nothing;
            EXPECT_EQ(render_observed(observed, scene.model, scene.camera, scene.options, nothing), counts);
            EXPECT_EQ(observed.color8(), expected.color8());
            EXPECT_EQ(observed.depth(), expected.depth());
            for (int i = 0; i < planes; ++i) EXPECT_EQ(observed.extra(i), expected.extra(i)) << i;
        }
    }
}

TEST(Record, EveryTriangleIsThereOnceInTheOrderOfSubmission) {
    for (const TraceScene& scene : trace_scenes()) {
        SCOPED_TRACE(scene.name);
        const auto triangles = record(scene);
        ASSERT_EQ(triangles.size(), scene.model.triangle_count());
        std::vector<int> seen(triangles.size());
        for (std::size_t i = 0; i < triangles.size(); ++i) {
            ++seen[std::size_t(triangles[i].number)];
            EXPECT_EQ(triangles[i].triangle,
                      i == 0 || triangles[i].draw != triangles[i - 1].draw ? 0 : triangles[i - 1].triangle + 1);
        }
        for (const int count : seen) EXPECT_EQ(count, 1);
    }
}

TEST(Record, ItsCornersAreThoseOfTheModel) {
    for (const TraceScene& scene : trace_scenes()) {
        SCOPED_TRACE(scene.name);
        for (const RecordedTriangle& t : record(scene))
            for (std::size_t c = 0; c < 3; ++c) {
                const auto& vertex = scene.model.vertices[scene.model.indices[std::size_t(3 * t.number) + c]];
                ASSERT_EQ(t.corners[c].attributes.size(), 11u);
                for (int i = 0; i < 3; ++i) EXPECT_EQ(t.corners[c].attributes[std::size_t(i)], vertex.position[i]);
                ASSERT_TRUE(t.clip);
                EXPECT_EQ(t.corners[c].clip, t.clip->clip[c]);
            }
    }
}

TEST(Record, ThePixelsThatWereWrittenLastHoldThePicture) {
    int clipped = 0, culled = 0, blended = 0;
    for (const TraceScene& scene : trace_scenes()) {
        SCOPED_TRACE(scene.name);
        Target expected = scene.picture();
        Target target = scene.target();
        target.clear(scene.options.background);
        std::vector<glm::vec4> colors(expected.color8().size(), target.color(0, 0));
        for (const RecordedTriangle& t : record(scene)) {
            clipped += !t.cuts.empty();
            for (const RecordedPiece& piece : t.pieces) {
                ASSERT_TRUE(piece.cull);
                culled += piece.cull->verdict == CullEvent::Verdict::culled;
                EXPECT_EQ(piece.setup.has_value(), piece.cull->verdict == CullEvent::Verdict::kept);
                for (const RecordedPixel& pixel : piece.pixels) {
                    EXPECT_EQ(pixel.depth.has_value(), pixel.coverage.covered);
                    EXPECT_EQ(pixel.blend.has_value(), pixel.depth && pixel.depth->passed);
                    EXPECT_EQ(pixel.outputs.has_value(), pixel.blend.has_value());
                    if (!pixel.blend) continue;
                    glm::vec4& color = colors[target.index(pixel.blend->x, pixel.blend->y)];
                    EXPECT_EQ(pixel.blend->before, color);
                    color = pixel.blend->after;
                    blended += pixel.blend->source.a < 1;
                }
            }
        }
        for (int y = 0; y < scene.height; ++y)
            for (int x = 0; x < scene.width; ++x)
                EXPECT_EQ(colors[target.index(x, y)], expected.color(x, y)) << x << " " << y;
    }
    EXPECT_GT(clipped, 0);
    EXPECT_GT(culled, 0);
    EXPECT_GT(blended, 0);
}

TEST(Record, OnePixelHasTheNumbersThatItHasAmongAll) {
    for (const TraceScene& scene : trace_scenes()) {
        SCOPED_TRACE(scene.name);
        const auto all = record(scene);
        for (const auto& [x, y] : {std::pair(12, 9), {3, 4}, {8, 8}, {15, 0}}) {
            const auto one = record(scene, {WatchedPixels{{x, y, x, y}}, {}});
            ASSERT_EQ(one.size(), all.size());
            for (std::size_t i = 0; i < all.size(); ++i) {
                ASSERT_EQ(one[i].pieces.size(), all[i].pieces.size());
                for (std::size_t p = 0; p < all[i].pieces.size(); ++p) {
                    const auto& pixels = all[i].pieces[p].pixels;
                    const auto found = std::find_if(pixels.begin(), pixels.end(), [&, x = x, y = y](const auto& pixel) {
                        return pixel.coverage.x == x && pixel.coverage.y == y;
                    });
                    const auto& watched = one[i].pieces[p].pixels;
                    ASSERT_EQ(watched.size(), std::size_t(found != pixels.end()));
                    if (watched.empty()) continue;
                    EXPECT_EQ(watched[0].coverage.edges, found->coverage.edges);
                    ASSERT_EQ(watched[0].depth.has_value(), found->depth.has_value());
                    if (found->depth) {
                        EXPECT_EQ(watched[0].depth->stored, found->depth->stored);
                    }
                    ASSERT_EQ(watched[0].blend.has_value(), found->blend.has_value());
                    if (!found->blend) continue;
                    EXPECT_EQ(watched[0].blend->after, found->blend->after);
                    EXPECT_EQ(*watched[0].outputs, *found->outputs);
                }
            }
        }
    }
}

TEST(Record, CoverageOfAllLooksBeyondTheBoxesAndChangesNothing) {
    for (const TraceScene& scene : trace_scenes()) {
        SCOPED_TRACE(scene.name);
        const int x = 11, y = 7;
        const auto near = record(scene, {WatchedPixels{{x, y, x, y}}, {}});
        const auto far = record(scene, {WatchedPixels{{x, y, x, y}, true}, {}});
        ASSERT_EQ(near.size(), far.size());
        for (std::size_t i = 0; i < far.size(); ++i)
            for (std::size_t p = 0; p < far[i].pieces.size(); ++p) {
                const RecordedPiece& piece = far[i].pieces[p];
                EXPECT_EQ(piece.pixels.size(), std::size_t(piece.setup.has_value()));
                if (piece.pixels.empty()) continue;
                EXPECT_EQ(piece.pixels[0].coverage.covered,
                          !near[i].pieces[p].pixels.empty() && near[i].pieces[p].pixels[0].coverage.covered);
            }
    }
}

TEST(Record, OnlyChosenTrianglesAreRecordedAndTheOthersStillHide) {
    const TraceScene scene = trace_scenes()[0];
    const auto all = record(scene);
    const auto some = record(scene, {{}, {5, 40}});
    ASSERT_EQ(some.size(), 2u);
    for (const RecordedTriangle& t : some) {
        const RecordedTriangle& same = all[std::size_t(t.number)];
        ASSERT_EQ(t.pieces.size(), same.pieces.size());
        for (std::size_t p = 0; p < t.pieces.size(); ++p) {
            ASSERT_EQ(t.pieces[p].pixels.size(), same.pieces[p].pixels.size());
            for (std::size_t i = 0; i < t.pieces[p].pixels.size(); ++i) {
                const auto &a = t.pieces[p].pixels[i].depth, &b = same.pieces[p].pixels[i].depth;
                ASSERT_EQ(a.has_value(), b.has_value());
                if (a) {
                    EXPECT_EQ(a->stored, b->stored);
                }
            }
        }
    }
}

}  // namespace
