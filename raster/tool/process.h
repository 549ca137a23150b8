// process.h: what a well-behaved process sets up before anything else.
#pragma once

namespace raster::tool {

/// - A closed standard stream is opened on /dev/null in the wrong direction: else the next file to be opened
///   would get its number, and messages would end up in a picture. Using it still fails.
/// - Writing into a pipe without a reader, or beyond the limit for file sizes, becomes an error instead of a
///   signal.
/// - The stack is grown now, while there is memory for it.
void prepare_process();

}  // namespace raster::tool
