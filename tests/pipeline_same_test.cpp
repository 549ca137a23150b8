// The fast draw and the observed draw give the same bits: every plane, every count, any number of threads.
#include <cstring>

#include <gtest/gtest.h>
#include <tbb/global_control.h>
#include <tbb/task_arena.h>

#include "pipeline_testing.h"

namespace {

using namespace raster;
using namespace raster::testing;

/// Planes as bits. NaNs count as one: which of two NaNs an addition hands on is the compiler's choice.
template <class T>
std::vector<std::uint32_t> bits_of(const std::vector<T>& plane) {
    std::vector<std::uint32_t> bits(plane.size() * sizeof(T) / sizeof(std::uint32_t));
    if (!plane.empty()) std::memcpy(bits.data(), plane.data(), bits.size() * sizeof(std::uint32_t));
    if constexpr (!std::is_same_v<T, std::uint32_t>)
        for (auto& b : bits)
            if ((b & 0x7fffffffu) > 0x7f800000u) b = 0x7fc00000u;
    return bits;
}

template <class T>
::testing::AssertionResult same_plane(const char* what, const std::vector<T>& a, const std::vector<T>& b, int width) {
    const auto left = bits_of(a), right = bits_of(b);
    std::size_t different = 0, first = 0;
    for (std::size_t i = 0; i < left.size(); ++i)
        if (left[i] != right[i] && different++ == 0) first = i;
    if (!different) return ::testing::AssertionSuccess();
    const std::size_t pixel = first * a.size() / left.size();
    return ::testing::AssertionFailure() << different << " values of the " << what << " plane differ, first at ("
                                         << pixel % std::size_t(width) << ", " << pixel / std::size_t(width)
                                         << "): " << std::hex << left[first] << " observed, " << right[first]
                                         << " fast";
}

void expect_same(const Target& observed, const Target& fast) {
    const int width = observed.width();
    EXPECT_TRUE(same_plane("colour", observed.color8(), fast.color8(), width));
    EXPECT_TRUE(same_plane("float colour", observed.color_float(), fast.color_float(), width));
    EXPECT_TRUE(same_plane("depth", observed.depth(), fast.depth(), width));
    for (int e = 0; e < observed.extra_channels(); ++e)
        EXPECT_TRUE(same_plane("extra", observed.extra(e), fast.extra(e), width)) << "channel " << e;
}

std::string describe(const DrawCounts& c) {
    std::string text;
    for (const auto n : {c.submitted, c.bad_index, c.not_finite, c.outside, c.culled, c.zero_area, c.drawn})
        text += std::to_string(n) + " ";
    return text;
}

/// Two targets of one kind that every draw goes to in both ways.
class Pair {
public:
    Pair(int width, int height, ColorFormat color = ColorFormat::rgba8, DepthFormat depth = DepthFormat::unorm24,
         int extra = 0)
        : observed(width, height, color, depth, extra), fast(width, height, color, depth, extra) {}

    void clear(glm::vec4 color, float depth) {
        observed.clear(color, depth);
        fast.clear(color, depth);
    }
    template <class S, class M>
    void draw(const S& shader, const M& mesh, const State& state) {
        const DrawCounts a = raster::draw(observed, shader, mesh, state, NoObserver{});
        const DrawCounts b = raster::draw(fast, shader, mesh, state);
        EXPECT_EQ(describe(a), describe(b));
        drawn += a.drawn;
        expect_same(observed, fast);
    }

