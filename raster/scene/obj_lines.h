// obj_lines.h: the statements of an OBJ or MTL file, one logical line after the other.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace raster::obj {

inline bool is_blank(char c) { return c == ' ' || c == '\t'; }

/// Without blanks at both ends.
inline std::string_view trimmed(std::string_view text) {
    while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
    while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
    return text;
}
/// Takes the first word off `text`, and the blanks around it; empty when there is none.
std::string_view next_word(std::string_view& text);

/// Whether the bytes are text of two bytes a character, which no OBJ reader takes. By the byte-order mark, or by
/// zero bytes at every other place.
bool is_utf16(std::string_view bytes);

/// Where the first statement after `at` surely starts: behind a line end that no backslash stands before. The size if
/// there is none. Up to there and from there on, a text can be read in two pieces.
std::size_t next_start(std::string_view bytes, std::size_t at);

/// Reads bytes as lines, so that what editors and systems put into files makes no difference: LF, CRLF and CR, a
/// byte-order mark, blanks at the ends, a last line without end, a backslash that continues a line on the next.
/// Empty lines and comments are left out; a comment cannot be continued (`C:/textures/` with backslashes at its end is
/// common). Zero bytes become blanks. Takes linear time whatever the bytes are. `bytes` is not copied.
class LineReader {
public:
    /// The lines are counted on from `lines_before`.
    LineReader(std::string_view bytes, std::size_t max_line_bytes, std::size_t lines_before = 0);

    /// Goes to the next statement. False at the end, or at a line that is too long.
    bool next();

    std::string_view text() const { return text_; }               ///< not empty; valid until next() is called
    std::string_view rest() const { return bytes_.substr(at_); }  ///< what is not read yet
    /// Passes over the first `bytes` of the rest, whole lines, as if they had been read.
    void skip(std::size_t bytes, std::size_t lines) {
        at_ += bytes;
        lines_taken_ += lines;
    }
    std::size_t line() const { return line_; }       ///< where the statement starts, from 1
    std::size_t position() const { return at_; }     ///< bytes read so far
    std::size_t lines_taken() const { return lines_taken_; }
    bool is_too_long() const { return is_too_long_; }
    std::size_t first_line_with_zeros() const { return first_line_with_zeros_; }  ///< 0: none so far

private:
    std::string_view take_physical_line();
    std::size_t find(char c, std::size_t cached) const;

    std::string_view bytes_;
    std::size_t max_line_bytes_;
    std::size_t at_ = 0;
    std::size_t lines_taken_ = 0;
    std::size_t next_lf_ = 0, next_cr_ = 0;  ///< where they stand, at or after at_
    std::string_view text_;
    std::string joined_;
    std::size_t line_ = 0;
    std::size_t first_line_with_zeros_ = 0;
    bool is_too_long_ = false, any_zeros_ = false;
};

}  // namespace raster::obj
