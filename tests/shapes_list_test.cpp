// Shapes by name, curves through points, and how the icosphere is cut.
#include <raster/scene/shape_list.h>

#include <cmath>

#include <gtest/gtest.h>

namespace raster {
namespace {

using Values = std::vector<std::pair<std::string, double>>;

TEST(ShapeList, EveryShapeIsMadeAtItsDefaultsAndAtTheEndsOfItsRanges) {
    for (const Shape& shape : shape_list()) {
        SCOPED_TRACE(shape.name);
        const Result<Model> plain = make_shape(shape.name);
        ASSERT_TRUE(plain);
        EXPECT_GT(plain->triangle_count(), 0u);
        for (const ShapeParameter& p : shape.parameters) {
            EXPECT_GE(p.default_value, p.low);
            EXPECT_LE(p.default_value, p.high);
            EXPECT_TRUE(make_shape(shape.name, Values{{std::string(p.name), p.low}})) << p.name;
            EXPECT_FALSE(make_shape(shape.name, Values{{std::string(p.name), p.low - 1}})) << p.name;
            EXPECT_FALSE(make_shape(shape.name, Values{{std::string(p.name), p.high * 2}})) << p.name;
            EXPECT_FALSE(make_shape(shape.name, Values{{std::string(p.name), std::nan("")}})) << p.name;
            if (p.whole) {
                EXPECT_FALSE(make_shape(shape.name, Values{{std::string(p.name), p.low + 0.5}})) << p.name;
            }
        }
    }
}

TEST(ShapeList, ParametersReachTheShape) {
    EXPECT_EQ(make_shape("sphere", Values{{"rings", 2}, {"segments", 5}})->triangle_count(), 10u);
    EXPECT_EQ(make_shape("icosphere", Values{{"divisions", 3}})->triangle_count(), 180u);
    const Box size = bounding_box(*make_shape("box", Values{{"height", 4}}));
    EXPECT_EQ(size.max, glm::vec3(1, 2, 1));
    EXPECT_EQ(size.min, glm::vec3(-1, -2, -1));
}

TEST(ShapeList, MistakesAreToldWithWhatThereIs) {
    EXPECT_NE(make_shape("sfere").error().message.find("sphere"), std::string::npos);
    EXPECT_NE(make_shape("sphere", Values{{"rungs", 3}}).error().message.find("rings"), std::string::npos);
    EXPECT_NE(make_shape("sphere", Values{{"rings", 1}}).error().message.find("from 2 to 1024"), std::string::npos);
    EXPECT_EQ(make_shape("sfere").error().kind, ErrorKind::usage);
}

TEST(Icosphere, VerticesLieOnTheSphereAndTrianglesAreEven) {
    const Model model = icosphere(16);
    EXPECT_EQ(model.triangle_count(), 20u * 16 * 16);
    for (const auto& v : model.vertices) {
        EXPECT_NEAR(glm::length(glm::dvec3(v.position)), 1, 1e-7);
        EXPECT_EQ(v.position, v.normal);
    }
    double smallest = 1, largest = 0;
    for (std::size_t i = 0; i < model.indices.size(); i += 3) {
        const auto at = [&](std::size_t k) { return glm::dvec3(model.vertices[model.indices[i + k]].position); };
        const double area = glm::length(glm::cross(at(1) - at(0), at(2) - at(0))) / 2;
        smallest = std::min(smallest, area);
        largest = std::max(largest, area);
    }
    EXPECT_LT(largest / smallest, 2.5);
}

TEST(CurveThrough, GoesThroughItsPointsAndKeepsCornersSharp) {
    const std::vector<glm::dvec2> points = {{1, 0}, {2, 1}, {2, 1}, {1, 2}, {1.5, 3}};
    const std::vector<glm::dvec2> curve = curve_through(points, 4);
    ASSERT_EQ(curve.size(), 4u + 1 + 4 + 4 + 1);
    EXPECT_EQ(curve[0], points[0]);
    EXPECT_EQ(curve[4], points[1]);
    EXPECT_EQ(curve[5], points[2]);
    EXPECT_EQ(curve[9], points[3]);
    EXPECT_EQ(curve.back(), points.back());
    // Between a corner's two neighbours nothing pulls: the first piece is straight.
    EXPECT_NEAR(curve[2].x, 1.5, 1e-12);
    EXPECT_NEAR(curve[2].y, 0.5, 1e-12);
    EXPECT_EQ(curve_through(points, 1), points);
    EXPECT_TRUE(curve_through({}, 3).empty());
}

TEST(CurveThrough, HasCatmullAndRomsSlope) {
    // On a parabola at equal steps the spline is the parabola.
    const std::vector<glm::dvec2> points = {{0, 0}, {1, 1}, {2, 4}, {3, 9}};
    const std::vector<glm::dvec2> curve = curve_through(points, 8);
    for (int k = 0; k <= 8; ++k) {
        const double x = 1 + k / 8.0;
        EXPECT_NEAR(curve[std::size_t(8 + k)].x, x, 1e-12);
        EXPECT_NEAR(curve[std::size_t(8 + k)].y, x * x, 1e-12);
    }
}

}  // namespace
}  // namespace raster
