// file.h: writing that leaves a whole file or none, and reading that neither hangs nor exhausts memory.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include <raster/result.h>

namespace raster {

using Bytes = std::vector<std::byte>;

/// Writes `bytes` to `path`, so that at any moment, a crash or kill -9 included, the path names either the
/// old file whole or the new one whole: the bytes go to a temporary file in the same folder (named
/// `.raster-*.tmp`; a killed process can leave one behind), fsync, then rename.
///
/// - "-" and "/dev/stdout" are standard output.
/// - A symbolic link stays; the file it leads to is replaced, or made if it is missing.
/// - Devices, pipes and the like (/dev/null, a FIFO) are written directly.
/// - A new file gets the mode the umask allows; a replaced one keeps its mode and, where permitted, its
///   owner. A file we may not write (chmod a-w) is not replaced.
///
/// Errors are input_output, in the system's words; the old file is then untouched and no temporary is left.
///
/// What can be made again at any time need not wait for the disk: `Keep::until_power_fails` leaves the fsync out.
enum class Keep { always, until_power_fails };
Status write_file(const std::string& path, std::span<const std::byte> bytes, Keep keep = Keep::always);

/// Takes the next bytes of a file. False if they cannot be written: there is no use in going on.
using Sink = std::function<bool(std::span<const std::byte>)>;
/// The same for a file that is made piece by piece, so that it never stands in memory whole. `produce` hands all the
/// pieces to its sink, in order.
Status write_file_in_pieces(const std::string& path, const std::function<void(const Sink&)>& produce,
                            Keep keep = Keep::always);

/// What write_file_in_pieces makes of a path that is no standard output, for those who cannot hand over all pieces in
/// one call. What is not finished leaves nothing behind.
class FileInPieces {
public:
    static Result<FileInPieces> open(const std::string& path, Keep keep = Keep::always);
    FileInPieces(FileInPieces&&) noexcept;
    FileInPieces& operator=(FileInPieces&&) noexcept;
    ~FileInPieces();

    /// False if this piece, or one before, cannot be written.
    bool append(std::span<const std::byte> piece);
    /// Once, at the end: the path names the new file from here on. Tells of the first error of all.
    Status finish();

private:
    struct State;
    FileInPieces();
    std::unique_ptr<State> state_;
};

/// Whether write_file has a chance: the folder is there and can be written, the target is no folder and may
/// be written. To be asked before a long rendering; a full disk shows itself only when written to.
Status check_writable(const std::string& path);

/// Reads a regular file of at most `max_bytes` bytes whole. A folder, FIFO or device is refused, without
/// waiting for its other end (input_output); so is a file that cannot be opened or read. A larger file is
/// bad_input and is refused before memory is taken.
Result<Bytes> read_file(const std::string& path, std::size_t max_bytes);

}  // namespace raster
