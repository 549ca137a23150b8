// What an observer is told: every step in order, with the numbers that made the picture.
#include <algorithm>
#include <string>

#include <gtest/gtest.h>

#include "pipeline_testing.h"

namespace {

using namespace raster;
using namespace raster::testing;

struct Nothing {};
static_assert(!Observes<NoObserver, VertexEvent> && !Observes<Nothing, BlendEvent>);

/// Writes each event down as one letter.
struct Letters {
    std::string text;
    void on(const VertexEvent&) { text += 'v'; }
    void on(const AssembleEvent&) { text += 'a'; }
    void on(const ClipPlaneEvent&) { text += 'x'; }
    void on(const ClipEvent&) { text += 'c'; }
    void on(const ProjectEvent&) { text += 'p'; }
    void on(const CullEvent&) { text += 'u'; }
    void on(const SetupEvent&) { text += 's'; }
    void on(const CoverageEvent&) { text += '.'; }
    void on(const DepthEvent&) { text += 'd'; }
    void on(const InterpolateEvent&) { text += 'i'; }
    void on(const FragmentEvent&) { text += 'f'; }
    void on(const BlendEvent&) { text += 'b'; }
};

std::string letters(const Vertices& vertices, const std::vector<std::uint32_t>& indices = {}, const State& state = {},
                    int size = 2) {
    Target target(size, size);
    Letters observer;
    draw(target, Smooth{}, Mesh(vertices, indices), state, observer);
    return observer.text;
}

Vertices triangle(glm::vec4 a, glm::vec4 b, glm::vec4 c) {
    return {{a, glm::vec4(1), {}}, {b, glm::vec4(1), {}}, {c, glm::vec4(1), {}}};
}
/// Covers all of the picture.
const Vertices whole = triangle({-1, -1, 0, 1}, {3, -1, 0, 1}, {-1, 3, 0, 1});
const Vertices corner = triangle({-1, -1, 0, 1}, {0.1f, -1, 0, 1}, {-1, 0.1f, 0, 1});

TEST(Observer, TheStagesOfOnePixelComeInOrder) {
    EXPECT_EQ(letters(corner, {}, {}, 1), "vvvacpus.") << "the centre is just outside";
    EXPECT_EQ(letters(corner), "vvvacpus.difb");
}

TEST(Observer, AClippedTriangleShowsItsCutsThenItsVerdictThenItsPieces) {
    const std::string text = letters(whole, {}, {}, 1);
    EXPECT_EQ(text.substr(0, 9), "vvvaxxcpu") << "cut at the right and at the top";
    EXPECT_EQ(std::count(text.begin(), text.end(), 'p'), std::count(text.begin(), text.end(), 'u'));
    EXPECT_EQ(std::count(text.begin(), text.end(), 'b'), 1) << "one pixel, drawn once";
}

TEST(Observer, WhatIsDroppedEndsWhereItWasDropped) {
    EXPECT_EQ(letters(corner, {0, 1, 9}), "vvva") << "a bad index";
    EXPECT_EQ(letters(triangle({NAN, 0, 0, 1}, {0, 0, 0, 1}, {0, 1, 0, 1})), "vvvac");
    EXPECT_EQ(letters(triangle({5, 0, 0, 1}, {6, 0, 0, 1}, {5, 1, 0, 1})), "vvvac") << "outside";
    EXPECT_EQ(letters(triangle({0, 0, 0, 1}, {0, 0, 0, 1}, {0, 1, 0, 1})), "vvvacpu") << "no area";
    State state;
    state.cull = Cull::front;
    EXPECT_EQ(letters(corner, {}, state), "vvvacpu") << "culled";
    state = {};
    state.depth_compare = Compare::never;
    EXPECT_EQ(letters(corner, {}, state), "vvvacpus.d") << "fails the depth test";
    state = {};
    state.color_write = false;
    EXPECT_EQ(letters(corner, {}, state), "vvvacpus.d") << "no colour is wanted";
    state = {};
    state.viewport = {0, 0, -1, 1};
    EXPECT_EQ(letters(corner, {}, state), "") << "not a viewport";
}

/// Follows every event with its own picture and checks that each continues where the last left off.
class Follower {
public:
    Follower(const Target& target, const State& state)
        : color_(target.color_float()), depth_(target.depth()), width_(target.width()), state_(state) {}

