// pictures_test.cpp: what models look like, exactly.
#include <gtest/gtest.h>

#include <raster/scene/render.h>
#include <raster/scene/shapes.h>
#include <raster/testing/matchers.h>

namespace {

using namespace raster;
using raster::testing::MatchesGolden;

void draw_model(Target& target, const Model& model, const RenderOptions& options = {}) {
    const double aspect = double(target.width()) / target.height();
    render(target, model, *camera_matrices(auto_frame(model, aspect), aspect), options);
}

Image8 picture(const Model& model, const RenderOptions& options = {}) {
    Target target(160, 120);
    draw_model(target, model, options);
    return target.color_image();
}

TEST(Pictures, TeapotWithPhongShading) {
    EXPECT_THAT(picture(teapot()), MatchesGolden("teapot"));
}

TEST(Pictures, TorusAsAWireframe) {
    RenderOptions options;
    options.style = Style::wireframe;
    options.cull = Cull::back;
    EXPECT_THAT(picture(torus(), options), MatchesGolden("wireframe"));
}

TEST(Pictures, SphereAsPoints) {
    RenderOptions options;
    options.style = Style::points;
    EXPECT_THAT(picture(sphere(), options), MatchesGolden("points"));
}

TEST(Pictures, BowlWithFlatShadingInFloats) {
    RenderOptions options;
    options.frequency = ShadingFrequency::flat;
    Target target(40, 30, ColorFormat::rgba_float);
    draw_model(target, bowl(), options);
    ImageF image(40, 30, 3);
    for (std::size_t i = 0; i < target.color_float().size(); ++i)
        for (std::size_t c = 0; c < 3; ++c) image.samples[3 * i + c] = target.color_float()[i][int(c)];
    EXPECT_THAT(image, MatchesGolden("bowl"));
}

}  // namespace
