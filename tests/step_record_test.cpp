// What the stepper page keeps of a draw: the picture's own numbers, and nothing that the pipeline did not compute.
#include <gtest/gtest.h>

#include <raster/scene/shapes.h>
#include <raster/scene/transform.h>
#include <raster/step/recorder.h>
#include <raster/step/step.h>
#include <raster/step/survey.h>

namespace {

using namespace raster;
using namespace raster::step;

constexpr int width = 80, height = 60;

CameraMatrices camera_at(float near_plane = 0.1f) {
    Camera camera;
    camera.position = {2.0f, 1.5f, 2.5f};
    camera.near_plane = near_plane;
    camera.view_angle = 45;
    return *camera_matrices(camera, double(width) / height);
}

/// Everything that is drawn, with all triangles and pixels.
Record record_all(const Model& model, const CameraMatrices& camera, const RenderOptions& options, Target& target) {
    Record record{};
    record.width = width;
    record.height = height;
    record.region = {0, 0, width - 1, height - 1};
    std::map<std::int64_t, std::string> all;
    for (std::size_t t = 0; t < model.triangle_count(); ++t) all.emplace(std::int64_t(t), "all");
    Recorder recorder(record, all, options.world_from_object);
    record.counts = watch(target, model, camera, options, recorder);
    return record;
}

TEST(StepRecord, TheObservedPictureIsTheRenderedOne) {
    const Model model = cube();
    for (const ShadingFrequency frequency :
         {ShadingFrequency::flat, ShadingFrequency::gouraud, ShadingFrequency::phong}) {
        RenderOptions options;
        options.frequency = frequency;
        Target observed = watched_target(width, height, options, {}), rendered(width, height);
        record_all(model, camera_at(), options, observed);
        render(rendered, model, camera_at(), options);
        EXPECT_EQ(observed.color8(), rendered.color8());
        EXPECT_EQ(observed.depth(), rendered.depth());
    }
}

TEST(StepRecord, TheLastFragmentThatPassedIsThePicture) {
    Target target = watched_target(width, height, {}, {});
    const Record record = record_all(cube(), camera_at(), {}, target);
    std::map<std::pair<int, int>, glm::vec4> last;
    for (const FragmentRecord& f : record.fragments)
        if (f.passed) last[{f.x, f.y}] = f.after;
    EXPECT_GT(last.size(), 100u);
    for (const auto& [place, color] : last) EXPECT_EQ(color, target.color(place.first, place.second));
}

TEST(StepRecord, TheLightTakenApartHasTheShadersBits) {
    for (const ShadingFrequency frequency : {ShadingFrequency::flat, ShadingFrequency::phong}) {
        for (const std::string_view name : reflectance_names()) {
            RenderOptions options;
            options.frequency = frequency;
            options.reflectance = *find_reflectance(name);
            Light lamp;
            lamp.kind = LightKind::point;
            lamp.position = {1, 2, 1};
            options.lights.push_back(lamp);
            Target target = watched_target(width, height, options, {});
            const Record record = record_all(cube(), camera_at(), options, target);
            std::size_t lit = 0;
            for (const FragmentRecord& f : record.fragments) {
                if (!f.passed) continue;
                ASSERT_TRUE(f.shading && f.shading->agrees) << name << " at " << f.x << "," << f.y;
                ASSERT_EQ(f.shading->lights.size(), 2u);
                lit += f.shading->lights[0].n_l > 0;
            }
            EXPECT_GT(lit, 100u);
        }
    }
}

TEST(StepRecord, GouraudsCornersHaveTheShadersBitsAndMixToWhatArrives) {
    for (const bool two_sided : {true, false}) {  // one-sided plain surfaces hand on a colour, others light
        for (const Cull cull : {Cull::none, Cull::front}) {
            RenderOptions options;
            options.frequency = ShadingFrequency::gouraud;
            options.two_sided = two_sided;
            options.cull = cull;
            Target target = watched_target(width, height, options, {});
            const Record record = record_all(cube(), camera_at(), options, target);
            const bool plain = record.draws[0].level == Detail::plain;
            EXPECT_EQ(plain, !two_sided);
            int behind = 0;
            std::map<std::int64_t, const TriangleRecord*> triangles;
            for (const TriangleRecord& t : record.triangles) {
                triangles[t.number] = &t;
                for (const VertexRecord& v : t.corners) {
                    ASSERT_TRUE(v.shading && v.shading->agrees);
                    if (plain) continue;
                    const std::size_t seen = t.pieces[0].front_facing ? 0 : 6;
                    EXPECT_EQ(v.shading->sum_diffuse.r, v.varyings[seen]);
                    behind += seen != 0 && v.varyings[0] != v.varyings[6];
                }
            }
            EXPECT_TRUE(plain || behind > 0);
            std::size_t mixed = 0;
            for (const FragmentRecord& f : record.fragments) {
                if (!f.passed) continue;
                EXPECT_EQ(f.terms.has_value(), !plain);
                const TriangleRecord& t = *triangles[f.triangle];
                const PieceRecord& piece = t.pieces[std::size_t(f.piece)];
                const std::size_t side = plain || piece.front_facing ? 0 : 6;
                for (std::size_t c = 0; c < (plain ? 3 : 6); ++c) {
                    float mix = 0;
                    for (std::size_t i = 0; i < 3; ++i)
                        mix += f.weights[i] *
                               t.corners[std::size_t(piece.setup->setup.order[i])].varyings[side + c];
                    EXPECT_NEAR(mix, f.varyings[side + c], 1e-3f);
                }
                ++mixed;
            }
            EXPECT_GT(mixed, 100u);
        }
    }
}

TEST(StepRecord, LightForAScreenIsKeptAsThePictureHasIt) {
    const Display display{true, 0.5f};
    RenderOptions options;
    options.background = light_for(options.background, display);
    Target watched = watched_target(width, height, options, display);
    const Record record = record_all(cube(), camera_at(), options, watched);
    Target light(width, height, ColorFormat::rgba_float);
    render(light, cube(), camera_at(), options);
    const Target picture = displayed(light, display);
    std::map<std::pair<int, int>, glm::vec4> last;
    for (const FragmentRecord& f : record.fragments)
        if (f.passed) last[{f.x, f.y}] = f.after;
    EXPECT_GT(last.size(), 100u);
    for (const auto& [place, color] : last)
        for (int c = 0; c < 3; ++c)
            EXPECT_EQ(to_unorm8(shown_value(color[c], display)),
                      int(picture.color8()[picture.index(place.first, place.second)] >> (8 * c) & 255));
}

TEST(StepRecord, ABugIsInAllThatIsKept) {
    RenderOptions options;
    for (const BugInfo& info : bugs) {
        SCOPED_TRACE(info.name);
        Record record{};
        record.width = width, record.height = height;
        record.region = {0, 0, width - 1, height - 1};
        record.bug = info.bug;
        Recorder recorder(record, {{0, "all"}}, options.world_from_object);
        Target watched = watched_target(width, height, options, {}), wrong(width, height);
        watch(watched, cube(), camera_at(3.2f), options, recorder, info.bug);
        render_bug(info.bug, wrong, cube(), camera_at(3.2f), options);
        EXPECT_EQ(watched.color8(), wrong.color8());
        std::map<std::pair<int, int>, glm::vec4> last;
        for (const FragmentRecord& f : record.fragments) {
            if (!f.passed) continue;
            last[{f.x, f.y}] = f.after;
            ASSERT_TRUE(f.shading && f.shading->agrees);
            EXPECT_TRUE(info.bug != Bug::affine || f.weights == f.affine_weights);
        }
        for (const auto& [place, color] : last) EXPECT_EQ(color, wrong.color(place.first, place.second));
    }
}

TEST(StepRecord, EveryNewCornerOfACutHasItsEdgeAndItsT) {
    Target target = watched_target(width, height, {}, {});
    const Record record = record_all(cube(), camera_at(3.2f), {}, target);
    int cuts = 0;
    for (const TriangleRecord& t : record.triangles) {
        for (const PlaneRecord& plane : t.planes) {
            for (const CornerRecord& corner : plane.after) {
                if (corner.from < 0) {
                    EXPECT_TRUE(std::any_of(plane.before.begin(), plane.before.end(),
                                            [&](const CornerRecord& b) { return b.clip == corner.clip; }));
                    continue;
                }
                ++cuts;
                const CornerRecord &a = plane.before[std::size_t(corner.from)],
                                   &b = plane.before[std::size_t(corner.to)];
                EXPECT_NE(a.distance >= 0, b.distance >= 0);
                EXPECT_GE(corner.t, 0.0f);
                EXPECT_LE(corner.t, 1.0f);
                for (int i = 0; i < 4; ++i) EXPECT_EQ(corner.clip[i], a.clip[i] + corner.t * (b.clip[i] - a.clip[i]));
            }
        }
    }
    EXPECT_GT(cuts, 4);
}

TEST(StepRecord, WeightsAddUpToOneAndThePlanesAgreeWithTheEdges) {
    Target target = watched_target(width, height, {}, {});
    const Record record = record_all(cube(), camera_at(), {}, target);
    for (const FragmentRecord& f : record.fragments) {
        EXPECT_NEAR(f.weights[0] + f.weights[1] + f.weights[2], 1.0f, 1e-4f);
        EXPECT_NEAR(f.affine_weights[0] + f.affine_weights[1] + f.affine_weights[2], 1.0f, 1e-4f);
    }
    for (const TriangleRecord& t : record.triangles) {
        for (const PieceRecord& p : t.pieces) {
            if (!p.setup) continue;
            for (std::size_t k = 0; k < 3; ++k)
                EXPECT_EQ(bool(p.setup->setup.edges[k].inclusive), p.setup->owned_opengl[k]);
        }
    }
}

TEST(StepRecord, CoverageHoldsOneTripleAPixelOfItsRectangle) {
    Target target = watched_target(width, height, {}, {});
    const Record record = record_all(cube(), camera_at(), {}, target);
    for (const TriangleRecord& t : record.triangles) {
        for (const PieceRecord& p : t.pieces) {
            if (!p.setup) continue;
            const CoverageRecord& c = p.setup->coverage;
            EXPECT_EQ(c.edges.size(), std::size_t(c.width) * std::size_t(c.height));
            EXPECT_EQ(std::int64_t(c.edges.size()), p.setup->tested) << "the region is the whole picture";
        }
    }
}

TEST(StepSurvey, TheBusyPixelIsCoveredOftenAndItsTrianglesAreChosenFirst) {
    const Model model = cube();
    Target target = watched_target(width, height, {}, {});
    Survey survey(width, height);
    watch(target, model, camera_at(), {}, survey);
    const glm::ivec2 pixel = survey.busy_pixel();
    const auto chosen = survey.choose(2, {}, pixel, {0, 0, width - 1, height - 1});
    ASSERT_EQ(chosen.size(), 2u) << "no more than asked for";
    for (const auto& [number, why] : chosen) EXPECT_EQ(why, "covers the pixel");
    EXPECT_TRUE(survey.choose(2, 11, pixel, {0, 0, width - 1, height - 1}).contains(11));
}

TEST(StepPage, IsOneFileThatSaysWhatItLeftOut) {
    StepOptions options;
    options.name = "</script>";
    options.max_triangles = 3;
    const Result<std::string> page = step_page(cube(), camera_at(), width, height, {}, options);
    ASSERT_TRUE(page);
    EXPECT_EQ(page->find("{{"), std::string::npos);
    EXPECT_NE(page->find("\\u003c/script>"), std::string::npos) << "a name cannot end the script";
    EXPECT_NE(page->find("Of 12 triangles 3 are followed"), std::string::npos);
    EXPECT_EQ(page->find("http://"), std::string::npos);
    EXPECT_EQ(page->find("https://"), std::string::npos);
}

TEST(StepPage, OfABugOpensAtTheFirstEventThatDiffers) {
    for (const BugInfo& info : bugs) {
        SCOPED_TRACE(info.name);
        StepOptions options;
        options.bug = info.bug;
        const Result<std::string> page = step_page(cube(), camera_at(3.2f), width, height, {}, options);
        ASSERT_TRUE(page);
        const auto first = first_difference(info.bug, width, height, cube(), camera_at(3.2f), {});
        ASSERT_TRUE(first);
        const auto has = [&](const std::string& text) { return page->find(text) != std::string::npos; };
        EXPECT_TRUE(has("\"name\":\"" + std::string(info.name) + "\""));
        EXPECT_TRUE(has("\"first\":{\"event\":" + std::to_string(first->event)));
        EXPECT_TRUE(has("\"differing\":"));
        ASSERT_TRUE(first->place.triangle);
        EXPECT_TRUE(has(",\"triangle\":" + std::to_string(*first->place.triangle + 1) + ",\"stage\":\"\"}"));
    }
    const Result<std::string> right = step_page(cube(), camera_at(), width, height, {}, {});
    ASSERT_TRUE(right);
    EXPECT_EQ(right->find("\"differing\":"), std::string::npos);
}

TEST(StepPage, RefusesWhatIsNotThere) {
    StepOptions options;
    options.pixel = glm::ivec2(width, 0);
    EXPECT_FALSE(step_page(cube(), camera_at(), width, height, {}, options));
    options.pixel.reset();
    options.triangle = 12;
    EXPECT_FALSE(step_page(cube(), camera_at(), width, height, {}, options));
    options.triangle.reset();
    options.stage = "raster";
    EXPECT_FALSE(step_page(cube(), camera_at(), width, height, {}, options));
}

TEST(StepPage, OfAModelWithoutTrianglesIsThere) {
    EXPECT_TRUE(step_page(Model{}, camera_at(), width, height, {}, {}));
}

}  // namespace
