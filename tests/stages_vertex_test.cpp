// Stage 1: the vertex function runs on scalars and lanes alike; products are in OpenGL's order.
#include <raster/stages/vertex.h>

#include <gtest/gtest.h>

#include "random.h"

namespace {

using namespace raster;
using raster::testing::Random;

glm::mat4 random_matrix(Random& random) {
    glm::mat4 m;
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 4; ++row) m[column][row] = random.uniform(-10, 10);
    return m;
}

TEST(Vertex, AProductWithTheUnitMatrixChangesNothing) {
    const glm::vec4 v(1.5f, -2.25f, 1e10f, 0.125f);
    EXPECT_EQ(transform(glm::mat4(1), v), v);
    EXPECT_EQ(transform_point(glm::mat4(1), glm::vec3(v)), glm::vec4(glm::vec3(v), 1));
}

TEST(Vertex, ProductsAddUpFromTheLeft) {
    // 1e8 + 1 - 1e8 is 0 in this order and would be 1 in others.
    glm::mat4 m(0);
    m[0][0] = 1e8f, m[1][0] = 1, m[2][0] = -1e8f, m[3][0] = 0;
    EXPECT_EQ(transform(m, glm::vec4(1)).x, 0.0f);
    m[1][0] = -1e8f, m[2][0] = 1;
    EXPECT_EQ(transform(m, glm::vec4(1)).x, 1.0f);
}

TEST(Vertex, TranslationMovesPointsAndNotDirections) {
    glm::mat4 m(1);
    m[3] = glm::vec4(5, 6, 7, 1);
    EXPECT_EQ(transform_point(m, glm::vec3(1, 2, 3)), glm::vec4(6, 8, 10, 1));
    EXPECT_EQ(transform_direction(glm::mat3(m), glm::vec3(1, 2, 3)), glm::vec3(1, 2, 3));
}

TEST(Vertex, EveryRowIsADotProductOfThatRow) {
    Random random(1);
    for (int round = 0; round < 1000; ++round) {
        const glm::mat4 m = random_matrix(random);
        const glm::vec4 v(random.uniform(-1, 1), 2, -3, 0.5f);
        const glm::vec4 r = transform(m, v);
        for (int row = 0; row < 4; ++row) {
            double exact = 0;
            for (int column = 0; column < 4; ++column) exact += double(m[column][row]) * double(v[column]);
            ASSERT_NEAR(r[row], exact, 1e-5);
        }
    }
}

}  // namespace

namespace vertex_test {

using raster::vec;

struct Turned {
    template <class F>
    struct Vertex {
        vec<3, F> position;
        vec<3, F> normal;
        F weight;
    };
    template <class F>
    struct Varyings {
        vec<3, F> normal;
        F weight;
    };
    glm::mat4 m;
    template <class F>
    raster::VertexOut<F, Varyings> vertex(const Vertex<F>& v) const {
        return {raster::transform_point(m, v.position),
                {raster::transform_direction(glm::mat3(m), v.normal), v.weight * F(2)}};
    }
};

}  // namespace vertex_test

namespace {

using vertex_test::Turned;
static_assert(Shader<Turned> && !HasFragment<Turned>);
static_assert(attribute_count<Turned> == 7 && varying_count<Turned> == 4);

TEST(Vertex, ShadingGivesPositionAndVaryingsInDeclarationOrder) {
    const auto out = shade_vertex<Turned, float>(Turned{glm::mat4(1)}, {{1, 2, 3}, {4, 5, 6}, 7});
    EXPECT_EQ(out.clip, glm::vec4(1, 2, 3, 1));
    EXPECT_EQ(out.varyings, (std::array<float, 4>{4, 5, 6, 14}));
}

TEST(Vertex, LanesAreShadedAsScalars) {
    using F = FloatPack<4>;
    Random random(2);
    for (int round = 0; round < 200; ++round) {
        const Turned shader{random_matrix(random)};
        Turned::Vertex<float> scalars[4];
        Turned::Vertex<F> packed;
        for (int lane = 0; lane < 4; ++lane)
            for (int i = 0; i < 3; ++i) {
                packed.position[i].v[lane] = scalars[lane].position[i] = random.uniform(-5, 5);
                packed.normal[i].v[lane] = scalars[lane].normal[i] = random.uniform(-1, 1);
                packed.weight.v[lane] = scalars[lane].weight = float(lane);
            }
        const auto pack = shade_vertex<Turned, F>(shader, packed);
        for (int l = 0; l < 4; ++l) {
            const auto scalar = shade_vertex<Turned, float>(shader, scalars[l]);
            for (int i = 0; i < 4; ++i) {
                ASSERT_EQ(lane(pack.clip[i], l), scalar.clip[i]);
                ASSERT_EQ(lane(pack.varyings[std::size_t(i)], l), scalar.varyings[std::size_t(i)]);
            }
        }
    }
}

TEST(Vertex, VaryingsAndTheirNumbersAreTheSameThing) {
    const Turned::Varyings<float> varyings{{1, 2, 3}, 4};
    const auto numbers = to_array<Turned, float>(varyings);
    EXPECT_EQ(numbers, (std::array<float, 4>{1, 2, 3, 4}));
    const auto back = from_array<Turned, float>(numbers);
    EXPECT_EQ(back.normal, varyings.normal);
    EXPECT_EQ(back.weight, varyings.weight);
}

}  // namespace
