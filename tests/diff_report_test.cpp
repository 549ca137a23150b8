// diff_report_test.cpp: files and folders compared; what is written, and that nothing is when all pass.
#include <raster/image/report.h>

#include <raster/image/diff_picture.h>
#include <raster/image/diff_words.h>
#include <raster/image/file.h>
#include <raster/image/png.h>
#include <raster/image/pnm.h>
#include <raster/image/report_json.h>

#include <stdlib.h>

#include <filesystem>
#include <fstream>
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "random.h"

namespace {

namespace fs = std::filesystem;
using raster::Comparison;
using raster::DiffOptions;
using raster::DiffReport;
using raster::Image8;
using raster::ImageF;
using raster::Verdict;
using testing::HasSubstr;
using testing::Not;

class Report : public testing::Test {
protected:
    void SetUp() override {
        std::string name = (fs::temp_directory_path() / "raster-report-XXXXXX").string();
        ASSERT_NE(::mkdtemp(name.data()), nullptr);
        root = name;
        for (const char* folder : {"/a", "/b", "/a/sub", "/b/sub"}) fs::create_directory(root + folder);
    }
    void TearDown() override { fs::remove_all(root); }

    std::string in(const std::string& name) const { return root + "/" + name; }
    void write(const std::string& name, const Image8& image) const { ASSERT_TRUE(raster::write_png(in(name), image)); }
    Comparison compare(const std::string& a, const std::string& b, const DiffOptions& options = {}) const {
        auto pair = raster::diff_files(a.empty() ? "" : in(a), b.empty() ? "" : in(b), options);
        EXPECT_TRUE(pair) << pair.error().message;
        return std::move(*pair);
    }
    std::string content(const std::string& name) const {
        std::ifstream file(in(name), std::ios::binary);
        return {std::istreambuf_iterator<char>(file), {}};
    }

