// Lines, points, scissor rectangles, moved depths and clip planes, with pictures that are known on paper.
#include <gtest/gtest.h>

#include "pipeline_testing.h"

namespace {

using namespace raster;
using namespace raster::testing;

constexpr int size = 100;  // more than one tile

glm::vec4 at(float x, float y, float z = 0) { return clip_at(x, y, z, 1, size, size); }

Vertices vertices_at(const std::vector<glm::vec4>& positions, glm::vec4 color = glm::vec4(1)) {
    Vertices vertices;
    for (const glm::vec4& p : positions) vertices.push_back({p, color, {0, 0}});
    return vertices;
}

/// Two triangles over the whole target, `tilt` deeper at the right border than at the left.
Vertices full_screen(float z = 0, float tilt = 0) {
    const float right = z + tilt;
    return vertices_at({at(0, 0, z), at(0, size, z), at(size, size, right), at(0, 0, z), at(size, size, right),
                        at(size, 0, right)});
}

/// Draws by both ways, which must agree, and gives the target of the fast one.
class Canvas {
public:
    DrawCounts draw(const Vertices& vertices, const State& state, std::span<const std::uint32_t> indices = {}) {
        const Mesh<Full::Vertex<float>> mesh{vertices, indices};
        const DrawCounts counts = raster::draw(fast, Smooth{}, mesh, state);
        EXPECT_EQ(raster::draw(observed, Smooth{}, mesh, state, NoObserver{}), counts);
        EXPECT_EQ(fast.color8(), observed.color8());
        EXPECT_EQ(fast.depth(), observed.depth());
        return counts;
    }
    /// How many pixels are not as they were cleared.
    int drawn() const { return int(std::ranges::count_if(fast.color8(), [](std::uint32_t c) { return c != 0; })); }
    bool is_drawn(int x, int y) const { return fast.color8()[fast.index(x, y)] != 0; }
    int drawn_in(int x0, int y0, int x1, int y1) const {
        int count = 0;
        for (int y = y0; y <= y1; ++y)
            for (int x = x0; x <= x1; ++x) count += is_drawn(x, y);
        return count;
    }

