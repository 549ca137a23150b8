// parse.h: values of flags out of text: all of it or an error that says what is expected.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <glm/glm.hpp>

#include <raster/image/diff.h>
#include <raster/result.h>

namespace raster::tool {

inline Error usage(const std::string& what) { return {ErrorKind::usage, what}; }

// The errors below are of kind usage. Their message quotes the text and says what would do: "'12x' is no size; ...".

/// A finite float in decimal: 1, -0.5, +3, 1e-3. The locale does not matter.
Result<float> parse_number(std::string_view text);
/// A finite float from `low` to `high`.
Result<float> parse_number_within(std::string_view text, float low, float high);
/// A whole number from `low` to `high`.
Result<int> parse_count(std::string_view text, int low, int high);
/// X,Y,Z
Result<glm::vec3> parse_vector(std::string_view text);
/// +X, -X, +Y, -Y, +Z, -Z (or without the +) or X,Y,Z, not all 0.
Result<glm::vec3> parse_direction(std::string_view text);
/// R,G,B of 0 and up; one number for all three; #RRGGBB or #RGB in hexadecimal.
Result<glm::vec3> parse_color(std::string_view text);
/// As parse_color, within 0 to 1, or with an alpha: R,G,B,A; #RRGGBBAA; `transparent`.
Result<glm::vec4> parse_background(std::string_view text);

/// Width and height of a picture in pixels.
struct Size {
    int width = 800;
    int height = 600;
    friend bool operator==(const Size&, const Size&) = default;
};
/// WIDTHxHEIGHT within ImageLimits.
Result<Size> parse_size(std::string_view text);
std::string to_text(const Size& size);

/// X,Y,WIDTH,HEIGHT of at least one pixel; it may reach beyond a picture.
Result<PixelRect> parse_rect(std::string_view text);
/// X,Y from 0.
Result<glm::ivec2> parse_pixel(std::string_view text);

/// NAME:KEY=VALUE:KEY=VALUE, as lights and materials are written. Without a name it begins with KEY=VALUE.
struct Spec {
    std::string name;
    std::vector<std::pair<std::string, std::string>> values;
};
Result<Spec> parse_spec(std::string_view text);

/// A float as short as it can be written to be read back the same.
std::string to_text(float number);
std::string to_text(const glm::vec3& v);

/// Pieces between separators; one more than there are separators.
std::vector<std::string_view> split(std::string_view text, char separator);

/// 'text' in quotes, control characters as \xNN, cut when long.
std::string in_quotes(std::string_view text);

/// Of the candidates, the one that `text` is likely a misspelling of; empty when none is near.
std::string nearest(std::string_view text, const std::vector<std::string>& candidates);
/// "; did you mean --size?", or nothing.
std::string did_you_mean(std::string_view text, const std::vector<std::string>& candidates);

}  // namespace raster::tool
