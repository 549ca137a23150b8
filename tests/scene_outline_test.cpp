// Wireframes and clouds of points of models.
#include <gtest/gtest.h>

#include <raster/scene/draw_plan.h>
#include <raster/scene/outline.h>
#include <raster/scene/shapes.h>

namespace {

using namespace raster;

using Numbers = std::vector<std::uint32_t>;

const Numbers square = {0, 1, 2, 0, 2, 3};

TEST(Outline, EdgesOfASquareOfTwoTrianglesAreFive) {
    const Outline edges = edges_of(square);
    EXPECT_EQ(edges.indices, (Numbers{0, 1, 1, 2, 2, 0, 2, 3, 3, 0}));
    EXPECT_EQ(edges.triangles, (Numbers{0, 0, 0, 1, 1}));
}

TEST(Outline, CornersOfASquareOfTwoTrianglesAreFour) {
    const Outline corners = corners_of(square);
    EXPECT_EQ(corners.indices, (Numbers{0, 1, 2, 3}));
    EXPECT_EQ(corners.triangles, (Numbers{0, 0, 0, 1}));
}

TEST(Outline, ATriangleThatIsNotKeptLeavesWhatOthersShare) {
    const auto second = [](std::uint32_t triangle) { return triangle == 1; };
    EXPECT_EQ(edges_of(square, second).indices, (Numbers{0, 2, 2, 3, 3, 0}));
    EXPECT_EQ(edges_of(square, second).triangles, (Numbers{1, 1, 1}));
    EXPECT_EQ(corners_of(square, second).indices, (Numbers{0, 2, 3}));
}

TEST(Outline, OfNothingIsNothing) {
    EXPECT_TRUE(edges_of({}).indices.empty());
    EXPECT_TRUE(corners_of({}).indices.empty());
}

TEST(Outline, AnOctahedronHasTwelveEdgesAndSixCorners) {
    const Numbers octahedron = {0, 2, 4, 2, 1, 4, 1, 3, 4, 3, 0, 4, 2, 0, 5, 1, 2, 5, 3, 1, 5, 0, 3, 5};
    EXPECT_EQ(edges_of(octahedron).triangles.size(), 12u);
    EXPECT_EQ(corners_of(octahedron).indices.size(), 6u);
}

/// One triangle in the plane z = 0 before the camera at (0, 0, 5); counter-clockwise seen from there.
Model triangle() {
    Model model;
    for (const glm::vec3& p : {glm::vec3(-1, -1, 0), glm::vec3(1, -1, 0), glm::vec3(0, 1, 0)})
        model.vertices.push_back({p, {0, 0, 1}, {0, 0}, glm::vec3(1)});
    model.indices = {0, 1, 2};
    return model;
}

struct Drawn {
    DrawCounts counts;
    std::size_t pixels;
    std::vector<std::uint32_t> colors;
};

Drawn draw_style(const Model& model, RenderOptions options, Style style) {
    options.style = style;
    options.background = glm::vec4(0);
    Target target(100, 100);
    const DrawCounts counts = render(target, model, *camera_matrices(Camera{}, 1), options);
    std::size_t pixels = 0;
    for (const std::uint32_t color : target.color8()) pixels += color != 0;
    return {counts, pixels, target.color8()};
}

TEST(Style, AWireframeIsTheBorderOfTheSurfaceAndPointsAreSquares) {
    for (const auto frequency : {ShadingFrequency::flat, ShadingFrequency::gouraud, ShadingFrequency::phong}) {
        RenderOptions options;
        options.frequency = frequency;
        const Drawn surface = draw_style(triangle(), options, Style::surface);
        const Drawn lines = draw_style(triangle(), options, Style::wireframe);
        options.point_size = 4;
        const Drawn points = draw_style(triangle(), options, Style::points);
        EXPECT_EQ(lines.counts.submitted, 3);
        EXPECT_EQ(lines.counts.drawn, 3);
        EXPECT_EQ(points.counts.drawn, 3);
        EXPECT_EQ(points.pixels, 3u * 16);
        // The camera shows 2 tan(15 degrees) 5 = 2.68 units on 100 pixels, so that the sides are 75, 83 and 83 long.
        EXPECT_NEAR(double(lines.pixels), 75 + 75 + 75, 4) << "a line has a pixel for each step of its longer axis";
        EXPECT_GT(surface.pixels, 2500u);
    }
}

TEST(Style, FlatLinesHaveTheColorOfTheirTriangle) {
    RenderOptions options;
    options.frequency = ShadingFrequency::flat;
    const Drawn surface = draw_style(triangle(), options, Style::surface);
    std::uint32_t color = 0;
    for (const std::uint32_t c : surface.colors)
        if (c) color = c;
    for (const Style style : {Style::wireframe, Style::points})
        for (const std::uint32_t c : draw_style(triangle(), options, style).colors)
            if (c) { ASSERT_EQ(c, color); }
}

TEST(Style, WhatIsCulledHasNoOutline) {
    RenderOptions options;
    options.cull = Cull::back;
    Model turned = triangle();
    std::swap(turned.indices[0], turned.indices[1]);
    for (const Style style : {Style::surface, Style::wireframe, Style::points}) {
        EXPECT_GT(draw_style(triangle(), options, style).pixels, 0u);
        EXPECT_EQ(draw_style(turned, options, style).pixels, 0u);
    }
    options.cull = Cull::front;
    EXPECT_EQ(draw_style(triangle(), options, Style::wireframe).pixels, 0u);
    EXPECT_GT(draw_style(turned, options, Style::wireframe).pixels, 0u);
    options.cull = Cull::both;
    EXPECT_EQ(draw_style(turned, options, Style::wireframe).pixels, 0u);
}

TEST(Style, EdgesOfTransparentPartsAreBlendedOnce) {
    Model model = triangle();
    model.vertices.push_back({{2, 1, 0}, {0, 0, 1}, {0, 0}, glm::vec3(1)});
    model.indices = {0, 1, 2, 1, 3, 2};
    Material glass = default_material();
    glass.alpha = 0.5f;
    model.materials = {glass};
    model.parts = {{"", 0, 0, 6}};
    const Drawn lines = draw_style(model, {}, Style::wireframe);
    EXPECT_EQ(lines.counts.submitted, 5);
}

TEST(Style, TheDrawsOfAPlanNameTheTriangleOfEachPrimitive) {
    const Model model = icosphere(1);
    RenderOptions options;
    options.frequency = ShadingFrequency::flat;
    options.style = Style::wireframe;
    DrawPlan(model, options, false).for_each(*camera_matrices(Camera{}, 1), [&](const PlannedDraw& draw) {
        ASSERT_EQ(draw.state.topology, Topology::lines);
        const std::size_t lines = draw.mesh.indices.size() / 2;
        ASSERT_EQ(draw.triangles.size(), 3 * lines);
        ASSERT_EQ(draw.faces.size(), lines);
        ASSERT_EQ(draw.uniforms.triangle_numbers.size(), lines);
        for (std::size_t i = 0; i < lines; ++i) {
            const auto number = std::size_t(draw.uniforms.triangle_numbers[i]);
            for (std::size_t c = 0; c < 3; ++c)
                EXPECT_EQ(draw.triangles[3 * i + c], model.indices[3 * number + c]);
        }
    });
}

}  // namespace
