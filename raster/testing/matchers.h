// matchers.h: golden pictures as a GoogleTest matcher: EXPECT_THAT(image, raster::testing::MatchesGolden("teapot")).
#pragma once

#include <ostream>
#include <string>
#include <utility>

#include <gmock/gmock.h>

#include <raster/testing/golden.h>

namespace raster {

/// GoogleTest prints a picture by its size, not by its bytes.
template <class T>
void PrintTo(const Image<T>& image, std::ostream* out) {
    *out << "a picture of " << image.width << "x" << image.height << " pixels, " << image.channels << " channels of "
         << 8 * sizeof(T) << " bits";
}

}  // namespace raster

namespace raster::testing {

/// The matcher behind MatchesGolden.
class GoldenMatcher {
public:
    using is_gtest_matcher = void;

    GoldenMatcher(std::string name, DiffOptions options, GoldenFolders folders)
        : name_(std::move(name)), options_(std::move(options)), folders_(std::move(folders)) {}

    template <class Picture>
    bool MatchAndExplain(const Picture& picture, ::testing::MatchResultListener* listener) const {
        const GoldenResult result = check_golden(name_, AnyImage(picture), options_, folders_);
        if (!result.message.empty()) *listener << "\n" << result.message;
        return result.passed;
    }
    void DescribeTo(std::ostream* out) const {
        *out << "is the golden picture \"" << name_ << "\", " << to_string(options_.gates);
    }
    void DescribeNegationTo(std::ostream* out) const { *out << "is not the golden picture \"" << name_ << "\""; }

private:
    std::string name_;
    DiffOptions options_;
    GoldenFolders folders_;
};

/// Matches an Image8, Image16, ImageF or AnyImage that equals its golden, or is within the gates. See check_golden.
///
///     EXPECT_THAT(image, raster::testing::MatchesGolden("teapot"));
///     EXPECT_THAT(image, raster::testing::MatchesGolden("teapot", {.max_delta = 1}));
inline GoldenMatcher MatchesGolden(std::string name, Gates gates = {}) {
    DiffOptions options;
    options.gates = gates;
    return GoldenMatcher(std::move(name), std::move(options), default_folders());
}
/// With a mask, ignored rectangles and all else.
inline GoldenMatcher MatchesGoldenWith(std::string name, DiffOptions options) {
    return GoldenMatcher(std::move(name), std::move(options), default_folders());
}

}  // namespace raster::testing
