// obj_lines.cpp: line ends, continuations and zero bytes.
#include <raster/scene/obj_lines.h>

#include <algorithm>

namespace raster::obj {

std::string_view trimmed(std::string_view text) {
    while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
    while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
    return text;
}

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

LineReader::LineReader(std::string_view bytes, std::size_t max_line_bytes)
    : bytes_(bytes), max_line_bytes_(max_line_bytes) {
    if (bytes_.starts_with("\xef\xbb\xbf")) bytes_.remove_prefix(3);
    next_lf_ = find('\n', std::string_view::npos);
    next_cr_ = find('\r', std::string_view::npos);
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
        const bool has_zeros = line.find('\0') != line.npos;
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
