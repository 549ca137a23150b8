// The shaders over lanes give the scalar's bits, also with a reflectance model that is not in the tree.
#include <raster/shading/cook_torrance.h>
#include <raster/shading/oren_nayar.h>
#include <raster/shading/sunlit_shader.h>

#include "shading_scene.h"

namespace {

using namespace raster;
using namespace raster::testing;

/// Runs a shader's fragment on seeded varyings for n lanes and for the scalar, and compares all bits.
template <class S>
void expect_lanes_equal_scalar(const S& shader) {
    constexpr int n = 8;
    using F = FloatPack<n>;
    Random random(31);
    for (int round = 0; round < 200; ++round) {
        VaryingArray<S, F> packed;
        for (auto& v : packed)
            for (int i = 0; i < n; ++i) set_lane(v, i, random.uniform(-2, 2));
        FragmentInput<F> at{};
        IntPack<n> triangle(0), front(0);
        for (int i = 0; i < n; ++i) {
            triangle.v[i] = random.integer(0, 4);
            front.v[i] = -random.integer(0, 1);
        }
        at.triangle = triangle;
        at.front_facing = MaskPack<n>(front.v);
        const auto outputs = shade_fragment<S, F>(shader, packed, at);
        for (int i = 0; i < n; ++i) {
            VaryingArray<S> scalar;
            for (std::size_t k = 0; k < scalar.size(); ++k) scalar[k] = lane(packed[k], i);
            FragmentInput<float> here{};
            here.triangle = lane(triangle, i);
            here.front_facing = front.v[i] != 0;
            const auto expected = shade_fragment<S, float>(shader, scalar, here);
            for (std::size_t k = 0; k < expected.size(); ++k) {
                ASSERT_EQ(bits_of(expected[k]), bits_of(lane(outputs[k], i)));
                ASSERT_EQ(expected[k], expected[k]) << "NaN";
            }
        }

        typename S::template Vertex<F> vertices;
        std::array<typename S::template Vertex<float>, n> single;
        float numbers[attribute_count<S>];
        std::array<F, std::size_t(attribute_count<S>)> attributes;
        for (int i = 0; i < n; ++i) {
            for (int k = 0; k < attribute_count<S>; ++k) {
                numbers[k] = random.uniform(-2, 2);
                set_lane(attributes[std::size_t(k)], i, numbers[k]);
            }
            std::memcpy(static_cast<void*>(&single[std::size_t(i)]), numbers, sizeof numbers);
        }
        std::memcpy(static_cast<void*>(&vertices), attributes.data(), sizeof attributes);
        const auto shaded = shade_vertex<S, F>(shader, {vertices});
        for (int i = 0; i < n; ++i) {
            const auto expected = shade_vertex<S, float>(shader, single[std::size_t(i)]);
            for (std::size_t k = 0; k < expected.varyings.size(); ++k)
                ASSERT_EQ(bits_of(expected.varyings[k]), bits_of(lane(shaded.varyings[k], i)));
            for (int k = 0; k < 4; ++k) ASSERT_EQ(bits_of(expected.clip[k]), bits_of(lane(shaded.clip[k], i)));
        }
    }
}

TEST(Shaders, GiveLanesExactlyWhatTheyGiveTheScalar) {
    Scene scene(three_kinds_of_light()), sunlit({Light{}});
    scene.set_texture(checker());
    scene.u.material.vertex_colors = true;
    Random random(32);
    std::vector<FaceLight> faces(5);
    for (FaceLight& face : faces) {
        face.normal_eye = unit_vector(random);
        face.lit = {unit_vector(random), unit_vector(random)};
        face.color = unit_vector(random);
    }
    const std::int32_t numbers[] = {17, 3, 0, 99, 5};
    scene.u.triangle_numbers = numbers;
    for (const bool two_sided : {false, true}) {
        scene.u.two_sided = sunlit.u.two_sided = two_sided;
        expect_lanes_equal_scalar(PixelShader<Lambert, Detail::plain>{scene.u, {}});
        expect_lanes_equal_scalar(SunlitShader<Lambert>(sunlit.u, {}));
        expect_lanes_equal_scalar(SunlitShader<Phong>(sunlit.u, {20}));
        expect_lanes_equal_scalar(SunlitShader<BlinnPhong>(sunlit.u, {20}));
        expect_lanes_equal_scalar(SunlitShader<CookTorrance>(sunlit.u, {}));
        expect_lanes_equal_scalar(SunlitShader<CookTorrance>(sunlit.u, {{{0.2f, 0.9f, 1.1f}, {3.9f, 2.4f, 2.2f}}}));
        expect_lanes_equal_scalar(SunlitShader<OrenNayar>(sunlit.u, {}));
        expect_lanes_equal_scalar(PixelShader<Phong, Detail::mapped>{scene.u, {20}});
        expect_lanes_equal_scalar(PixelShader<BlinnPhong, Detail::plain>{scene.u, {20}});
        expect_lanes_equal_scalar(PixelShader<RuntimeModel, Detail::terms>{scene.u, {BlinnPhong{}}});
        expect_lanes_equal_scalar(GouraudShader<Detail::plain>{scene.u, {Phong{20}}});
        expect_lanes_equal_scalar(GouraudShader<Detail::mapped>{scene.u, {BlinnPhong{20}}});
        expect_lanes_equal_scalar(GouraudShader<Detail::terms>{scene.u, {Lambert{}}});
        expect_lanes_equal_scalar(FlatShader<Detail::plain>{scene.u, faces});
        expect_lanes_equal_scalar(FlatShader<Detail::mapped>{scene.u, faces});
        expect_lanes_equal_scalar(FlatShader<Detail::terms>{scene.u, faces});
    }
}

TEST(Shaders, LightFacesInLanesExactlyAsOneByOne) {
    const Scene scene(three_kinds_of_light());
    Random random(33);
    std::vector<SurfaceVertex<float>> vertices;
    for (int i = 0; i < 3 * 101; ++i)
        vertices.push_back(vertex_at(unit_vector(random) * 2.0f, {}, {}, unit_vector(random)));
    const RuntimeModel model{BlinnPhong{}};
    const auto faces = light_faces(scene.u, model, {vertices, {}});
    ASSERT_EQ(faces.size(), 101u);
    for (std::size_t i = 0; i < faces.size(); ++i) {
        const auto* v = &vertices[3 * i];
        const auto expected = light_face<float>(scene.u, model, {{v[0].position, v[1].position, v[2].position}, {}});
        for (int c = 0; c < 3; ++c) {
            ASSERT_EQ(bits_of(faces[i].lit.diffuse[c]), bits_of(expected.lit.diffuse[c]));
            ASSERT_EQ(bits_of(faces[i].lit.specular[c]), bits_of(expected.lit.specular[c]));
            ASSERT_EQ(bits_of(faces[i].normal_eye[c]), bits_of(expected.normal_eye[c]));
        }
    }
    const std::uint32_t indices[] = {0, 1, 2, 0, 1, 9999999};
    const auto indexed = light_faces(scene.u, model, {vertices, indices});
    EXPECT_EQ(indexed[0].normal_eye, faces[0].normal_eye);
    EXPECT_EQ(indexed[1].normal_eye, glm::vec3(0.0f));
    EXPECT_TRUE(light_faces(scene.u, model, {}).empty());
}

/// A reflectance that is not in the tree, as its author would write it: brushed metal, after Ward 1992 without his
/// normalisation.
struct Brushed {
    static constexpr std::string_view name = "brushed";
    static constexpr bool anisotropic = true;
    float along = 0.5f, across = 0.1f;