    void on(const AssembleEvent& e) {
        EXPECT_EQ(e.triangle, ++triangle_);
        piece_ = -1;
        ++counts.submitted;
        counts.bad_index += e.bad_index;
    }
    void on(const ClipEvent& e) {
        EXPECT_EQ(e.triangle, triangle_);
        for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(e.outcodes[i], outcode(e.clip[i]));
        counts.not_finite += e.verdict == ClipEvent::Verdict::not_finite;
        counts.outside +=
            e.verdict == ClipEvent::Verdict::outside || (e.verdict == ClipEvent::Verdict::clipped && e.pieces == 0);
        pieces_ = e.pieces;
        fate_ = {};
    }
    void on(const ClipPlaneEvent& e) {
        EXPECT_EQ(e.triangle, triangle_);
        for (const ClipCorner& c : e.after) EXPECT_GE(clip_distance(e.plane, c.clip), -1e-3f);
        for (const ClipCorner& c : e.before) EXPECT_EQ(c.distance, clip_distance(e.plane, c.clip));
    }
    void on(const ProjectEvent& e) {
        EXPECT_EQ(e.piece, ++piece_);
        for (std::size_t i = 0; i < 3; ++i) {
            EXPECT_EQ(e.subpixel[i].x, snap(e.window[i].x));
            EXPECT_EQ(e.subpixel[i].y, snap(e.window[i].y));
        }
        subpixel_ = e.subpixel;
    }
    void on(const CullEvent& e) {
        EXPECT_EQ(e.area, signed_area(subpixel_));
        fate_.any_drawn |= e.verdict == CullEvent::Verdict::kept;
        fate_.any_culled |= e.verdict == CullEvent::Verdict::culled;
        if (e.piece == pieces_ - 1) fate_.count(counts);
        area_ = e.area;
    }
    void on(const SetupEvent& e) {
        setup_ = e.setup;
        oow_ = e.oow;
        planes_.assign(e.varyings.begin(), e.varyings.end());
    }
    void on(const CoverageEvent& e) {
        finish_pixel();
        EXPECT_EQ(e.edges[0] + e.edges[1] + e.edges[2], std::abs(area_));
        bool inside = true;
        for (std::size_t i = 0; i < 3; ++i) {
            EXPECT_EQ(e.edges[i], edge_at(setup_.edges[i], e.x, e.y));
            inside = inside && is_inside(setup_.edges[i], e.edges[i]);
        }
        EXPECT_EQ(e.covered, inside);
        expects_depth_ = e.covered;
    }
    void on(const DepthEvent& e) {
        EXPECT_TRUE(expects_depth_);
        expects_depth_ = false;
        EXPECT_EQ(e.z, value_at(setup_.depth, float(e.x), float(e.y)));
        std::uint32_t& stored = depth_[place(e.x, e.y)];
        EXPECT_EQ(e.stored, stored);
        EXPECT_EQ(e.passed, depth_passes(state_.depth_compare, std::int32_t(e.incoming), std::int32_t(stored)));
        if (e.passed && state_.depth_write) stored = e.incoming;
        expects_blend_ = e.passed && state_.color_write;
    }
    void on(const InterpolateEvent& e) {
        EXPECT_EQ(e.oow, value_at(oow_, float(e.x), float(e.y)));
        ASSERT_EQ(e.varyings.size(), planes_.size());
        const float w = 1 / e.oow;
        for (std::size_t i = 0; i < planes_.size(); ++i) {
            const float value = value_at(planes_[i], float(e.x), float(e.y));
            EXPECT_EQ(e.varyings[i], i < 4 ? value * w : value);  // Full's first four are smooth
        }
        varyings_.assign(e.varyings.begin(), e.varyings.end());
    }
    void on(const FragmentEvent& e) {
        for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(e.outputs[i], varyings_[i]);
        source_ = glm::vec4(e.outputs[0], e.outputs[1], e.outputs[2], e.outputs[3]);
    }
    void on(const BlendEvent& e) {
        EXPECT_TRUE(expects_blend_);
        expects_blend_ = false;
        EXPECT_EQ(e.source, source_);
        glm::vec4& stored = color_[place(e.x, e.y)];
        EXPECT_EQ(e.before, stored);
        EXPECT_EQ(e.after, blend_float(state_.blend, e.source, stored));
        stored = e.after;
    }
    void finish_pixel() { EXPECT_FALSE(expects_depth_ || expects_blend_) << "a pixel stopped halfway"; }

