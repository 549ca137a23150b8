// diff_cross_test.cpp: the figures held to programs that others wrote, where they are installed: idiff (OpenImageIO),
// compare (ImageMagick), pixelmatch and odiff (npm). The latter two are looked for on PATH and in the folder that the
// variable RASTER_DIFF_TOOLS names: `npm install --prefix FOLDER pixelmatch odiff-bin`.
#include <raster/image/diff.h>
#include <raster/image/png.h>

#include <stdlib.h>

#include <cstdio>
#include <filesystem>
#include <optional>
#include <regex>
#include <sstream>

#include <gtest/gtest.h>

#include "random.h"

namespace {

namespace fs = std::filesystem;
using raster::Image16;
using raster::Image8;
using raster::testing::Random;

std::optional<std::string> find_program(const std::string& name) {
    std::string folders = std::getenv("PATH") != nullptr ? std::getenv("PATH") : "";
    if (const char* tools = std::getenv("RASTER_DIFF_TOOLS"))
        folders += std::string(":") + tools + "/node_modules/.bin";
    std::stringstream all(folders);
    for (std::string folder; std::getline(all, folder, ':');)
        if (fs::exists(folder + "/" + name)) return folder + "/" + name;
    return std::nullopt;
}

/// What a command says, on either stream.
std::string output_of(const std::string& command) {
    std::string text;
    FILE* pipe = ::popen((command + " 2>&1").c_str(), "r");
    if (pipe == nullptr) return text;
    char buffer[4096];
    while (const std::size_t count = std::fread(buffer, 1, sizeof buffer, pipe)) text.append(buffer, count);
    ::pclose(pipe);
    return text;
}

/// The first number after `before`, NaN if there is none.
double number_after(const std::string& text, const std::string& before) {
    std::smatch found;
    const std::regex pattern(before + R"([^0-9\-]*([0-9.]+(?:e[-+]?[0-9]+)?))");
    return std::regex_search(text, found, pattern) ? std::stod(found[1]) : std::numeric_limits<double>::quiet_NaN();
}

/// Pairs with many, few, large and small differences; all opaque, so that alpha is no matter.
class Cross : public testing::TestWithParam<int> {
protected:
    void SetUp() override {
        std::string name = (fs::temp_directory_path() / "raster-cross-XXXXXX").string();
        ASSERT_NE(::mkdtemp(name.data()), nullptr);
        folder = name;
        Random random{std::uint64_t(GetParam())};
        expected = Image8(61 + 10 * GetParam(), 47, 3);
        for (std::size_t i = 0; i < expected.samples.size(); ++i)
            expected.samples[i] = std::uint8_t(random.integer(0, 255));
        actual = expected;
        const int changes[] = {0, 1, 40, 2000, 20000}, largest[] = {0, 1, 255, 3, 255};
        for (int i = 0; i < changes[GetParam()]; ++i) {
            const auto where = std::size_t(random.integer(0, int(actual.samples.size()) - 1));
            const int step = random.integer(1, largest[GetParam()]);
            actual.samples[where] = std::uint8_t(
                std::clamp(int(expected.samples[where]) + (random.integer(0, 1) == 0 ? step : -step), 0, 255));
        }
        ASSERT_TRUE(raster::write_png(file("a.png"), expected));
        ASSERT_TRUE(raster::write_png(file("b.png"), actual));
        const auto diff = raster::diff_images(expected, actual);
        ASSERT_TRUE(diff);
        figures = *diff->figures;
    }
    void TearDown() override { fs::remove_all(folder); }

    std::string file(const std::string& name) const { return folder + "/" + name; }
    std::string both() const { return " " + file("a.png") + " " + file("b.png"); }

    std::string folder;
    Image8 expected, actual;
    raster::Figures figures;
};

TEST_P(Cross, IdiffFindsTheSame) {
    const auto idiff = find_program("idiff");
    if (!idiff) GTEST_SKIP() << "idiff is not installed (openimageio-tools)";
    const std::string text = output_of(*idiff + " -v" + both());
    if (figures.differing == 0) {
        EXPECT_NE(text.find("PASS"), std::string::npos) << text;
        return;
    }
    EXPECT_NEAR(number_after(text, "Mean error ="), figures.mean / 255, 1e-5 * figures.mean / 255 + 1e-9) << text;
    EXPECT_NEAR(number_after(text, "RMS error ="), figures.rms / 255, 1e-5 * figures.rms / 255 + 1e-9) << text;
    EXPECT_NEAR(number_after(text, "Peak SNR ="), figures.psnr, 1e-3) << text;
    EXPECT_NEAR(number_after(text, "Max error  ="), figures.max / 255, 1e-5) << text;
}

TEST_P(Cross, ImageMagickFindsTheSame) {
    const auto compare = find_program("compare");
    if (!compare) GTEST_SKIP() << "compare is not installed (imagemagick)";
    const auto metric = [&](const std::string& name) {
        return output_of(*compare + " -metric " + name + both() + " null:");
    };
    EXPECT_NEAR(number_after(metric("AE"), ""), double(figures.differing), 1e-5 * double(figures.differing));
    // "123.4 (0.0123)": the normalised one.
    EXPECT_NEAR(number_after(metric("MAE"), R"(\()"), figures.mean / 255, 1e-5 * figures.mean / 255 + 1e-9);
    EXPECT_NEAR(number_after(metric("RMSE"), R"(\()"), figures.rms / 255, 1e-5 * figures.rms / 255 + 1e-9);
    EXPECT_NEAR(number_after(metric("PAE"), R"(\()"), figures.max / 255, 1e-5);
}

TEST_P(Cross, PixelmatchCountsTheSame) {
    const auto pixelmatch = find_program("pixelmatch");
    if (!pixelmatch) GTEST_SKIP() << "pixelmatch is not installed (npm)";
    // Threshold 0, and pixels that look like antialiasing counted too.
    const std::string text = output_of(*pixelmatch + both() + " " + file("d.png") + " 0 true");
    EXPECT_EQ(number_after(text, "different pixels:"), double(figures.differing)) << text;
}

TEST_P(Cross, OdiffCountsTheSame) {
    const auto odiff = find_program("odiff");
    if (!odiff) GTEST_SKIP() << "odiff is not installed (npm: odiff-bin)";
    const std::string text = output_of(*odiff + both() + " " + file("d.png") + " -t 0");
    if (figures.differing == 0) EXPECT_NE(text.find("identical"), std::string::npos) << text;
    else EXPECT_EQ(number_after(text, "Found"), double(figures.differing)) << text;
}

INSTANTIATE_TEST_SUITE_P(Pairs, Cross, testing::Range(0, 5));

// The example of FLIP's authors: images/reference.png and images/test.png of their repository, mean 0.159691. The
// pictures are not ours to ship; RASTER_FLIP_EXAMPLE names the folder that holds them.
TEST(CrossExample, FlipIsWhatItsAuthorsPublish) {
    const char* folder = std::getenv("RASTER_FLIP_EXAMPLE");
    if (folder == nullptr) GTEST_SKIP() << "RASTER_FLIP_EXAMPLE is not set";
    const auto reference = raster::load_image(std::string(folder) + "/reference.png");
    const auto test = raster::load_image(std::string(folder) + "/test.png");
    ASSERT_TRUE(reference && test);
    const auto diff = raster::diff_images(*reference, *test);
    ASSERT_TRUE(diff);
    EXPECT_NEAR(diff->figures->flip, 0.159691, 5e-5);
}

}  // namespace