    Target observed, fast;
    std::int64_t drawn = 0;
};

TEST(Same, EveryDepthBlendAndFormatCombination) {
    Random random(seed(1));
    for (const auto compare : compares)
        for (int bits = 0; bits < 4; ++bits)
            for (const auto blend : {Blend::off, Blend::source_over, Blend::additive})
                for (const auto color : {ColorFormat::rgba8, ColorFormat::rgba_float})
                    for (const auto depth : {DepthFormat::unorm24, DepthFormat::float32}) {
                        State state = random_state(random);
                        state.depth_compare = compare;
                        state.depth_write = bits & 1;
                        state.color_write = bits & 2;
                        state.blend = blend;
                        SCOPED_TRACE(::testing::Message()
                                     << "compare " << int(compare) << " write " << bits << " blend " << int(blend)
                                     << " colour " << int(color) << " depth " << int(depth));
                        Pair pair(70, 67, color, depth, 7);
                        pair.clear({0.1f, 0.2f, 0.3f, 0.4f}, compare == Compare::equal ? 0.5f : 0.6f);
                        const Vertices vertices = mixed_scene(random, 20, 70, 67, false);
                        pair.draw(Full{}, Mesh(vertices), state);
                        pair.draw(Smooth{}, Mesh(vertices), state);
                        if (::testing::Test::HasFailure()) return;
                    }
}

TEST(Same, EveryCullFillAndTopologyCombination) {
    Random random(seed(2));
    for (const auto topology : {Topology::triangles, Topology::triangle_strip, Topology::triangle_fan})
        for (const auto cull : {Cull::none, Cull::back, Cull::front, Cull::both})
            for (const auto front : {FrontFace::counter_clockwise, FrontFace::clockwise})
                for (const auto fill : {FillRule::bottom_left, FillRule::top_left}) {
                    State state;
                    state.topology = topology, state.cull = cull, state.front_face = front, state.fill_rule = fill;
                    Pair pair(130, 75, ColorFormat::rgba8, DepthFormat::unorm24, 7);
                    const Vertices vertices = mixed_scene(random, 40, 130, 75, false);
                    pair.draw(Full{}, Mesh(vertices), state);
                    EXPECT_EQ(pair.drawn > 0, cull != Cull::both);
                    if (::testing::Test::HasFailure()) return;
                }
}

TEST(Same, LinesPointsScissorOffsetsAndClipPlanes) {
    Random random(seed(9));
    for (int i = 0; i < 300; ++i) {
        const int width = random.integer(1, 200), height = random.integer(1, 150);
        Pair pair(width, height, ColorFormat(i & 1), DepthFormat(i >> 1 & 1), 7);
        if (i % 3) pair.clear({0.1f, 0.2f, 0.3f, 0.4f}, 0.6f);
        for (int draw = 0; draw < 3; ++draw) {
            State state = random_state(random);
            std::vector<glm::vec4> planes;
            add_rare_state(state, random, width, height, planes);
            SCOPED_TRACE(::testing::Message()
                         << "round " << i << ", draw " << draw << ", topology " << int(state.topology));
            const Vertices vertices = mixed_scene(random, 12, width, height, i % 4 == 0);
            pair.draw(Full{}, Mesh(vertices), state);
            if (::testing::Test::HasFailure()) return;
        }
    }
}

TEST(Same, SizesThatFitNoTile) {
    Random random(seed(3));
    constexpr int sizes[][2] = {{1, 1},     {1, 300},  {300, 1},   {2, 2},   {3, 5},    {7, 63},
                                {8, 8},     {15, 17},  {63, 64},   {64, 64}, {65, 65},  {127, 129},
                                {128, 128}, {200, 33}, {257, 255}, {640, 3}, {33, 640}, {333, 222}};
    for (const auto& [width, height] : sizes) {
        SCOPED_TRACE(::testing::Message() << width << " x " << height);
        Pair pair(width, height, ColorFormat::rgba8, DepthFormat::unorm24, 3);
        for (int draw = 0; draw < 4; ++draw)
            pair.draw(Full{}, Mesh(mixed_scene(random, 30, width, height, draw & 1)), random_state(random));
        EXPECT_GT(pair.drawn, 0);
        if (::testing::Test::HasFailure()) return;
    }
}

TEST(Same, ViewportsInsideAcrossAndBeyondTheTarget) {
    Random random(seed(4));
    std::vector<Viewport> viewports = {{0, 0, 0, 0},
                                       {10, 20, 50, 30},
                                       {-40, -30, 200, 150},
                                       {90, 60, 100, 100},
                                       {0, 0, 1, 1},
                                       {5, 5, 3, 200},
                                       {-16384, -16384, 32768, 32768},
                                       {-16384, 0, 20000, 80},
                                       {200, 0, 10, 10},
                                       {-50, 0, 40, 40},
                                       {0, 0, 100, 0},
                                       {0, 0, 20000, 10},
                                       {0, 0, -5, 10},
                                       {-20000, 0, 20, 20},
                                       {0, 0, 100, 80, 1.0f, 0.0f},
                                       {0, 0, 100, 80, 0.25f, 0.5f},
                                       {0, 0, 100, 80, 0.5f, 0.5f}};
    for (int i = 0; i < 20; ++i) {
        const int x = random.integer(-100, 100), y = random.integer(-100, 100), width = random.integer(1, 300);
        viewports.push_back({x, y, width, random.integer(1, 300)});
    }
    for (const Viewport& viewport : viewports) {
        SCOPED_TRACE(::testing::Message()
                     << viewport.x << " " << viewport.y << " " << viewport.width << " " << viewport.height);
        Pair pair(100, 80, ColorFormat::rgba8, DepthFormat::unorm24, 7);
        State state = random_state(random);
        state.viewport = viewport;
        pair.draw(Full{}, Mesh(mixed_scene(random, 30, 100, 80, false)), state);
        pair.draw(Full{}, Mesh(mixed_scene(random, 30, 100, 80, true)), state);
        if (::testing::Test::HasFailure()) return;
    }
}

TEST(Same, EachGroupOfTrianglesAlone) {
    for (int group = 0; group <= int(Group::wild); ++group) {
        SCOPED_TRACE(name(Group(group)));
        Random random(seed(std::uint64_t(50 + group)));
        Pair pair(256, 160, ColorFormat::rgba8, DepthFormat::unorm24, 7);
        Vertices vertices;
        for (int i = 0; i < 60; ++i) add_triangle(vertices, make_triangle(Group(group), random, 256, 160), random);
        pair.draw(Full{}, Mesh(vertices), {});
        EXPECT_GT(pair.drawn, 0);
        if (::testing::Test::HasFailure()) return;
    }
}

TEST(Same, ShadersWithoutVaryingsOrWithoutColour) {
    Random random(seed(6));
    Pair pair(150, 150);
    for (int draw = 0; draw < 12; ++draw) {
        const Vertices vertices = mixed_scene(random, 30, 150, 150, draw & 1);
        const State state = random_state(random);
        if (draw % 2)
            pair.draw(Uniform{}, Mesh(vertices), state);
        else
            pair.draw(DepthOnly{}, Mesh(vertices), state);
    }
    EXPECT_GT(pair.drawn, 0);
}

TEST(Same, OneColourATriangle) {
    Random random(seed(14));
    for (const auto blend : {Blend::off, Blend::source_over, Blend::additive})
        for (const auto color : {ColorFormat::rgba8, ColorFormat::rgba_float})
            for (const int width : {64, 131, 200, 3})
                for (const int extra : {0, 1}) {
                    SCOPED_TRACE(::testing::Message() << "blend " << int(blend) << " colour " << int(color) << " width "
                                                      << width << " extra " << extra);
                    Pair pair(width, 75, color, DepthFormat(random.integer(0, 1)), extra);
                    for (int draw = 0; draw < 6; ++draw) {
                        State state = random_state(random);
                        state.blend = blend;
                        if (draw % 2) state.depth_compare = Compare::always;
                        const Vertices vertices = mixed_scene(random, 30, width, 75, draw & 1);
                        pair.draw(Facets{}, Mesh(vertices), state);
                        if (extra == 0) pair.draw(Uniform{}, Mesh(vertices), state);
                    }
                    EXPECT_GT(pair.drawn, 0);
                    if (::testing::Test::HasFailure()) return;
                }
}

TEST(Same, IndicesSharedBadAndInTheHighestThousands) {
    Random random(seed(7));
    for (const auto topology : {Topology::triangles, Topology::triangle_strip, Topology::triangle_fan}) {
        const Vertices vertices = mixed_scene(random, 100, 120, 90, false);
        std::vector<std::uint32_t> indices;
        for (int i = 0; i < 500; ++i) {
            const bool bad = random.integer(0, 40) == 0;
            indices.push_back(bad ? (random.integer(0, 1) ? 0xffffffffu : std::uint32_t(vertices.size()))
                                  : std::uint32_t(random.integer(0, int(vertices.size()) - 1)));
        }
        if (topology == Topology::triangle_fan) indices[0] = 0;
        State state;
        state.topology = topology;
        Pair pair(120, 90, ColorFormat::rgba8, DepthFormat::unorm24, 7);
        pair.draw(Full{}, Mesh(vertices, indices), state);
        EXPECT_GT(pair.drawn, 0);
    }
}

TEST(Same, MeshesOfNothingAndOfIncompleteTriangles) {
    Random random(seed(8));
    for (const auto topology : {Topology::triangles, Topology::triangle_strip, Topology::triangle_fan})
        for (std::size_t count = 0; count <= 7; ++count) {
            Vertices vertices = mixed_scene(random, 3, 40, 40, false);
            vertices.resize(count);
            State state;
            state.topology = topology;
            Pair pair(40, 40);
            pair.draw(Smooth{}, Mesh(vertices), state);
            const std::vector<std::uint32_t> indices = {0, 1, 2, 3, 4};
            pair.draw(Smooth{}, Mesh(vertices, indices), state);
        }
}

TEST(Same, FewerExtraPlanesThanOutputs) {
    Random random(seed(9));
    const Vertices vertices = mixed_scene(random, 30, 100, 100, false);
    for (int extra = 0; extra <= 9; ++extra) {
        Pair pair(100, 100, ColorFormat::rgba_float, DepthFormat::float32, extra);
        pair.draw(Full{}, Mesh(vertices), {});
    }
}

TEST(Same, ManyTinyTriangles) {
    Random random(seed(10));
    Vertices vertices;
    for (int i = 0; i < 30000; ++i) {
        const auto group = i % 100 == 0 ? Group::clip_all : Group::small;
        add_triangle(vertices, make_triangle(group, random, 320, 240), random);
    }
    for (const auto blend : {Blend::off, Blend::source_over}) {
        State state;
        state.blend = blend;
        Pair pair(320, 240, ColorFormat::rgba8, DepthFormat::unorm24, 7);
        pair.draw(Full{}, Mesh(vertices), state);
    }
}

TEST(Same, FullHighDefinition) {
    Random random(seed(11));
    Pair pair(1920, 1080);
    State state;
    state.blend = Blend::source_over;
    pair.draw(Smooth{}, Mesh(mixed_scene(random, 30, 1920, 1080, true)), {});
    pair.draw(Smooth{}, Mesh(mixed_scene(random, 30, 1920, 1080, true)), state);
}

TEST(Same, ManySeededStatesOnOnePicture) {
    Random random(seed(12));
    for (int picture = 0; picture < 25; ++picture) {
        const int width = random.integer(1, 200), height = random.integer(1, 200);
        Pair pair(width, height, ColorFormat(random.integer(0, 1)), DepthFormat(random.integer(0, 1)), 7);
        pair.clear({0.3f, 0.6f, 0.1f, 0.9f}, random.uniform(0, 1));
        for (int draw = 0; draw < 8; ++draw) {
            SCOPED_TRACE(::testing::Message() << "picture " << picture << " draw " << draw);
            State state = random_state(random);
            if (random.integer(0, 3) == 0) {
                state.viewport = {random.integer(-30, 30), random.integer(-30, 30), random.integer(1, 250),
                                  random.integer(1, 250)};
            }
            pair.draw(Full{random.uniform(0, 2)}, Mesh(mixed_scene(random, 12, width, height, true)), state);
            if (::testing::Test::HasFailure()) return;
        }
    }
}

TEST(Same, AnyNumberOfThreads) {
    Random random(seed(13));
    Vertices vertices = mixed_scene(random, 2000, 400, 300, true);
    for (int i = 0; i < 3000; ++i) add_triangle(vertices, make_triangle(Group::small, random, 400, 300), random);
    for (const auto blend : {Blend::off, Blend::source_over}) {
        State state;
        state.blend = blend;
        Target observed(400, 300, ColorFormat::rgba8, DepthFormat::unorm24, 7);
        const DrawCounts expected = draw(observed, Full{}, Mesh(vertices), state, NoObserver{});
        for (const int threads : {1, 2, 3, 8, 17}) {
            SCOPED_TRACE(::testing::Message() << threads << " threads");
            const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, std::size_t(threads));
            tbb::task_arena arena(threads);
            Target fast(400, 300, ColorFormat::rgba8, DepthFormat::unorm24, 7);
            arena.execute([&] { EXPECT_EQ(describe(draw(fast, Full{}, Mesh(vertices), state)), describe(expected)); });
            expect_same(observed, fast);
        }
    }
}

}  // namespace
