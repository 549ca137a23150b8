// scene_obj_text_test.cpp: bytes to statements and words to numbers, before any of it means geometry.
#include <charconv>
#include <clocale>
#include <limits>

#include <raster/scene/obj_lines.h>
#include <raster/scene/obj_report.h>
#include <raster/scene/obj_tokens.h>

#include "random.h"
#include "scene_obj_testing.h"

namespace raster::obj {
namespace {

using ::testing::ElementsAre;
using ::testing::Pair;

std::vector<std::pair<std::size_t, std::string>> lines(const std::string& text, std::size_t longest = 1000) {
    LineReader reader(text, longest);
    std::vector<std::pair<std::size_t, std::string>> all;
    while (reader.next()) all.emplace_back(reader.line(), reader.text());
    return all;
}

TEST(ObjLines, EveryLineEndIsTheSame) {
    const auto expected = ElementsAre(Pair(1u, "v 1 2 3"), Pair(3u, "f 1 2 3"));
    EXPECT_THAT(lines("v 1 2 3\n\nf 1 2 3\n"), expected);
    EXPECT_THAT(lines("v 1 2 3\r\n\r\nf 1 2 3\r\n"), expected);
    EXPECT_THAT(lines("v 1 2 3\r\rf 1 2 3\r"), expected);
    EXPECT_THAT(lines("v 1 2 3\n\nf 1 2 3"), expected);
    EXPECT_THAT(lines("\xef\xbb\xbfv 1 2 3\r\n\n  f 1 2 3\t "), expected);
}

TEST(ObjLines, CommentsAndEmptyLinesAreLeftOut) {
    EXPECT_THAT(lines("# a\n \t \n  # b\nv 1\n#\\\nv 2"), ElementsAre(Pair(4u, "v 1"), Pair(6u, "v 2")));
    EXPECT_TRUE(lines("").empty());
    EXPECT_TRUE(lines("\n\r\n\r#").empty());
}

TEST(ObjLines, ABackslashContinuesTheLine) {
    EXPECT_THAT(lines("f 1 \\\n2 \\\r\n 3\ng a"), ElementsAre(Pair(1u, "f 1  2  3"), Pair(4u, "g a")));
    EXPECT_THAT(lines("f 1\\\n2"), ElementsAre(Pair(1u, "f 1 2")));
    EXPECT_THAT(lines("f 1 2\\"), ElementsAre(Pair(1u, "f 1 2")));
    EXPECT_TRUE(lines("\\\n\\\n\\").empty());
}

TEST(ObjLines, ZeroBytesBecomeBlanksAndAreRemembered) {
    const std::string text("v 1\nv\0002\n\0\0\nv 3", 14);
    LineReader reader(text, 100);
    ASSERT_TRUE(reader.next());
    EXPECT_EQ(reader.first_line_with_zeros(), 0u);
    ASSERT_TRUE(reader.next());
    EXPECT_EQ(reader.text(), "v 2");
    EXPECT_EQ(reader.first_line_with_zeros(), 2u);
    ASSERT_TRUE(reader.next());
    EXPECT_EQ(reader.text(), "v 3");
    EXPECT_EQ(reader.line(), 4u);
    EXPECT_FALSE(reader.next());
}

TEST(ObjLines, ALineBeyondTheLimitEndsTheReading) {
    for (const std::string& text : {std::string("v 1\nf 1 2 3 4 5"), std::string("v 1\nf 1 2\\\n3 4 5\\\n6")}) {
        LineReader reader(text, 9);
        EXPECT_TRUE(reader.next());
        EXPECT_FALSE(reader.next());
        EXPECT_TRUE(reader.is_too_long());
        EXPECT_EQ(reader.line(), 2u);
    }
    EXPECT_THAT(lines("# a comment may be long\nf 1 2 3 4", 9), ElementsAre(Pair(2u, "f 1 2 3 4")));
}

TEST(ObjLines, AMillionLinesOfOneKindOfEndTakeNoTimeToSpeakOf) {
    // With a search for LF to the end of the file at each line this would take minutes.
    for (const char end : {'\r', '\n'}) {
        std::string text;
        for (int i = 0; i < 1'000'000; ++i) text += std::string("v ") + end;
        EXPECT_EQ(lines(text).size(), 1'000'000u);
    }
}

TEST(ObjLines, TwoByteTextIsRecognised) {
    EXPECT_TRUE(is_utf16("\xff\xfev"));
    EXPECT_TRUE(is_utf16("\xfe\xff"));
    EXPECT_TRUE(is_utf16(std::string("v\0 \0001\0 \0002\0", 10)));
    EXPECT_TRUE(is_utf16(std::string("\0v\0 \0001\0 \0002", 10)));
    EXPECT_FALSE(is_utf16("v 1 2 3\n"));
    EXPECT_FALSE(is_utf16(std::string(64, '\0')));
    EXPECT_FALSE(is_utf16(""));
}

TEST(ObjNumbers, EverySpellingThatMeansANumber) {
    EXPECT_EQ(parse_number("1"), 1.0f);
    EXPECT_EQ(parse_number("+1"), 1.0f);
    EXPECT_EQ(parse_number("-1.5"), -1.5f);
    EXPECT_EQ(parse_number("2."), 2.0f);
    EXPECT_EQ(parse_number("-.5"), -0.5f);
    EXPECT_EQ(parse_number("+1E+2"), 100.0f);
    EXPECT_EQ(parse_number("25e-2"), 0.25f);
    EXPECT_EQ(parse_number("000001.50000"), 1.5f);
}

TEST(ObjNumbers, AreTheNearestFloats) {
    EXPECT_EQ(parse_number("0.1"), 0.1f);
    EXPECT_EQ(parse_number("0.100000001490116119384765625"), 0.1f);
    EXPECT_EQ(parse_number("3.4028234e38"), std::numeric_limits<float>::max());
    EXPECT_EQ(parse_number("1.00000005960464477539062500"), 1.0f);         // half way: to even
    EXPECT_EQ(parse_number("1.00000005960464477539062501"), 1.00000012f);  // a hair above
    EXPECT_EQ(parse_number("1e-45"), std::numeric_limits<float>::denorm_min());
    // printf with nine digits and back is the identity.
    testing::Random random(3);
    for (int i = 0; i < 10000; ++i) {
        const float f = std::bit_cast<float>(std::uint32_t(random.bits()));
        if (!std::isfinite(f)) continue;
        char text[32];
        std::snprintf(text, sizeof text, "%.9g", double(f));
        EXPECT_EQ(parse_number(text), f) << text;
    }
}

float from_chars_of(const std::string& text) {
    float value = 0;
    std::from_chars(text.data() + (text[0] == '-'), text.data() + text.size(), value);
    return text[0] == '-' ? -value : value;
}

std::uint32_t read_bits(const std::string& text) {
    const Numbers numbers = parse_numbers(text);
    EXPECT_EQ(numbers.count, 1) << text;
    return std::bit_cast<std::uint32_t>(numbers.value[0]);
}

TEST(ObjNumbers, DigitsAndDecimalsAreThoseOfTheStandardLibrary) {
    for (int i = 0; i < 2'000'000; i += 7) {
        char text[32];
        std::snprintf(text, sizeof text, "%d.%06d", i / 1'000'000, i % 1'000'000);
        ASSERT_EQ(read_bits(text), std::bit_cast<std::uint32_t>(from_chars_of(text))) << text;
    }
    testing::Random random(4);
    for (int i = 0; i < 300'000; ++i) {
        std::string text = random.integer(0, 1) == 0 ? "-" : "";
        const int digits = random.integer(1, 18), point = random.integer(-1, digits);
        for (int d = 0; d < digits; ++d) {
            if (d == point) text += '.';
            text += char('0' + random.integer(0, 9));
        }
        if (point == digits) text += '.';
        ASSERT_EQ(read_bits(text), std::bit_cast<std::uint32_t>(from_chars_of(text))) << text;
    }
    // Half way between two floats, or a hair to either side: all digits count.
    for (int i = 0; i < 100'000; ++i) {
        const auto odd = std::uint32_t(random.integer(1 << 24, (1 << 25) - 1)) | 1;  // 25 bits
        const int scale = random.integer(0, 8);
        char text[48];
        std::snprintf(text, sizeof text, "%.*f", scale, double(odd) / (1 << scale));
        for (const char* tail : {"", "0", "000", "0000", "00000", "1", "0001", "00000000001"}) {
            const std::string number = text + std::string(scale == 0 ? "." : "") + tail;
            ASSERT_EQ(read_bits(number), std::bit_cast<std::uint32_t>(from_chars_of(number))) << number;
        }
    }
}

TEST(ObjNumbers, TooLargeIsInfiniteAndTooSmallIsZero) {
    const float infinity = std::numeric_limits<float>::infinity();
    EXPECT_EQ(parse_number("1e39"), infinity);
    EXPECT_EQ(parse_number("-1e999"), -infinity);
    EXPECT_EQ(parse_number("1e99999999999999999999"), infinity);
    EXPECT_EQ(parse_number("1" + std::string(400, '0')), infinity);
    EXPECT_EQ(parse_number("1e-50"), 0.0f);
    EXPECT_EQ(parse_number("-1e-999"), 0.0f);
    EXPECT_EQ(parse_number("1e-99999999999999999999"), 0.0f);
    EXPECT_EQ(parse_number("0." + std::string(400, '0') + "1"), 0.0f);
    EXPECT_EQ(parse_number("0e999"), 0.0f);
}

TEST(ObjNumbers, EverythingElseIsNone) {
    for (const char* word : {"",    "+",   "-",   ".",    "+-1",      "--1",    "1,5",  "1.5f",   "1e",  "1e+", "0x10",
                             "nan", "NaN", "inf", "-inf", "infinity", "nan(1)", "1.-2", "3.1+e2", "abc", "1/2", "e5"})
        EXPECT_TRUE(std::isnan(parse_number(word))) << word;
}

TEST(ObjNumbers, DoNotDependOnTheLocale) {
    const std::string before = std::setlocale(LC_ALL, nullptr);
    for (const char* name : {"de_DE.UTF-8", "fr_FR.UTF-8", "de_DE"}) std::setlocale(LC_ALL, name);
    EXPECT_EQ(parse_number("1.5"), 1.5f);
    EXPECT_TRUE(std::isnan(parse_number("1,5")));
    std::setlocale(LC_ALL, before.c_str());
}

TEST(ObjCorners, TheFourForms) {
    using Index = CornerWord::Index;
    const auto states = [](const char* word) {
        const CornerWord c = parse_corner(word);
        return std::tuple(c.well_formed, c.state[0], c.state[1], c.state[2]);
    };
    const Index good = Index::good, bad = Index::bad, missing = Index::missing;
    EXPECT_EQ(states("7"), std::tuple(true, good, missing, missing));
    EXPECT_EQ(states("-7/2"), std::tuple(true, good, good, missing));
    EXPECT_EQ(states("7//3"), std::tuple(true, good, missing, good));
    EXPECT_EQ(states("7/2/3"), std::tuple(true, good, good, good));
    EXPECT_EQ(states("7/"), std::tuple(true, good, missing, missing));
    EXPECT_EQ(states("0/0/0"), std::tuple(true, bad, bad, bad));
    EXPECT_EQ(states("2147483648/99999999999/-2147483648"), std::tuple(true, bad, bad, bad));
    EXPECT_EQ(states("2147483647/x/1.5"), std::tuple(true, good, bad, bad));
    EXPECT_EQ(states("+-7//--3"), std::tuple(true, bad, missing, bad));
    EXPECT_FALSE(std::get<0>(states("1/2/3/4")));
    EXPECT_FALSE(std::get<0>(states("/2/3")));
}

TEST(ObjCorners, AreNumbersAsWritten) {
    const auto indices = [](const char* word) {
        const CornerWord c = parse_corner(word);
        return std::tuple(c.index[0], c.index[1], c.index[2]);
    };
    EXPECT_EQ(indices("7"), std::tuple(7, 0, 0));
    EXPECT_EQ(indices("-7/+2"), std::tuple(-7, 2, 0));
    EXPECT_EQ(indices("2147483647//-2147483647"), std::tuple(2147483647, 0, -2147483647));
    EXPECT_EQ(indices("7/x/1.5"), std::tuple(7, 0, 0));
}

/// Whether all the words are plain corners, and those.
bool read_plain(std::string_view text, std::vector<Corner>& corners) {
    const char* const end = text.data() + text.size();
    corners.clear();
    return read_plain_corners(text.data(), end, corners) == end;
}

TEST(ObjCorners, PlainOnesHaveNoFault) {
    std::vector<Corner> corners;
    for (const char* text : {"1 2 3", "-1 +2 3", "1/2 3/4  5/6", "1//2\t3//4", "123456789/1/-1 2"})
        EXPECT_TRUE(read_plain(text, corners)) << text;
    for (const char* text : {"",     "0",  "1 0",     "1/0", "1//0", "1/2/0", "x",          "1x",  "1/",  "1//", "1/2/",
                             "/1",   "+",  "1/2/3/4", "1 -", "01",   "1 # 2", "1234567890", "1.5", "--1", "+-1"})
        EXPECT_FALSE(read_plain(text, corners)) << text;
    testing::Random random(5);
    int plain = 0;
    for (int i = 0; i < 300'000; ++i) {
        std::string text = "1";
        for (int length = random.integer(0, 8); length > 0; --length)
            text += "  \t1203456789//-+"[random.integer(0, 16)];
        std::string_view words = trimmed(text);
        if (!read_plain(words, corners)) continue;
        ++plain;
        for (const Corner& read : corners) {
            const CornerWord corner = parse_corner(next_word(words));
            ASSERT_TRUE(read.position == corner.index[0] && read.uv == corner.index[1] &&
                        read.normal == corner.index[2])
                << text;
            ASSERT_TRUE(corner.well_formed) << text;
            for (const auto state : corner.state) ASSERT_NE(state, CornerWord::Index::bad) << text;
            ASSERT_EQ(corner.state[0], CornerWord::Index::good) << text;
        }
        ASSERT_TRUE(words.empty()) << text;
    }
    EXPECT_GT(plain, 10'000);
}

TEST(ObjMessages, ControlCharactersAndBrokenTextAreSpeltOut) {
    EXPECT_EQ(in_quotes("gold"), "'gold'");
    EXPECT_EQ(in_quotes("\x1b[31m\x7f"), "'\\x1b[31m\\x7f'");
    EXPECT_EQ(in_quotes("Gr\xc3\xbcn"), "'Gr\xc3\xbcn'");
    EXPECT_EQ(in_quotes("\xc3"), "'\\xc3'");
    EXPECT_EQ(in_quotes("\xc2\x9b"
                        "1m"),
              "'\\xc2\\x9b1m'");
    EXPECT_EQ(in_quotes("\xed\xa0\x80\xf4\x90\x80\x80\xc0\x80"), "'\\xed\\xa0\\x80\\xf4\\x90\\x80\\x80\\xc0\\x80'");
    EXPECT_LT(in_quotes(std::string(5000, 'x')).size(), 200u);
}

TEST(ObjMessages, CountedAndNamed) {
    EXPECT_EQ((LoadWarning{"bunny.obj", 12, 3, "face dropped: zero area", "faces dropped: zero area"}.message()),
              "bunny.obj: 3 faces dropped: zero area (first at line 12)");
    EXPECT_EQ((LoadWarning{"bunny.obj", 12, 1, "face dropped: zero area", "faces dropped: zero area"}.message()),
              "bunny.obj: 1 face dropped: zero area (line 12)");
    EXPECT_EQ((LoadWarning{"a.obj", 7, 4, "unknown material 'x'", ""}.message()),
              "a.obj:7: unknown material 'x' (4 times)");
    EXPECT_EQ((LoadWarning{"a.obj", 0, 1, "UTF-16", ""}.message()), "a.obj: UTF-16");
}

TEST(ObjMessages, KindsAreCountedOnceAndBeyondAHundredLeftOut) {
    LoadReport report;
    Log log(report, false);
    for (int i = 0; i < 150; ++i)
        for (int times = 0; times < 2; ++times) log.warn({"a", 1}, "kind " + std::to_string(i));
    EXPECT_EQ(report.warnings.size(), 100u);
    EXPECT_EQ(report.warnings[99].count, 2u);
    EXPECT_EQ(report.warnings_left_out, 100u);
    EXPECT_EQ(report.messages().back(), "and 100 more warnings");
    EXPECT_FALSE(log.failed());
}

}  // namespace
}  // namespace raster::obj
