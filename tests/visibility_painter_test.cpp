// The painter's algorithm: its order, where it equals the z-buffer, and what it gets wrong.
#include <algorithm>

#include <gtest/gtest.h>
#include <raster/scene/render.h>

#include "shading_testing.h"

namespace {

using namespace raster;
using namespace raster::testing;

/// A triangle facing +z at three points, in its own material's colour.
void add_triangle(Model& model, const std::array<glm::vec3, 3>& corners, glm::vec3 color) {
    Material material;
    material.illumination = 0;  // colour alone
    material.diffuse = color;
    model.parts.push_back({"", int(model.materials.size()), std::uint32_t(model.indices.size()), 3});
    model.materials.push_back(material);
    for (const glm::vec3& p : corners) {
        model.indices.push_back(std::uint32_t(model.vertices.size()));
        model.vertices.push_back(vertex_at(p));
    }
}

Target picture(const Model& model, RenderOptions options, const glm::vec3& from = {0, 0, 10}) {
    Camera camera;
    camera.position = from;
    camera.view_angle = 40;
    Target target(96, 96);
    render(target, model, *camera_matrices(camera, 1.0), options);
    return target;
}

Target painted(const Model& model, PainterKey key = PainterKey::centroid, const glm::vec3& from = {0, 0, 10}) {
    RenderOptions options;
    options.visibility = Visibility::painter;
    options.painter_key = key;
    return picture(model, options, from);
}

std::size_t differences(const Target& a, const Target& b) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < a.color8().size(); ++i) count += a.color8()[i] != b.color8()[i];
    return count;
}

const glm::vec3 red(1, 0, 0), green(0, 1, 0), blue(0, 0, 1);

TEST(PainterOrder, IsFarthestFirstByEitherKeyAndKeepsTheOrderOfEquals) {
    Model model;
    const auto at = [&](float z0, float z1, float z2) {
        add_triangle(model, {glm::vec3(0, 0, z0), {1, 0, z1}, {0, 1, z2}}, red);
    };
    at(-3, -3, -3);   // 0: mean 3, farthest 3
    at(-1, -1, -10);  // 1: mean 4, farthest 10
    at(-5, -5, -5);   // 2: mean 5, farthest 5
    at(-3, -3, -3);   // 3: as 0
    const glm::mat4 eye(1.0f);
    EXPECT_EQ(painter_order(model.vertices, model.indices, eye, PainterKey::centroid),
              (std::vector<std::uint32_t>{2, 1, 0, 3}));
    EXPECT_EQ(painter_order(model.vertices, model.indices, eye, PainterKey::farthest_vertex),
              (std::vector<std::uint32_t>{1, 2, 0, 3}));
    EXPECT_TRUE(painter_order(model.vertices, {}, eye).empty());
}

TEST(PainterOrder, TakesDepthsThatAreNoNumbers) {
    const float inf = std::numeric_limits<float>::infinity();
    const std::vector<SurfaceVertex<float>> vertices = {vertex_at({0, 0, inf}), vertex_at({0, 0, -inf}),
                                                        vertex_at({0, inf, 0}), vertex_at({0, 0, -2}),
                                                        vertex_at({0, 0, -1})};
    const std::uint32_t indices[] = {0, 1, 2, 3, 3, 3, 4, 4, 4, 3, 3, 77};
    auto order = painter_order(vertices, indices, glm::mat4(1.0f));
    std::sort(order.begin(), order.end());
    EXPECT_EQ(order, (std::vector<std::uint32_t>{0, 1, 2, 3}));
}

