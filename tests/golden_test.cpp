// golden_test.cpp: golden pictures, their reports, and approving, from failing to passing.
#include <raster/testing/golden.h>

#include <raster/image/file.h>
#include <raster/image/png.h>
#include <raster/image/pnm.h>
#include <raster/image/report.h>
#include <raster/image/report_json.h>
#include <raster/testing/approve.h>
#include <raster/testing/matchers.h>

#include <stdlib.h>

#include <filesystem>
#include <fstream>
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest-spi.h>
#include <gtest/gtest.h>

namespace {

namespace fs = std::filesystem;
using raster::AnyImage;
using raster::Gates;
using raster::Image16;
using raster::Image8;
using raster::ImageF;
using raster::Verdict;
using raster::testing::approve;
using raster::testing::check_golden;
using raster::testing::GoldenFolders;
using testing::HasSubstr;
using testing::Not;

class Golden : public testing::Test {
protected:
    void SetUp() override {
        std::string name = (fs::temp_directory_path() / "raster-golden-XXXXXX").string();
        ASSERT_NE(::mkdtemp(name.data()), nullptr);
        root = name;
        folders = {root + "/goldens", root + "/diff-out"};
        fs::create_directory(folders.goldens);
    }
    void TearDown() override { fs::remove_all(root); }

    raster::testing::GoldenResult check(const std::string& name, const AnyImage& image, const Gates& gates = {}) const {
        raster::DiffOptions options;
        options.gates = gates;
        return check_golden(name, image, options, folders);
    }
    std::string golden(const std::string& name) const { return folders.goldens + "/" + name; }
    std::string report(const std::string& name) const { return folders.reports + "/" + name; }

