// report.cpp: output without streams: one write a message, so that lines of several processes do not mix.
#include "report.h"

#include <unistd.h>

#include <cstdio>

#include <raster/image/file.h>

namespace raster::tool {

ExitCode exit_code(ErrorKind kind) {
    switch (kind) {
        case ErrorKind::bad_input: return exit_bad_input;
        case ErrorKind::usage: return exit_usage;
        case ErrorKind::input_output: break;
    }
    return exit_input_output;
}

void say(std::string_view line) {
    std::string text(line);
    text += '\n';
    // Where even standard error is gone, nobody is left to tell.
    (void)!::write(STDERR_FILENO, text.data(), text.size());
}

ExitCode fail(const Error& error) {
    say("error: " + error.message);
    return exit_code(error.kind);
}

Status print(std::string_view text) { return write_file("-", std::as_bytes(std::span(text))); }

std::string with_separators(std::int64_t number) {
    std::string digits = std::to_string(number);
    const std::size_t first = number < 0 ? 1 : 0;
    for (std::size_t i = digits.size(); i > first + 3; i -= 3) digits.insert(i - 3, 1, ',');
    return digits;
}

std::string counted(std::int64_t number, const std::string& noun) {
    return with_separators(number) + " " + noun + (number == 1 ? "" : "s");
}

}  // namespace raster::tool
