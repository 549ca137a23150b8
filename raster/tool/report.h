// report.h: what the command says: words on standard error, results on standard output, a number at the end.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include <raster/result.h>

namespace raster::tool {

/// What the process ends with. `raster diff` alone gives them another meaning.
enum ExitCode : int { exit_done = 0, exit_bad_input = 1, exit_usage = 2, exit_input_output = 3 };

ExitCode exit_code(ErrorKind kind);

/// One line on standard error; the line end is added.
void say(std::string_view line);

/// "error: " and the message on standard error; gives the exit code that belongs to it.
ExitCode fail(const Error& error);

/// All of the text on standard output, or an error in the system's words.
Status print(std::string_view text);

/// 1234567 as "1,234,567".
std::string with_separators(std::int64_t number);

/// "1 triangle", "2 triangles".
std::string counted(std::int64_t number, const std::string& noun);

}  // namespace raster::tool
