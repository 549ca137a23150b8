// history_text.h: a pixel's history in words for a person, and as JSON for a program.
#pragma once

#include <string>

#include <raster/trace/history.h>

namespace raster {

/// One line for the verdict, one for each triangle (its number in the model counted from 1, as --aov has it), and for
/// what is seen also the summands of its colour. Long lists are cut, and the text says so.
std::string history_text(const PixelHistory& history);

/// Only the verdict: "WON, triangle 41 by depth; 2 others lost".
std::string verdict_text(const PixelHistory& history);

/// One JSON object on one line, with every number that was computed (docs/trace.md). What was not reached is null.
std::string history_json(const PixelHistory& history);

}  // namespace raster
