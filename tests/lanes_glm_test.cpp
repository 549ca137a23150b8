// GLM's vectors over packs: each lane gets what a vector of floats gets. Built twice: with the compiler's vectors and without.
#include <raster/lanes.h>

#include <array>

#include <gtest/gtest.h>

#include "random.h"

namespace {

using namespace raster;
using raster::testing::Random;

/// A NaN is a NaN: whose sign and payload it carries is not defined.
std::uint32_t number_bits(float x) { return x == x ? std::bit_cast<std::uint32_t>(x) : 0x7fc00000u; }

template <class F>
class LanesGlm : public ::testing::Test {
protected:
    Random random{42};
};

using Packs = ::testing::Types<FloatPack<4>, FloatPack<8>, FloatPack<16>>;
TYPED_TEST_SUITE(LanesGlm, Packs);

/// make(a, b, c) over vectors of packs against the same over vectors of floats. Numbers that shaders have.
template <class F, class Make>
void same_glm(Random& random, const Make& make) {
    for (int round = 0; round < 500; ++round) {
        vec<3, F> packs[3];
        std::array<vec<3, float>, 3> scalars[lanes<F>];
        for (int v = 0; v < 3; ++v)
            for (int component = 0; component < 3; ++component) {
                std::array<float, lanes<F>> values;
                for (int i = 0; i < lanes<F>; ++i) {
                    values[std::size_t(i)] = random.integer(0, 9) ? random.uniform(-4, 4) : 0.0f;
                    scalars[i][std::size_t(v)][component] = values[std::size_t(i)];
                }
                packs[v][component] = load<F>(values.data());
            }
        const auto result = make(packs[0], packs[1], packs[2]);
        for (int i = 0; i < lanes<F>; ++i) {
            const auto want = make(scalars[i][0], scalars[i][1], scalars[i][2]);
            if constexpr (std::is_same_v<std::remove_cvref_t<decltype(want)>, float>) {
                ASSERT_EQ(number_bits(lane(result, i)), number_bits(want));
            } else {
                for (int c = 0; c < want.length(); ++c)
                    ASSERT_EQ(number_bits(lane(result[c], i)), number_bits(want[c]));
            }
        }
    }
}

#define SAME_GLM(expression)          \
    same_glm<TypeParam>(this->random, \
                        [](auto a, [[maybe_unused]] auto b, [[maybe_unused]] auto c) { return expression; })

TYPED_TEST(LanesGlm, OverPacksIsGlmOverFloats) {
    SAME_GLM(a + b);
    SAME_GLM(a - b * c);
    SAME_GLM(a / b);
    SAME_GLM(-a);
    SAME_GLM(a * b.x);
    SAME_GLM(glm::dot(a, b));
    SAME_GLM(glm::cross(a, b));
    SAME_GLM(glm::length(a));
    SAME_GLM(glm::normalize(a));
    SAME_GLM(glm::reflect(a, b));
    SAME_GLM(glm::mix(a, b, c.x));
    SAME_GLM(dot0(a, b));
}

TYPED_TEST(LanesGlm, UniformsMixWithPacks) {
    SAME_GLM(a * 2.5f);
    SAME_GLM(2.5f * a + 1.0f);
    SAME_GLM((a + glm::vec3(1, 2, 3)) * glm::vec3(4, 5, 6));
    SAME_GLM(glm::vec3(1, 2, 3) / a - glm::vec3(4, 5, 6));
    SAME_GLM(1.0f - a);
}

TYPED_TEST(LanesGlm, VectorsAreChosenLaneByLane) { SAME_GLM(select(a.x < b.y, a, b)); }

}  // namespace
