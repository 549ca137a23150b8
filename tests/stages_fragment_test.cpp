// Stage 10: every form of fragment function is called, and returns its numbers in order.
#include <raster/stages/fragment.h>

#include <gtest/gtest.h>

namespace fragment_test {

using raster::FragmentInput;
using raster::vec;

struct Base {
    template <class F>
    struct Vertex {
        vec<4, F> position;
    };
    template <class F>
    struct Varyings {
        vec<2, F> uv;
    };
    template <class F>
    raster::VertexOut<F, Varyings> vertex(const Vertex<F>& v) const {
        return {v.position, {}};
    }
};

struct Plain : Base {
    float gain = 2;
    template <class F>
    vec<4, F> fragment(const Varyings<F>& in) const {
        return {in.uv.x * F(gain), in.uv.y, F(0.5f), F(1)};
    }
};

struct Placed : Base {
    template <class F>
    struct Outputs {
        vec<4, F> color;
        F z, oow;
        vec<2, F> window;
        F triangle;
    };
    template <class F>
    Outputs<F> fragment(const Varyings<F>& in, const FragmentInput<F>& at) const {
        const F side = raster::select(at.front_facing, F(1), F(-1));
        return {{in.uv.x, in.uv.y, side, F(1)}, at.z, at.oow, at.window, raster::to_float(at.triangle)};
    }
};

}  // namespace fragment_test

namespace {

using namespace raster;
using fragment_test::Base;
using fragment_test::Placed;
using fragment_test::Plain;

static_assert(!HasFragment<Base> && HasFragment<Plain> && HasFragment<Placed>);
static_assert(HasPlainFragment<Plain> && !HasPlacedFragment<Plain> && HasPlacedFragment<Placed>);
static_assert(output_count<Plain> == 4 && output_count<Placed> == 9);

constexpr FragmentInput<float> somewhere{{10.5f, 20.5f}, 0.25f, 0.125f, true, 7};

TEST(Fragment, AColourIsFourNumbers) {
    EXPECT_EQ((shade_fragment<Plain, float>(Plain{}, {0.25f, 0.75f}, somewhere)),
              (std::array<float, 4>{0.5f, 0.75f, 0.5f, 1}));
}

TEST(Fragment, OutputsFollowTheColourInDeclarationOrder) {
    EXPECT_EQ((shade_fragment<Placed, float>(Placed{}, {0.25f, 0.75f}, somewhere)),
              (std::array<float, 9>{0.25f, 0.75f, 1, 1, 0.25f, 0.125f, 10.5f, 20.5f, 7}));
    FragmentInput<float> behind = somewhere;
    behind.front_facing = false;
    EXPECT_EQ((shade_fragment<Placed, float>(Placed{}, {0, 0}, behind)[2]), -1);
}

TEST(Fragment, LanesAreShadedAsScalars) {
    using F = FloatPack<4>;
    const F u = to_float(lane_index<F>()) * F(0.1f);
    const FragmentInput<F> at{{u + F(3.5f), F(2.5f)}, u * u, F(0.5f), u < F(0.15f), lane_index<F>()};
    const auto pack = shade_fragment<Placed, F>(Placed{}, {u, u + F(1)}, at);
    for (int l = 0; l < 4; ++l) {
        const float x = lane(u, l);
        const FragmentInput<float> one{{x + 3.5f, 2.5f}, x * x, 0.5f, x < 0.15f, l};
        const auto scalar = shade_fragment<Placed, float>(Placed{}, {x, x + 1}, one);
        for (std::size_t i = 0; i < scalar.size(); ++i) ASSERT_EQ(lane(pack[i], l), scalar[i]);
    }
}

}  // namespace
