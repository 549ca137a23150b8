// Each bug is caught: it shows where it should, in the way it should, and parts from the right run at its own stage.
#include <gtest/gtest.h>
#include <raster/bugs/render_bug.h>
#include <raster/bugs/variant.h>
#include <raster/trace/record.h>

#include "trace_scenes.h"

namespace {

using namespace raster;
using namespace raster::testing;

struct Counts {
    int differing = 0, only_right = 0, only_wrong = 0;  ///< pixels; drawn in the right or in the wrong picture alone
};

Target wrong_picture(const TraceScene& scene, Bug bug) {
    Target target = scene.target();
    render_bug(bug, target, scene.model, scene.camera, scene.options);
    return target;
}

Counts compare(const TraceScene& scene, Bug bug) {
    Target right = scene.picture(), wrong = wrong_picture(scene, bug);
    Target empty = scene.target();
    empty.clear(scene.options.background);
    const std::uint32_t background = empty.color8()[0];
    Counts counts;
    for (std::size_t i = 0; i < right.color8().size(); ++i) {
        const std::uint32_t a = right.color8()[i], b = wrong.color8()[i];
        counts.differing += a != b;
        counts.only_right += a != background && b == background;
        counts.only_wrong += a == background && b != background;
    }
    return counts;
}

std::optional<FirstDifference> first(const TraceScene& scene, Bug bug) {
    return first_difference(bug, scene.width, scene.height, scene.model, scene.camera, scene.options);
}

bool starts_with_stage(const std::string& line, const std::string& stage) {
    return line.starts_with("{\"stage\":\"" + stage + "\"");
}

TraceScene named(const std::string& name) {
    for (const TraceScene& scene : trace_scenes())
        if (scene.name == name) return scene;
    ADD_FAILURE() << "no scene " << name;
    return {};
}

template <class Variant>
concept Meddles = requires(Variant& v, std::int32_t& outcode, TriangleSetup& setup) {
    v.change_outcode(outcode);
    v.change_setup(setup);
};
static_assert(Meddles<const BugVariant> && !Meddles<const detail::NoVariant>, "the right pipeline has no hooks");

TEST(Bugs, EachHasANameAndIsFoundByIt) {
    for (std::size_t i = 0; i < bugs.size(); ++i) {
        EXPECT_EQ(bugs[i].bug, Bug(i));
        EXPECT_EQ(find_bug(bugs[i].name), Bug(i));
        EXPECT_FALSE(bugs[i].mistake.empty() || bugs[i].symptom.empty());
    }
    EXPECT_FALSE(find_bug("none"));
}

TEST(Bugs, PartFromTheRightRunAtTheirOwnStage) {
    const struct {
        Bug bug;
        const char* scene;
        const char* stage;
        const char* wrong;  ///< words of the wrong event
    } cases[] = {
        {Bug::no_top_left, "ties", "setup", "\"inclusive\":true"},
        {Bug::strict_edges, "ties", "setup", "\"inclusive\":false"},
        {Bug::affine, "z-buffer", "setup", "\"oow\":[1,0,0]"},
        {Bug::no_near_clip, "clipped by near, far and sides", "clip", "\"outcodes\":[0,0,0]"},
        {Bug::z_flipped, "z-buffer", "project", "\"window\":"},
        {Bug::no_depth_test, "z-buffer", "depth", "\"passed\":true"},
        {Bug::wrong_cull, "flat, back faces culled", "cull", "\"verdict\":"},
        {Bug::no_renormalise, "z-buffer", "fragment", "\"outputs\":"},
        {Bug::pixel_corner, "z-buffer", "project", "\"window\":"},
        {Bug::whole_pixels, "z-buffer", "project", "\"subpixel\":"},
        {Bug::y_flipped, "z-buffer", "project", "\"window\":"},
    };
    EXPECT_EQ(std::size(cases), bugs.size());
    for (const auto& c : cases) {
        SCOPED_TRACE(info_of(c.bug).name);
        const TraceScene scene = named(c.scene);
        EXPECT_GT(compare(scene, c.bug).differing, 0);
        const auto difference = first(scene, c.bug);
        ASSERT_TRUE(difference);
        // What is cut in the right run tells of its planes first.
        EXPECT_TRUE(starts_with_stage(difference->right, c.stage) || starts_with_stage(difference->right, "clip_plane"))
            << difference->right;
        EXPECT_TRUE(starts_with_stage(difference->wrong, c.stage)) << difference->wrong;
        EXPECT_NE(difference->wrong.find(c.wrong), std::string::npos) << difference->wrong;
        EXPECT_NE(difference->right, difference->wrong);
        EXPECT_GT(difference->event, 0);
    }
}

TEST(Bugs, TheFirstDifferenceIsTheFirst) {
    // Counts both runs' events by hand, on the scene with ties where edges differ in a bit alone.
    const TraceScene scene = named("ties");
    struct Setups {
        int before = 0;
        bool found = false;
        std::int64_t events = 0;
        void count() {
            if (!found) ++events;
        }
        void on(const VertexEvent&) { count(); }
        void on(const AssembleEvent&) { count(); }
        void on(const ClipEvent&) { count(); }
        void on(const ClipPlaneEvent&) { count(); }
        void on(const ProjectEvent&) { count(); }
        void on(const CullEvent&) { count(); }
        void on(const SetupEvent& e) {
            for (const auto& edge : e.setup.edges) found = found || !edge.inclusive;
            count();
        }
        void on(const CoverageEvent&) { count(); }
        void on(const DepthEvent&) { count(); }
        void on(const InterpolateEvent&) { count(); }
        void on(const FragmentEvent&) { count(); }
        void on(const BlendEvent&) { count(); }
    } right;
    Target target = scene.target();
    render_observed(target, scene.model, scene.camera, scene.options, right);
    EXPECT_EQ(first(scene, Bug::no_top_left)->event, right.events) << "the first setup with an edge that owns nothing";
}

TEST(Bugs, ABugThatMakesNoDifferenceHasNone) {
    TraceScene scene = named("z-buffer");
    scene.options.frequency = ShadingFrequency::flat;
    EXPECT_FALSE(first(scene, Bug::no_renormalise));
    EXPECT_FALSE(first(scene, Bug::affine) && compare(scene, Bug::affine).differing > 0);
    scene.model = {};
    for (const BugInfo& info : bugs) EXPECT_FALSE(first(scene, info.bug)) << info.name;
}

TEST(Bugs, StrictEdgesLeaveHolesAndNoTopLeftDrawsTwice) {
    const TraceScene ties = named("ties");
    EXPECT_GT(compare(ties, Bug::strict_edges).only_right, 0);
    EXPECT_EQ(compare(ties, Bug::strict_edges).only_wrong, 0);
    EXPECT_GT(compare(ties, Bug::no_top_left).only_wrong, 0);
    EXPECT_EQ(compare(ties, Bug::no_top_left).only_right, 0);
    // Twice: a see-through sheet is darker along its diagonal, which runs through pixel centres.
    TraceScene sheet = ties;
    sheet.model = {};
    sheet.model.materials.resize(1);
    sheet.model.materials[0].alpha = 0.5f;
    add_sheet(sheet.model, {-5.5f, -5.5f}, {4.5f, 4.5f}, 0, 0);
    Target right = sheet.picture(), wrong = wrong_picture(sheet, Bug::no_top_left);
    int doubled = 0;
    for (int i = 4; i < 10; ++i) {
        EXPECT_EQ(right.color(i, 15 - i), right.color(i + 1, 15 - i)) << "one colour all over";
        doubled += wrong.color(i, 15 - i) != wrong.color(i + 1, 15 - i);
    }
    EXPECT_EQ(doubled, 6);
}

TEST(Bugs, PixelCornerShiftsThePictureAndYFlippedTurnsItOver) {
    TraceScene scene = named("ties");
    scene.model = {};
    add_sheet(scene.model, {-5.25f, -4.25f}, {1.75f, 3.75f}, 0, -1);
    Target right = scene.picture(), corner = wrong_picture(scene, Bug::pixel_corner);
    Target flipped = wrong_picture(scene, Bug::y_flipped);
    int moved = 0;
    for (int y = 0; y < scene.height; ++y)
        for (int x = 0; x < scene.width; ++x) {
            EXPECT_EQ(flipped.color(x, y) == flipped.color(0, 0), right.color(x, 15 - y) == right.color(0, 0));
            moved += corner.color(x, y) != right.color(x, y);
        }
    EXPECT_GT(moved, 0);
}

TEST(Bugs, NoNearClipSurvivesAnyPlaceOfTheEye) {
    TraceScene scene = named("z-buffer");
    int differing = 0;
    for (const glm::vec3 eye : {glm::vec3(0, 0, 0), {1, 0, 0}, {0.3f, 0.1f, 0.7f}, {0, 1e-6f, 0}}) {
        Camera camera;
        camera.position = eye;
        camera.focal_point = eye + glm::vec3(0, 0, -1);
        camera.near_plane = 0.5f;
        scene.camera = trace_camera(1.2, camera);
        differing += compare(scene, Bug::no_near_clip).differing;
    }
    EXPECT_GT(differing, 100);
}

}  // namespace