    std::string root;
    GoldenFolders folders;
};

Image8 picture(int value = 90) {
    Image8 image(20, 10, 3, std::uint8_t(value));
    image.pixel(4, 5)[0] = 200;
    return image;
}

TEST_F(Golden, APictureThatIsEqualPassesAndWritesNothing) {
    ASSERT_TRUE(raster::write_png(golden("a.png"), picture()));
    const auto result = check("a", picture());
    EXPECT_TRUE(result.passed);
    EXPECT_EQ(result.message, "");
    EXPECT_FALSE(fs::exists(folders.reports));
}

TEST_F(Golden, AFailureTellsFiguresPathsTheTightestGatesAndTheCommand) {
    ASSERT_TRUE(raster::write_png(golden("a.png"), picture()));
    const auto result = check("a", picture(93));
    EXPECT_FALSE(result.passed);
    for (const std::string& part :
         {std::string("200 of 200 pixels differ"), std::string("max 3 at (0,0)"), std::string("RMS"),
          std::string("PSNR"), std::string("SSIM"), std::string("FLIP"),
          std::string("--max-delta 3, or --max-pixels 200"), golden("a.png"), report("a") + "/a.actual.png",
          report("a") + "/report.html", "raster approve " + report("a")})
        EXPECT_THAT(result.message, HasSubstr(part));
    for (const char* file : {"report.html", "diff.json", "a.actual.png", "a.diff.png", "a.triptych.png"})
        EXPECT_TRUE(fs::exists(report("a") + "/" + file)) << file;
}

TEST_F(Golden, WhatPassesAgainLeavesNothingToApprove) {
    ASSERT_TRUE(raster::write_png(golden("a.png"), picture()));
    ASSERT_FALSE(check("a", picture(93)).passed);
    ASSERT_TRUE(check("a", picture()).passed);
    EXPECT_FALSE(fs::exists(report("a")));
}

TEST_F(Golden, GatesAreHeldAndLooseOnesWarnedOf) {
    ASSERT_TRUE(raster::write_png(golden("a.png"), picture()));
    EXPECT_TRUE(check("a", picture(93), {.max_delta = 3}).passed);
    EXPECT_FALSE(check("a", picture(93), {.max_delta = 2}).passed);
    EXPECT_THAT(check("a", picture(93), {.max_delta = 100}).message, HasSubstr("far looser than needed"));
}

TEST_F(Golden, SixteenBitsAndFloatsAreKeptExactly) {
    Image16 deep(5, 4, 1, 40000);
    ImageF floats(5, 4, 3, 0.1f);
    for (const bool first : {true, false}) {
        EXPECT_EQ(check("deep", deep).passed, !first);
        EXPECT_EQ(check("hdr", floats).passed, !first);
        if (first) { ASSERT_TRUE(approve(folders.reports)); }
    }
    deep.samples[7] += 1;
    floats.samples[7] = std::nextafter(floats.samples[7], 1.0f);
    EXPECT_FALSE(check("deep", deep).passed);
    EXPECT_FALSE(check("hdr", floats).passed);
}

TEST_F(Golden, ANewPictureFailsUntilApproved) {
    const auto result = check("lines/wide", picture());
    EXPECT_FALSE(result.passed);
    EXPECT_THAT(result.message, HasSubstr("there is no golden"));
    const auto approval = approve(folders.reports);
    ASSERT_TRUE(approval) << approval.error().message;
    EXPECT_THAT(approval->approved, testing::ElementsAre(golden("lines/wide.png")));
    EXPECT_TRUE(check("lines/wide", picture()).passed);
}

TEST_F(Golden, NamesMayNotLeadOut) {
    for (const char* name : {"", "../a", "/tmp/a", "a/../../b", "a/"})
        EXPECT_FALSE(check(name, picture()).passed) << name;
    EXPECT_FALSE(fs::exists(root + "/a.png"));
}

TEST_F(Golden, ABrokenGoldenIsNamed) {
    std::ofstream(golden("a.png")) << "no picture";
    EXPECT_THAT(check("a", picture()).message, HasSubstr("unreadable: a.png"));
}

TEST_F(Golden, FloatsWithAlphaAreRefusedSinceAPfmKeepsNone) {
    EXPECT_THAT(check("a", ImageF(2, 2, 4)).message, HasSubstr("keeps no alpha"));
}

// ------------------------------------------------------------------------------------------------ approving

TEST_F(Golden, ApprovingIsRefusedInContinuousIntegration) {
    ASSERT_FALSE(check("a", picture()).passed);
    const auto approval = approve(folders.reports, {.in_ci = true});
    ASSERT_FALSE(approval);
    EXPECT_EQ(approval.error().kind, raster::ErrorKind::usage);
    EXPECT_FALSE(fs::exists(golden("a.png")));
    for (const char* value : {"true", "1", "yes"}) {
        ::setenv("CI", value, 1);
        EXPECT_TRUE(raster::testing::running_in_ci());
    }
    for (const char* value : {"", "0", "false"}) {
        ::setenv("CI", value, 1);
        EXPECT_FALSE(raster::testing::running_in_ci());
    }
    ::unsetenv("CI");
}

TEST_F(Golden, AGoldenThatChangedSinceIsNotOverwritten) {
    ASSERT_TRUE(raster::write_png(golden("a.png"), picture()));
    ASSERT_FALSE(check("a", picture(93)).passed);
    ASSERT_TRUE(raster::write_png(golden("a.png"), picture(50)));
    const auto approval = approve(folders.reports);
    ASSERT_TRUE(approval);
    EXPECT_THAT(approval->refused, testing::ElementsAre(HasSubstr("changed since it was compared")));
    EXPECT_FALSE(check("a", picture(93)).passed);
}

TEST_F(Golden, AnActualPictureThatChangedSinceIsNotApproved) {
    ASSERT_FALSE(check("a", picture()).passed);
    ASSERT_TRUE(raster::write_png(report("a") + "/a.actual.png", picture(1)));
    const auto approval = approve(folders.reports);
    ASSERT_TRUE(approval);
    EXPECT_TRUE(approval->approved.empty());
    EXPECT_EQ(approval->refused.size(), 1u);
}

TEST_F(Golden, ANanIsNeverApproved) {
    ImageF floats(3, 3, 1, 0.5f);
    floats.samples[4] = std::numeric_limits<float>::quiet_NaN();
    const auto result = check("a", floats);
    ASSERT_FALSE(result.passed);
    EXPECT_THAT(result.message, testing::Not(HasSubstr("raster approve")));
    const auto approval = approve(folders.reports);
    ASSERT_TRUE(approval);
    EXPECT_THAT(approval->refused, testing::ElementsAre(HasSubstr("NaN")));
}

TEST_F(Golden, AReportThatNamesFilesOutsideIsNotFollowed) {
    ASSERT_FALSE(check("a", picture()).passed);
    ASSERT_TRUE(raster::write_png(root + "/evil.png", picture()));
    const std::string data = report("a") + "/diff.json";
    std::string text;
    {
        std::ifstream in(data);
        text.assign(std::istreambuf_iterator<char>(in), {});
    }
    text.replace(text.find("\"actual\":\"a.actual.png\""), 23, "\"actual\":\"../../evil.png\"");
    std::ofstream(data) << text;
    const auto approval = approve(folders.reports);
    ASSERT_TRUE(approval);
    EXPECT_TRUE(approval->approved.empty());
    EXPECT_THAT(approval->refused, testing::ElementsAre(HasSubstr("outside")));
}

TEST_F(Golden, ApprovingTwiceChangesNothing) {
    ASSERT_FALSE(check("a", picture()).passed);
    ASSERT_EQ(approve(folders.reports)->approved.size(), 1u);
    const auto again = approve(folders.reports);
    ASSERT_TRUE(again);
    EXPECT_TRUE(again->approved.empty());
    EXPECT_EQ(again->unchanged.size(), 1u);
}

TEST_F(Golden, ListingApprovesNothing) {
    ASSERT_FALSE(check("a", picture()).passed);
    EXPECT_EQ(approve(folders.reports, {.only_list = true})->approved.size(), 1u);
    EXPECT_FALSE(fs::exists(golden("a.png")));
}

TEST_F(Golden, WithoutAReportThereIsAnError) {
    EXPECT_FALSE(approve(root));
    EXPECT_FALSE(approve(root + "/nowhere"));
    fs::create_directory(root + "/x");
    std::ofstream(root + "/x/diff.json") << "{\"schema\":\"other\"}";
    EXPECT_FALSE(approve(root + "/x"));
}

// --------------------------------------------------------------------------------------------- the matcher

TEST_F(Golden, TheMatcherMatchesAndExplains) {
    ASSERT_TRUE(raster::write_png(golden("a.png"), picture()));
    ::setenv("RASTER_GOLDEN_DIR", folders.goldens.c_str(), 1);
    ::setenv("RASTER_DIFF_DIR", folders.reports.c_str(), 1);
    EXPECT_THAT(picture(), raster::testing::MatchesGolden("a"));
    EXPECT_THAT(picture(93), Not(raster::testing::MatchesGolden("a")));
    EXPECT_THAT(picture(93), raster::testing::MatchesGolden("a", {.max_delta = 3}));
    testing::StringMatchResultListener listener;
    EXPECT_FALSE(testing::ExplainMatchResult(raster::testing::MatchesGolden("a"), AnyImage(picture(95)), &listener));
    EXPECT_THAT(listener.str(), HasSubstr("--max-delta 5"));
    EXPECT_EQ(testing::PrintToString(picture()), "a picture of 20x10 pixels, 3 channels of 8 bits");
    ::unsetenv("RASTER_GOLDEN_DIR");
    ::unsetenv("RASTER_DIFF_DIR");
}

}  // namespace
