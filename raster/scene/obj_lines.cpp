// obj_lines.cpp: line ends, continuations and zero bytes.
#include <raster/scene/obj_lines.h>

#include <algorithm>

namespace raster::obj {
namespace {

constexpr std::string_view byte_order_mark = "\xef\xbb\xbf";

}  // namespace

std::string_view next_word(std::string_view& text) {
    std::size_t start = 0;
    while (start < text.size() && is_blank(text[start])) ++start;
    std::size_t end = start;
    while (end < text.size() && !is_blank(text[end])) ++end;
    const std::string_view word = text.substr(start, end - start);
    while (end < text.size() && is_blank(text[end])) ++end;
    text.remove_prefix(end);
    return word;
}

bool is_utf16(std::string_view bytes) {
    if (bytes.starts_with("\xff\xfe") || bytes.starts_with("\xfe\xff")) return true;
    const std::size_t pairs = std::min<std::size_t>(bytes.size() / 2, 32);
    std::size_t zeros[2] = {0, 0};
    for (std::size_t i = 0; i < 2 * pairs; ++i) zeros[i % 2] += bytes[i] == '\0';
    return pairs >= 4 && ((zeros[0] == pairs && zeros[1] == 0) || (zeros[1] == pairs && zeros[0] == 0));
}

std::size_t next_start(std::string_view bytes, std::size_t at) {
    at = std::min(at, bytes.size());
    if (at > 0 && bytes.substr(at - 1).starts_with("\r\n")) --at;
    for (at = bytes.find_first_of("\r\n", at); at < bytes.size(); at = bytes.find_first_of("\r\n", at)) {
        std::size_t last = at;
        while (last > 0 && is_blank(bytes[last - 1])) --last;
        const bool goes_on = last > 0 && bytes[last - 1] == '\\';
        at += bytes.substr(at).starts_with("\r\n") ? 2 : 1;
        // A byte-order mark counts at the top only, and each piece has a top.
        if (!goes_on && !bytes.substr(at).starts_with(byte_order_mark)) return at;
    }
    return bytes.size();
}

LineReader::LineReader(std::string_view bytes, std::size_t max_line_bytes, std::size_t lines_before)
    : bytes_(bytes), max_line_bytes_(max_line_bytes), lines_taken_(lines_before) {
    if (bytes_.starts_with(byte_order_mark)) bytes_.remove_prefix(byte_order_mark.size());
    next_lf_ = find('\n', std::string_view::npos);
    next_cr_ = find('\r', std::string_view::npos);
    any_zeros_ = bytes_.find('\0') != std::string_view::npos;
}

// Each kind of line end is looked for again only when the last one found is passed. Otherwise a file without LF
// would be searched to its end for each line.
std::size_t LineReader::find(char c, std::size_t cached) const {
    if (cached != std::string_view::npos && cached >= at_) return cached;
    return std::min(bytes_.find(c, at_), bytes_.size());
}

std::string_view LineReader::take_physical_line() {
    next_lf_ = find('\n', next_lf_);
    next_cr_ = find('\r', next_cr_);
    const std::size_t end = std::min(next_lf_, next_cr_);
    const std::string_view line = bytes_.substr(at_, end - at_);
    const bool is_crlf = next_cr_ < bytes_.size() && next_lf_ == next_cr_ + 1;
    at_ = std::min(end + (is_crlf ? 2 : 1), bytes_.size());
    ++lines_taken_;
    return line;
}

bool LineReader::next() {
    while (at_ < bytes_.size()) {
        std::string_view line = trimmed(take_physical_line());
        line_ = lines_taken_;
        if (line.empty() || line.front() == '#') continue;

        const bool is_joined = line.back() == '\\';
        const bool has_zeros = any_zeros_ && line.find('\0') != line.npos;
        if (is_joined || has_zeros) {
            joined_.clear();
            while (true) {
                const bool goes_on = !line.empty() && line.back() == '\\';
                joined_ += line.substr(0, line.size() - (goes_on ? 1 : 0));
                if (!goes_on || at_ == bytes_.size() || joined_.size() > max_line_bytes_) break;
                joined_ += ' ';
                line = trimmed(take_physical_line());
            }
            if (first_line_with_zeros_ == 0 && joined_.find('\0') != joined_.npos) first_line_with_zeros_ = line_;
            std::replace(joined_.begin(), joined_.end(), '\0', ' ');
            line = trimmed(joined_);
            if (line.empty()) continue;
        }
        if (line.size() > max_line_bytes_) {
            is_too_long_ = true;
            return false;
        }
        text_ = line;
        return true;
    }
    return false;
}

}  // namespace raster::obj