    Target fast{size, size}, observed{size, size};
};

State lines(int width = 1, Topology topology = Topology::lines) {
    State state;
    state.topology = topology;
    state.line_width = width;
    return state;
}

TEST(State, ALineCoversThePixelsWhoseDiamondsItLeaves) {
    Canvas canvas;
    const DrawCounts counts = canvas.draw(vertices_at({at(10.5f, 40.5f), at(80.5f, 40.5f)}), lines());
    EXPECT_EQ(counts.drawn, 1);
    EXPECT_EQ(canvas.drawn(), 70);  // not the last
    EXPECT_EQ(canvas.drawn_in(10, 40, 79, 40), 70);
}

TEST(State, ALineIsAsWideAsItIsTold) {
    for (int width = 1; width <= 5; ++width) {
        Canvas canvas;
        canvas.draw(vertices_at({at(40.5f, 10.5f), at(40.5f, 80.5f)}), lines(width));
        EXPECT_EQ(canvas.drawn(), 70 * width) << width;
        EXPECT_TRUE(canvas.is_drawn(40, 50));
    }
}

TEST(State, AClosedLoopDrawsEveryPixelOnce) {
    Canvas canvas;
    const Vertices square =
        vertices_at({at(20.4f, 20.3f), at(70.4f, 20.3f), at(70.4f, 70.3f), at(20.4f, 70.3f)}, glm::vec4(0.2f));
    State state = lines(1, Topology::line_loop);
    state.blend = Blend::additive;
    state.depth_compare = Compare::always;
    EXPECT_EQ(canvas.draw(square, state).drawn, 4);
    EXPECT_EQ(canvas.drawn(), 200);
    for (const std::uint32_t color : canvas.fast.color8()) ASSERT_TRUE(color == 0 || color == 0x33333333u);
    EXPECT_EQ(canvas.draw(square, lines(1, Topology::line_strip)).drawn, 3);
}

TEST(State, PointsAreSquaresOfWholePixels) {
    State state;
    state.topology = Topology::points;
    for (int pixels = 1; pixels <= 7; ++pixels) {
        Canvas canvas;
        state.point_size = float(pixels);
        EXPECT_EQ(canvas.draw(vertices_at({at(50.5f, 50.5f)}), state).drawn, 1);
        EXPECT_EQ(canvas.drawn(), pixels * pixels) << pixels;
        EXPECT_TRUE(canvas.is_drawn(50, 50));
    }
}

TEST(State, LinesAndPointsAreCounted) {
    const glm::vec4 nan(std::numeric_limits<float>::quiet_NaN());
    Canvas canvas;
    const std::vector<std::uint32_t> indices = {0, 1, 0, 2, 0, 99, 3, 4, 0, 0};
    const Vertices vertices = vertices_at({at(10, 10), at(50, 30), nan, at(200, 10), at(300, 10)});
    const DrawCounts counts = canvas.draw(vertices, lines(), indices);
    EXPECT_EQ(counts.submitted, 5);
    EXPECT_EQ(counts.drawn, 1);
    EXPECT_EQ(counts.not_finite, 1);
    EXPECT_EQ(counts.bad_index, 1);
    EXPECT_EQ(counts.outside, 1);
    EXPECT_EQ(counts.zero_area, 1);
    State points;
    points.topology = Topology::points;
    EXPECT_EQ(canvas.draw(vertices, points).outside, 2);
}

TEST(State, AScissorRectangleIsFilledAndNothingElse) {
    for (const Scissor s :
         {Scissor{10, 20, 60, 50}, Scissor{-5, -5, 6, 6}, Scissor{63, 63, 2, 2}, Scissor{90, 0, 99, 99},
          Scissor{10, 10, 0, 5}, Scissor{10, 10, 2147483647, 1}, Scissor{0, 0, size, size}}) {
        for (const Blend blend : {Blend::off, Blend::additive}) {
            Canvas canvas;
            State state;
            state.scissor = s;
            state.blend = blend;
            canvas.draw(full_screen(), state);
            const int x0 = std::max(s.x, 0), y0 = std::max(s.y, 0);
            const int width = int(std::min<std::int64_t>(std::int64_t(s.x) + s.width, size)) - x0;
            const int height = int(std::min<std::int64_t>(std::int64_t(s.y) + s.height, size)) - y0;
            EXPECT_EQ(canvas.drawn(), width * height);
            EXPECT_EQ(canvas.drawn_in(x0, y0, x0 + width - 1, y0 + height - 1), width * height);
            for (std::size_t i = 0; i < canvas.fast.depth().size(); ++i)
                ASSERT_EQ(canvas.fast.depth()[i] == 0xffffff, canvas.fast.color8()[i] == 0);
        }
    }
}

TEST(State, UnitsOfDepthOffsetDecideBetweenEqualDepths) {
    for (const float units : {-1.0f, 1.0f}) {
        Canvas canvas;
        State state;
        state.color_write = false;
        canvas.draw(full_screen(0.25f, 0.3f), state);
        state.color_write = true;
        state.depth_offset.units = units;
        canvas.draw(full_screen(0.25f, 0.3f), state);
        EXPECT_EQ(canvas.drawn(), units < 0 ? size * size : 0);
    }
}

TEST(State, FactorOfDepthOffsetIsTheSlopeOfOnePixel) {
    Canvas plain, moved;
    State state;
    plain.draw(full_screen(-0.5f, 1), state);
    state.depth_offset.factor = 3;
    moved.draw(full_screen(-0.5f, 1), state);
    for (int x = 0; x + 3 < size; ++x)
        EXPECT_NEAR(moved.fast.depth(x, 50), plain.fast.depth(x + 3, 50), 1e-6f) << x;
}

TEST(State, ClipPlanesCutTheVolume) {
    const std::vector<glm::vec4> planes = {{1, 0, 0, 0}, {0, 1, 0, 0}};
    State state;
    for (std::size_t count = 1; count <= 2; ++count) {
        Canvas canvas;
        state.clip_planes = std::span(planes).first(count);
        canvas.draw(full_screen(), state);
        EXPECT_EQ(canvas.drawn(), count == 1 ? 5000 : 2500);
        EXPECT_EQ(canvas.drawn_in(50, 0, 99, 49), 2500);  // right, and up
    }
    Canvas canvas;
    state.topology = Topology::lines;
    canvas.draw(vertices_at({at(10.5f, 10.5f), at(90.5f, 10.5f)}), state);
    EXPECT_EQ(canvas.drawn(), 40);
    state.topology = Topology::points;
    EXPECT_EQ(canvas.draw(vertices_at({at(10, 10), at(60, 60), at(60, 10)}), state).outside, 2);
}

TEST(State, PlanesBeyondTheEighthDoNothing) {
    std::vector<glm::vec4> planes(8, glm::vec4(0, 0, 0, 1));
    planes.push_back({0, 0, 0, -1});
    State state;
    state.clip_planes = planes;
    Canvas canvas;
    canvas.draw(full_screen(), state);
    EXPECT_EQ(canvas.drawn(), size * size);
    state.clip_planes = std::span(planes).subspan(1);
    EXPECT_EQ(canvas.draw(full_screen(), state).outside, 2);
}

}  // namespace