    void expect_explains(const Target& target) {
        finish_pixel();
        EXPECT_TRUE(color_ == target.color_float());
        EXPECT_TRUE(depth_ == target.depth());
    }

    DrawCounts counts;

private:
    std::size_t place(int x, int y) const { return std::size_t(y * width_ + x); }

    std::vector<glm::vec4> color_;
    std::vector<std::uint32_t> depth_;
    int width_;
    State state_;
    std::int64_t triangle_ = -1, area_ = 0;
    int piece_ = -1, pieces_ = 0;
    PieceFate fate_;
    std::array<SubpixelVertex<float>, 3> subpixel_;
    TriangleSetup setup_;
    Plane<float> oow_;
    std::vector<Plane<float>> planes_;
    std::vector<float> varyings_;
    glm::vec4 source_;
    bool expects_depth_ = false, expects_blend_ = false;
};

TEST(Observer, TheEventsExplainEveryPixelAndEveryCount) {
    Random random(seed(1));
    DrawCounts all;
    for (int round = 0; round < 60; ++round) {
        State state = random_state(random);
        Target target(48, 40, ColorFormat::rgba_float);
        target.clear({0.25f, 0.5f, 0.75f, 1}, 0.8f);
        // Wild numbers make NaNs, which are not equal to themselves.
        Vertices vertices = mixed_scene(random, 12, 48, 40, false);
        if (round % 3 == 0) vertices[4].position.x = NAN;
        std::vector<std::uint32_t> indices;
        for (int i = 0; i < 30; ++i) indices.push_back(std::uint32_t(random.integer(0, 36)));
        Follower follower(target, state);
        const DrawCounts counts = draw(target, Full{}, Mesh(vertices, indices), state, follower);
        follower.expect_explains(target);
        EXPECT_EQ(follower.counts, counts);
        all += counts;
        if (HasFailure()) return;
    }
    for (const auto n : {all.bad_index, all.not_finite, all.outside, all.culled, all.zero_area, all.drawn})
        EXPECT_GT(n, 0);
}

TEST(Observer, VerticesAreShownWithWhatWentInAndCameOut) {
    struct Watch {
        std::vector<glm::vec4> clips;
        void on(const VertexEvent& e) {
            EXPECT_EQ(e.vertex, clips.size());
            ASSERT_EQ(e.attributes.size(), 10u);
            ASSERT_EQ(e.varyings.size(), 4u);
            for (std::size_t i = 0; i < 4; ++i) {
                EXPECT_EQ(e.attributes[i], e.clip[int(i)]);
                EXPECT_EQ(e.attributes[4 + i], e.varyings[i]);
            }
            clips.push_back(e.clip);
        }
    } watch;
    Random random(seed(2));
    const Vertices vertices = mixed_scene(random, 5, 10, 10, false);
    Target target(10, 10);
    draw(target, Smooth{}, Mesh(vertices), {}, watch);
    EXPECT_EQ(watch.clips.size(), vertices.size());
}

TEST(Observer, WatchingChangesNothing) {
    Random random(seed(3));
    for (int round = 0; round < 10; ++round) {
        const State state = random_state(random);
        const Vertices vertices = mixed_scene(random, 20, 64, 64, true);
        Target unwatched(64, 64), nothing(64, 64), everything(64, 64);
        const DrawCounts counts = draw(unwatched, Smooth{}, Mesh(vertices), state, NoObserver{});
        EXPECT_EQ(draw(nothing, Smooth{}, Mesh(vertices), state, Nothing{}), counts);
        Letters letters;
        EXPECT_EQ(draw(everything, Smooth{}, Mesh(vertices), state, letters), counts);
        for (const Target* watched : {&nothing, &everything}) {
            EXPECT_EQ(watched->color8(), unwatched.color8());
            EXPECT_EQ(watched->depth(), unwatched.depth());
        }
    }
}

}  // namespace