    std::string root;
};

Image8 picture(int value = 90) {
    Image8 image(20, 10, 3, std::uint8_t(value));
    image.pixel(4, 5)[0] = 200;
    return image;
}

TEST_F(Report, EqualFilesAreSameAndBrokenOnesAreNot) {
    write("a/x.png", picture());
    fs::copy_file(in("a/x.png"), in("b/x.png"));
    EXPECT_EQ(compare("a/x.png", "b/x.png").diff.verdict, Verdict::same);
    for (const char* side : {"a/y.png", "b/y.png"}) std::ofstream(in(side)) << "\x89PNG\r\n\x1a\n and no more";
    EXPECT_EQ(compare("a/y.png", "b/y.png").diff.verdict, Verdict::unreadable);
    EXPECT_EQ(compare("a/x.png", "b/none.png").diff.verdict, Verdict::unreadable);
    EXPECT_EQ(compare("a/x.png", "").diff.verdict, Verdict::missing);
    EXPECT_EQ(compare("", "b/x.png").diff.verdict, Verdict::added);
}

TEST_F(Report, EqualFilesWithNanFail) {
    ImageF floats(3, 3, 1, std::numeric_limits<float>::quiet_NaN());
    const auto bytes = raster::encode_pfm(floats);
    ASSERT_TRUE(bytes);
    ASSERT_TRUE(raster::write_file(in("a/n.pfm"), *bytes));
    EXPECT_EQ(compare("a/n.pfm", "a/n.pfm").diff.verdict, Verdict::not_a_number);
}

TEST_F(Report, FoldersAreMatchedByName) {
    write("a/one.png", picture());
    write("b/one.png", picture());
    write("a/sub/gone.png", picture());
    write("b/sub/new.PNG", picture());
    std::ofstream(in("a/notes.txt")) << "no picture";
    std::ofstream(in("b/.hidden.png")) << "no picture";
    const auto pairs = raster::match_folders(in("a"), in("b"));
    ASSERT_TRUE(pairs);
    ASSERT_EQ(pairs->size(), 3u);
    EXPECT_EQ((*pairs)[0].name, "one.png");
    EXPECT_EQ((*pairs)[1].name, "sub/gone.png");
    EXPECT_EQ((*pairs)[1].actual_path, "");
    EXPECT_EQ((*pairs)[2].name, "sub/new.PNG");
    EXPECT_EQ((*pairs)[2].expected_path, "");
    EXPECT_EQ((*pairs)[2].golden, in("a/sub/new.PNG"));
    EXPECT_FALSE(raster::match_folders(in("a"), in("nowhere")));
}

TEST_F(Report, NothingIsWrittenWhenAllPass) {
    write("a/x.png", picture());
    write("b/x.png", picture(92));
    DiffOptions options;
    options.gates.max_delta = 2;
    DiffReport report(in("out"));
    ASSERT_TRUE(report.add(compare("a/x.png", "a/x.png"), {}));
    ASSERT_TRUE(report.add(compare("a/x.png", "b/x.png", options), options.gates));
    ASSERT_TRUE(report.finish());
    EXPECT_EQ(report.exit_code(), 0);
    EXPECT_FALSE(fs::exists(in("out")));
}

TEST_F(Report, AFailureIsWrittenWhole) {
    write("a/x.png", picture());
    write("b/x.png", picture(95));
    DiffReport report(in("out"));
    ASSERT_TRUE(report.add(compare("a/x.png", "b/x.png"), {}));
    ASSERT_TRUE(report.finish());
    EXPECT_EQ(report.exit_code(), 1);
    EXPECT_EQ(content("out/x.actual.png"), content("b/x.png"));
    for (const char* file : {"out/x.diff.png", "out/x.triptych.png"})
        EXPECT_TRUE(raster::load_image8(in(file))) << file;
    const auto data = raster::parse_json(content("out/diff.json"));
    ASSERT_TRUE(data);
    const auto& pair = data->members.at("pairs").items.at(0);
    EXPECT_EQ(pair.member_text("verdict"), "different");
    EXPECT_EQ(pair.member_text("golden"), in("a/x.png"));
    EXPECT_EQ(pair.members.at("figures").member_text("max"), "5");
    EXPECT_EQ(pair.members.at("figures").member_text("differing"), "200");
}

TEST_F(Report, ThePageAsksForNothingAndHoldsThePicturesAsTheyAre) {
    write("a/x.png", picture());
    write("b/x.png", picture(95));
    DiffReport report(in("out"));
    ASSERT_TRUE(report.add(compare("a/x.png", "b/x.png"), {}));
    ASSERT_TRUE(report.finish());
    const std::string page = content("out/report.html");
    for (const char* word : {"http:", "https:", " src=", "@import", "<link", "fetch(", "XMLHttpRequest"})
        EXPECT_THAT(page, Not(HasSubstr(word)));
    EXPECT_THAT(page, HasSubstr("default-src 'none'"));
    // The actual picture's bytes, read back from the page.
    const std::string start = "\"actual\":\"data:image/png;base64,";
    const std::size_t at = page.find(start);
    ASSERT_NE(at, std::string::npos);
    const std::string alphabet = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string bytes;
    unsigned bits = 0;
    int count = 0;
    for (std::size_t i = at + start.size(); page[i] != '"' && page[i] != '='; ++i) {
        bits = bits << 6 | unsigned(alphabet.find(page[i]));
        if ((count += 6) >= 8) bytes += char(bits >> (count -= 8) & 255);
    }
    EXPECT_EQ(bytes, content("b/x.png"));
}

TEST_F(Report, ThePageHasAllComparisonsInOrderAlsoThoseThatPass) {
    write("a/x.png", picture());
    write("b/x.png", picture(95));
    DiffReport report(in("out"));
    for (const auto& [actual, name] : {std::pair("a/x.png", "first"), {"b/x.png", "second"}, {"a/x.png", "third"},
                                       {"b/x.png", "fourth"}}) {
        Comparison pair = compare("a/x.png", actual);
        pair.name = name;
        ASSERT_TRUE(report.add(std::move(pair), {}));
        EXPECT_FALSE(fs::exists(in("out/report.html")));
    }
    ASSERT_TRUE(report.finish());
    const std::string page = content("out/report.html");
    const std::string mark = "id=\"data\">";
    const std::size_t start = page.find(mark) + mark.size();
    const auto data = raster::parse_json(page.substr(start, page.find("</script>", start) - start));
    ASSERT_TRUE(data);
    const auto& pairs = data->members.at("pairs").items;
    ASSERT_EQ(pairs.size(), 4u);
    const char* const names[] = {"first", "second", "third", "fourth"};
    for (std::size_t i = 0; i < 4; ++i) {
        EXPECT_EQ(pairs[i].members.at("facts").member_text("name"), names[i]);
        for (const char* shown : {"expected", "actual", "difference", "flip"})
            EXPECT_EQ(pairs[i].member_text(shown).starts_with("data:image/png;base64,"), i % 2 == 1) << shown << i;
    }
    ASSERT_TRUE(report.finish());
    EXPECT_EQ(content("out/report.html"), page);
}

TEST_F(Report, ANameCannotBecomeMarkup) {
    const std::string name = "</script><script>alert(1)<.png";
    const std::string escaped = raster::json_string(name);
    EXPECT_THAT(escaped, Not(HasSubstr("<")));
    EXPECT_EQ(raster::parse_json(escaped)->text, name);
}

TEST_F(Report, WhatPassesAgainCanNoLongerBeApprovedWhatStillFailsCan) {
    write("a/x.png", picture());
    write("a/y.png", picture());
    write("b/x.png", picture(95));
    write("b/y.png", picture(95));
    {
        DiffReport report(in("out"));
        ASSERT_TRUE(report.add(compare("a/x.png", "b/x.png"), {}));
        ASSERT_TRUE(report.add(compare("a/y.png", "b/y.png"), {}));
        ASSERT_TRUE(report.finish());
    }
    DiffReport one(in("out"));
    ASSERT_TRUE(one.add(compare("a/x.png", "a/x.png"), {}));
    ASSERT_TRUE(one.finish());
    EXPECT_FALSE(fs::exists(in("out/x.actual.png")));
    EXPECT_TRUE(fs::exists(in("out/diff.json"))) << "y still fails";
    DiffReport both(in("out"));
    ASSERT_TRUE(both.add(compare("a/x.png", "a/x.png"), {}));
    ASSERT_TRUE(both.add(compare("a/y.png", "a/y.png"), {}));
    ASSERT_TRUE(both.finish());
    EXPECT_FALSE(fs::exists(in("out")));
}

TEST_F(Report, PicturesOfAnEarlierFailureDoNotStayBesideAnotherFailure) {
    write("a/x.png", picture());
    write("b/x.png", picture(95));
    DiffReport first(in("out"));
    ASSERT_TRUE(first.add(compare("a/x.png", "b/x.png"), {}));
    EXPECT_TRUE(fs::exists(in("out/x.diff.png")));
    write("b/x.png", Image8(3, 3, 3));
    DiffReport second(in("out"));
    ASSERT_TRUE(second.add(compare("a/x.png", "b/x.png"), {}));
    EXPECT_FALSE(fs::exists(in("out/x.diff.png"))) << "sizes differ: there is no such picture";
    EXPECT_TRUE(fs::exists(in("out/x.triptych.png")));
}

TEST_F(Report, TroubleIsAnExitCodeOfItsOwnAndAnErrorForJUnit) {
    write("a/x.png", picture());
    std::ofstream(in("b/x.png")) << "junk & <more>";
    DiffReport report(in("out"));
    ASSERT_TRUE(report.add(compare("a/x.png", "b/x.png"), {}));
    ASSERT_TRUE(report.add(compare("a/x.png", "a/x.png"), {}));
    EXPECT_EQ(report.exit_code(), 2);
    const std::string xml = report.junit();
    EXPECT_THAT(xml, HasSubstr("tests=\"2\" failures=\"0\" errors=\"1\""));
    EXPECT_THAT(xml, HasSubstr("<error type=\"unreadable\""));
    EXPECT_THAT(xml, HasSubstr("<testcase classname=\"raster.diff\" name=\"x.png\"/>"));
}

TEST(DifferencePicture, FailingIsOrangeToleratedIsBlueTheRestIsGrey) {
    const Image8 a(10, 10, 3, 100);
    Image8 b = a;
    b.pixel(2, 3)[0] = 255;
    b.pixel(5, 5)[0] = 101;
    DiffOptions options;
    options.gates.max_delta = 1;
    options.ignored = {{9, 9, 1, 1}};
    const auto diff = raster::diff_images(a, b, options);
    ASSERT_TRUE(diff);
    const Image8 shown = raster::difference_picture(a, *diff);
    EXPECT_GT(shown.pixel(2, 3)[0], shown.pixel(2, 3)[2] + 100);
    EXPECT_GT(shown.pixel(5, 5)[2], shown.pixel(5, 5)[0] + 100);
    for (const auto& [x, y] : {std::pair(0, 0), {9, 9}}) {
        EXPECT_EQ(shown.pixel(x, y)[0], shown.pixel(x, y)[1]);
        EXPECT_EQ(shown.pixel(x, y)[0], shown.pixel(x, y)[2]);
    }
}

TEST(DifferencePicture, OfEightBitsAgainstSixteenIsDrawn) {
    const Image8 a(4, 4, 3, 0);
    const raster::Image16 b(4, 4, 3, 65535);
    const auto diff = raster::diff_images(a, b);
    ASSERT_TRUE(diff);
    const Image8 shown = raster::difference_picture(a, *diff);
    for (int i = 0; i < 16; ++i)
        EXPECT_GT(shown.samples[std::size_t(3 * i)], shown.samples[std::size_t(3 * i + 2)] + 100) << i;
}

TEST(FlipPicture, OnlyNoErrorIsBlackAndTheLargestIsWhite) {
    raster::Diff diff;
    diff.flip_map = ImageF(4, 1, 1);
    diff.flip_map.samples = {0.0f, 1e-6f, 0.5f, 1.0f};
    const raster::IndexedImage shown = raster::flip_picture(std::move(diff));
    const auto grey = [&](int x) { return int(shown.palette[*shown.indices.pixel(x, 0)][0]); };
    EXPECT_EQ(grey(0), 0);
    EXPECT_GT(grey(1), 0);
    EXPECT_NEAR(grey(2), 132, 4);
    EXPECT_EQ(grey(3), 255);
}

TEST(Triptych, ShowsASinglePixelOfALargePicture) {
    const Image8 a(3000, 40, 3, 100);
    Image8 b = a;
    b.pixel(1501, 7)[1] = 0;
    const auto diff = raster::diff_images(a, b);
    ASSERT_TRUE(diff);
    const Image8 page = raster::triptych(a, b, raster::indexed_difference(a, *diff));
    EXPECT_LE(page.width, 3 * 1024 + 32);
    int orange = 0;
    for (std::size_t i = 0; i < page.samples.size(); i += 3) orange += page.samples[i] > page.samples[i + 2] + 100;
    EXPECT_EQ(orange, 1);
}

TEST(DiffWords, FlipHasThreeDecimalsAndOnlyZeroIsZero) {
    EXPECT_EQ(raster::flip_number(0), "0.000");
    EXPECT_EQ(raster::flip_number(0.159691), "0.160");
    EXPECT_EQ(raster::flip_number(1), "1.000");
    EXPECT_EQ(raster::flip_number(0.00042), "0.0004");
    EXPECT_EQ(raster::flip_number(0.0000031), "0.000003");
}

TEST(DiffWords, RoundedUpFlipIsNeverBelow) {
    raster::testing::Random random(1);
    for (int i = 0; i < 10000; ++i) {
        const double value = double(random.uniform(0, 1)) * (i % 2 == 0 ? 1 : 1e-4);
        const double up = raster::rounded_up_flip(value);
        EXPECT_GE(up, value);
        EXPECT_LE(up, value + 0.001);
        EXPECT_GE(std::stod(raster::exact_number(up)), value);
    }
}

TEST(DiffWords, SsimIsOneOnlyForOne) {
    EXPECT_EQ(raster::ssim_number(1), "1.0000");
    EXPECT_EQ(raster::ssim_number(0.99999), "0.9999");
}

TEST(DiffWords, NumbersAreGroupedAndShort) {
    EXPECT_EQ(raster::grouped(8294400), "8,294,400");
    EXPECT_EQ(raster::grouped(-1234), "-1,234");
    EXPECT_EQ(raster::grouped(12), "12");
    EXPECT_EQ(raster::exact_number(3), "3");
    EXPECT_EQ(raster::exact_number(double(0.1f)), "0.1");
    EXPECT_EQ(raster::significant_number(1.8106), "1.811");
    EXPECT_EQ(raster::significant_number(0.0001234567), "0.0001235");
}

TEST(Json, WhatIsWrittenIsRead) {
    const std::string text = "tab\t quote\" slash\\ <b> \xc3\xa4 \xff end";
    const auto value =
        raster::parse_json(raster::JsonObject().text("name", text).number("n", -1.5).number("inf", 1.0 / 0.0).str());
    ASSERT_TRUE(value);
    EXPECT_EQ(value->member_text("name"), "tab\t quote\" slash\\ <b> \xc3\xa4 \xef\xbf\xbd end");
    EXPECT_EQ(value->member_text("n"), "-1.5");
    EXPECT_EQ(value->member_text("inf"), "");
}

TEST(Json, WhatIsNoJsonIsNothing) {
    for (const char* text : {"", "{", "[1,", "{\"a\":}", "\"\\x\"", "\"\\ud800\"", "[1] 2", "\"a", "{a:1}", "[\x01]"})
        EXPECT_FALSE(raster::parse_json(text)) << text;
    EXPECT_FALSE(raster::parse_json(std::string(100000, '[')));
    EXPECT_EQ(raster::parse_json("\"\\u00e4\\ud83d\\ude00\"")->text, "\xc3\xa4\xf0\x9f\x98\x80");
}

}  // namespace