    Brushed with_material(const Material&) const { return *this; }
    template <class F>
    Reflectance<F> evaluate(const Frame<F>& frame, const vec<3, F>& l) const {
        const vec<3, F> h = normalize_or_zero(l + frame.v);
        const F x = glm::dot(h, frame.t) / F(along), y = glm::dot(h, frame.b) / F(across);
        const F n_h = max(glm::dot(h, frame.n), F(1e-3f));
        const F highlight = raster::exp(-(x * x + y * y) / (n_h * n_h));
        return {grey(dot0(frame.n, l)), grey(select(glm::dot(frame.n, l) > F(0), highlight, F(0)))};
    }
};

TEST(Shaders, TakeAModelOfTheUsersThatTurnsWithTheGrain) {
    static_assert(ReflectanceModel<Brushed>);
    Scene scene;
    scene.lights[0].direction_eye = glm::normalize(glm::vec3(-1, 0, -1.5f));  // off to the side: h leans towards x
    const auto brightness = [&](glm::vec3 grain) {
        scene.u.grain_eye = grain;
        return PixelShader<Brushed, Detail::plain>{scene.u, {}}.fragment<float>({{0, 0, 1}, {0, 0, -1}}, {}).x;
    };
    EXPECT_GT(brightness({1, 0, 0}), brightness({0, 1, 0}) + 0.2f);
    expect_lanes_equal_scalar(PixelShader<Brushed, Detail::plain>{scene.u, {}});
    const auto target = draw_scene(PixelShader<Brushed, Detail::plain>{scene.u, {}}, {slanted});
    for_each_drawn(target, [](int, int, glm::vec4 color) { ASSERT_GT(color.x, 0.0f); });
}

}  // namespace