TEST(Painter, EqualsTheZBufferWhereDepthsDoNotOverlap) {
    for (std::uint64_t seed = 0; seed < 10; ++seed) {
        Random random(seed);
        Model model;
        std::vector<int> layers(40);
        for (int i = 0; i < 40; ++i) layers[std::size_t(i)] = i;
        for (int i = 39; i > 0; --i) std::swap(layers[std::size_t(i)], layers[std::size_t(random.integer(0, i))]);
        for (const int layer : layers) {
            // Each in a slab of its own.
            const auto corner = [&] {
                const float x = random.uniform(-3, 3), y = random.uniform(-3, 3);
                return glm::vec3(x, y, 0.1f * float(layer) + random.uniform(0, 0.09f));
            };
            const glm::vec3 a = corner(), b = corner(), c = corner();
            add_triangle(model, {a, b, c}, glm::vec3(0.5f) + 0.5f * unit_vector(random));
        }
        const Target expected = picture(model, {});
        EXPECT_EQ(differences(painted(model), expected), 0u);
        EXPECT_EQ(differences(painted(model, PainterKey::farthest_vertex), expected), 0u);
    }
}

TEST(Painter, DrawsASmoothConvexBodyAsTheZBufferDoes) {
    const Model ball = sphere(32);
    const Target expected = picture(ball, {});
    EXPECT_EQ(differences(painted(ball), expected), 0u);
}

/// Three bars, each over the next and under the one before: no order is right.
Model cyclic_trio() {
    Model model;
    const auto bar = [&](double degrees, glm::vec3 color) {
        const auto turned = [&](float x, float y, float z) {
            const float c = float(std::cos(degrees * 3.14159265358979 / 180)),
                        s = float(std::sin(degrees * 3.14159265358979 / 180));
            return glm::vec3(c * x - s * y, s * x + c * y, z);
        };
        add_triangle(model, {turned(-2.5f, -1.2f, -0.6f), turned(2.8f, -1.0f, 0.6f), turned(-2.5f, -0.6f, -0.6f)},
                     color);
    };
    bar(0, red);
    bar(120, green);
    bar(240, blue);
    return model;
}

TEST(Painter, GetsTheCyclicTrioWrongInAnyOrder) {
    const Model trio = cyclic_trio();
    const Target right = picture(trio, {});
    for (const PainterKey key : {PainterKey::centroid, PainterKey::farthest_vertex})
        EXPECT_GT(differences(painted(trio, key), right), 10u);
    // Whatever the order of drawing: at one of the three crossings the wrong one is on top.
    std::array<int, 3> order = {0, 1, 2};
    do {
        Model flat = trio;
        flat.parts.clear();
        for (const int i : order) flat.parts.push_back(trio.parts[std::size_t(i)]);
        std::vector<std::uint32_t> indices;
        for (std::size_t i = 0; i < 3; ++i) {
            for (std::uint32_t k = 0; k < 3; ++k) {
                indices.push_back(trio.indices[flat.parts[i].first_index + k]);
                flat.vertices[indices.back()].position.z = 0;  // equal depths: drawn as they come
            }
            flat.parts[i].first_index = std::uint32_t(3 * i);
        }
        flat.indices = indices;
        EXPECT_GT(differences(painted(flat), right), 10u);
    } while (std::next_permutation(order.begin(), order.end()));
}

TEST(Painter, GetsTrianglesThatPierceEachOtherWrong) {
    Model cross;
    add_triangle(cross, {glm::vec3(-2, -1, -1), {2, -1, 1}, {0, 2, 0}}, red);
    add_triangle(cross, {glm::vec3(-2, -1, 1), {2, -1, -1}, {0, 2, 0}}, green);
    EXPECT_GT(differences(painted(cross), picture(cross, {})), 100u);
}

TEST(Painter, GetsALargeTriangleUnderASmallOneWrongAlthoughAnOrderExists) {
    // The large one's centroid is nearer than the small one's, but where they overlap it lies behind.
    Model model;
    add_triangle(model, {glm::vec3(-3, -2, -3), {-3, 2, -3}, {6, 0, 6}}, red);
    add_triangle(model, {glm::vec3(-2.5f, -0.5f, -1), {-1.5f, -0.5f, -1}, {-2, 0.5f, -1}}, green);
    const Target right = picture(model, {});
    EXPECT_GT(differences(painted(model, PainterKey::centroid), right), 10u);
    EXPECT_EQ(differences(painted(model, PainterKey::farthest_vertex), right), 0u);
}

}  // namespace
