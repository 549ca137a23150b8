// file.cpp: whole-file writing and reading on top of POSIX, where fsync and rename keep their promises.
#include <raster/image/file.h>

#include <fcntl.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <limits>
#include <new>
#include <optional>
#include <system_error>
#include <utility>

#include <raster/image/pages.h>

namespace raster {
namespace {

namespace fs = std::filesystem;

Error io_error(const std::string& path, const std::string& doing, int code) {
    return {ErrorKind::input_output, path + ": " + doing + ": " + std::generic_category().message(code)};
}

/// Owns a file descriptor. close() tells of errors, which some file systems report only then.
class Descriptor {
public:
    explicit Descriptor(int fd) : fd_(fd) {}
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    ~Descriptor() {
        if (fd_ >= 0) ::close(fd_);
    }
    int get() const { return fd_; }
    bool is_open() const { return fd_ >= 0; }
    bool close() {
        const int fd = std::exchange(fd_, -1);
        return ::close(fd) == 0 || errno == EINTR;  // after EINTR the descriptor is gone all the same
    }

private:
    int fd_;
};

/// Removes the temporary file unless it was renamed away.
struct Temporary {
    std::string path = {};
    bool kept = false;
    ~Temporary() {
        if (!kept && !path.empty()) ::unlink(path.c_str());
    }
};

bool is_standard_output(const std::string& path) { return path == "-" || path == "/dev/stdout"; }

// write() may take a part only, be interrupted by a signal, or meet a pipe that somebody made non-blocking.
bool write_all(int fd, std::span<const std::byte> bytes) {
    while (!bytes.empty()) {
        const ssize_t written = ::write(fd, bytes.data(), bytes.size());
        if (written > 0) {
            bytes = bytes.subspan(std::size_t(written));
        } else if (written == 0) {
            errno = EIO;
            return false;
        } else if (errno == EAGAIN || errno == EWOULDBLOCK) {
            pollfd ready{fd, POLLOUT, 0};
            if (::poll(&ready, 1, -1) < 0 && errno != EINTR) return false;
        } else if (errno != EINTR) {
            return false;
        }
    }
    return true;
}

// Some file systems know no fsync; then there is nothing to wait for.
bool synchronise(int fd) { return ::fsync(fd) == 0 || errno == EINVAL || errno == ENOTSUP || errno == EROFS; }

/// Where the bytes of a write shall end up.
struct Destination {
    std::string path;                  ///< no symbolic link any more, unless `old` is a special file
    std::optional<struct stat> old;    ///< what is there now
    bool is_regular_or_new() const { return !old || S_ISREG(old->st_mode); }
};

std::string folder_holding(const std::string& path) {
    const std::string folder = fs::path(path).parent_path().string();
    return folder.empty() ? "." : folder;
}

Result<Destination> find_target(const std::string& path) {
    // The system reads up to the first NUL, and would write a file that nobody named.
    if (path.find('\0') != std::string::npos) return io_error(path.c_str(), "cannot write", EINVAL);
    if (path.empty()) return io_error("\"\"", "cannot write", ENOENT);
    Destination target{path, std::nullopt};
    struct stat found {};
    if (::stat(path.c_str(), &found) == 0) {
        target.old = found;
        if (S_ISDIR(found.st_mode)) return io_error(path, "cannot write", EISDIR);
        if (!S_ISREG(found.st_mode)) return target;
    } else if (errno != ENOENT) {
        return io_error(path, "cannot write", errno);
    }
    // Follow links by hand, since the last one may lead to a file that is yet to be made.
    constexpr int most_links = 40;  // as Linux has it
    for (int links = 0; links < most_links; ++links) {
        std::error_code failed;
        const fs::path next = fs::read_symlink(target.path, failed);
        if (failed) return target;
        target.path = (fs::path(folder_holding(target.path)) / next).string();
    }
    return io_error(path, "cannot write", ELOOP);
}

/// A new empty file beside `path`. The name does not grow with the target's, which may be as long as allowed.
int open_temporary(const std::string& path, std::string& temporary_path) {
    static std::atomic<unsigned> counter{0};
    for (int attempt = 0; attempt < 1000; ++attempt) {
        const std::string unique = std::to_string(::getpid()) + "-" + std::to_string(counter++);
        const std::string name = ".raster-" + unique + ".tmp";
        temporary_path = (fs::path(folder_holding(path)) / name).string();
        const int fd = ::open(temporary_path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
        if (fd >= 0 || errno != EEXIST) return fd;
    }
    return -1;
}

// As overwriting would leave them. Only a privileged user may give a file away, so a refusal is no error;
// but then the group is another one and gets no more than everybody.
void keep_owner_and_mode(int fd, const struct stat& old) {
    mode_t mode = old.st_mode & 0777;
    struct stat made {};
    const bool same_owner = ::fstat(fd, &made) == 0 && made.st_uid == old.st_uid && made.st_gid == old.st_gid;
    if (!same_owner && ::fchown(fd, old.st_uid, old.st_gid) != 0) mode &= 0700 | ((mode & 07) << 3) | 07;
    (void)::fchmod(fd, mode);
}

using Produce = std::function<void(const Sink&)>;

/// False with the errno of the first piece that could not be written; those that follow are dropped.
bool write_pieces(int fd, const Produce& produce) {
    int failed = 0;
    produce([&](std::span<const std::byte> piece) {
        if (failed == 0 && !write_all(fd, piece)) failed = errno;
        return failed == 0;
    });
    if (failed != 0) errno = failed;
    return failed == 0;
}

Status write_standard_output(const Produce& produce) {
    // What the program printed before comes first.
    if (std::fflush(stdout) != 0 || !write_pieces(::fileno(stdout), produce))
        return io_error("standard output", "cannot write", errno);
    return Done{};
}

Result<Bytes> read_all(const std::string& path, int fd, std::size_t expected, std::size_t max_bytes) {
    const std::string limit = std::to_string(max_bytes);
    const Error too_large{ErrorKind::bad_input, path + ": larger than the limit of " + limit + " bytes"};
    max_bytes = std::min(max_bytes, std::size_t(std::numeric_limits<std::ptrdiff_t>::max()) - 1);
    if (expected > max_bytes) return too_large;
    // Files in /proc call themselves empty, and a file may grow: ask for one more than expected, to the end.
    Bytes bytes;
    resize_whole(bytes, expected + 1);
    std::size_t filled = 0;
    for (;;) {
        const ssize_t count = ::read(fd, bytes.data() + filled, bytes.size() - filled);
        if (count < 0 && errno == EINTR) continue;
        if (count < 0) return io_error(path, "cannot read", errno);
        if (count == 0) break;
        filled += std::size_t(count);
        if (filled > max_bytes) return too_large;
        if (filled == bytes.size()) bytes.resize(std::min(2 * filled + 4096, max_bytes + 1));
    }
    bytes.resize(filled);
    return bytes;
}

}  // namespace

Status write_file(const std::string& path, std::span<const std::byte> bytes, Keep keep) {
    return write_file_in_pieces(
        path, [&](const Sink& sink) { sink(bytes); }, keep);
}

Status write_file_in_pieces(const std::string& path, const std::function<void(const Sink&)>& produce, Keep keep) {
    if (is_standard_output(path)) return write_standard_output(produce);
    Result<FileInPieces> file = FileInPieces::open(path, keep);
    if (!file) return file.error();
    produce([&](std::span<const std::byte> piece) { return file->append(piece); });
    return file->finish();
}

struct FileInPieces::State {
    std::string path;
    Destination target;
    Keep keep;
    Temporary temporary;  ///< of no name where the target is written directly
    Descriptor file;
    int failed = 0;  ///< the errno of the first piece that could not be written; those that follow are dropped
};

Result<FileInPieces> FileInPieces::open(const std::string& path, Keep keep) {
    Result<Destination> found = find_target(path);
    if (!found) return found.error();
    const Destination& target = *found;
    FileInPieces made;
    if (!target.is_regular_or_new()) {
        const int fd = ::open(path.c_str(), O_WRONLY | O_CLOEXEC | O_NOCTTY);
        if (fd < 0) return io_error(path, "cannot write", errno);
        made.state_.reset(new State{path, target, keep, {}, Descriptor(fd)});
        return made;
    }
    if (target.old && ::faccessat(AT_FDCWD, target.path.c_str(), W_OK, AT_EACCESS) != 0)
        return io_error(path, "cannot write", errno);
    std::string temporary_path;
    const int fd = open_temporary(target.path, temporary_path);
    if (fd < 0) return io_error(path, "cannot write into " + folder_holding(target.path), errno);
    made.state_.reset(new State{path, target, keep, {temporary_path}, Descriptor(fd)});  // from here on ours to remove
    if (target.old) keep_owner_and_mode(fd, *target.old);
    return made;
}

FileInPieces::FileInPieces() = default;
FileInPieces::FileInPieces(FileInPieces&&) noexcept = default;
FileInPieces& FileInPieces::operator=(FileInPieces&&) noexcept = default;
FileInPieces::~FileInPieces() = default;

bool FileInPieces::append(std::span<const std::byte> piece) {
    if (state_->failed == 0 && !write_all(state_->file.get(), piece)) state_->failed = errno;
    return state_->failed == 0;
}

Status FileInPieces::finish() {
    const std::unique_ptr<State> state = std::move(state_);
    const bool is_temporary = !state->temporary.path.empty();
    const bool need_not_wait = state->keep == Keep::until_power_fails || !is_temporary;
    if (state->failed != 0) return io_error(state->path, "cannot write", state->failed);
    if (!(need_not_wait || synchronise(state->file.get())) || !state->file.close())
        return io_error(state->path, "cannot write", errno);
    if (is_temporary && ::rename(state->temporary.path.c_str(), state->target.path.c_str()) != 0)
        return io_error(state->path, "cannot replace", errno);
    state->temporary.kept = true;
    return Done{};
}

Status check_writable(const std::string& path) {
    if (is_standard_output(path)) return Done{};
    const Result<Destination> target = find_target(path);
    if (!target) return target.error();
    const auto may = [](const std::string& name, int mode) {
        return ::faccessat(AT_FDCWD, name.c_str(), mode, AT_EACCESS) == 0;
    };
    if (target->old && !may(target->path, W_OK)) return io_error(path, "cannot write", errno);
    // The slash makes a file in the folder's place an error.
    if (target->is_regular_or_new() && !may(folder_holding(target->path) + "/", W_OK | X_OK))
        return io_error(path, "cannot write into " + folder_holding(target->path), errno);
    return Done{};
}

Result<Bytes> read_file(const std::string& path, std::size_t max_bytes) {
    if (path.find('\0') != std::string::npos) return io_error(path.c_str(), "cannot read", EINVAL);
    // Without O_NONBLOCK, opening a FIFO waits for a writer.
    Descriptor file(::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC | O_NOCTTY));
    struct stat found {};
    if (!file.is_open() || ::fstat(file.get(), &found) != 0) return io_error(path, "cannot read", errno);
    if (S_ISDIR(found.st_mode)) return io_error(path, "cannot read", EISDIR);
    if (!S_ISREG(found.st_mode))
        return Error{ErrorKind::input_output, path + ": cannot read: a device or pipe, not a regular file"};
    try {
        return read_all(path, file.get(), std::size_t(found.st_size), max_bytes);
    } catch (const std::bad_alloc&) {
        return Error{ErrorKind::input_output, path + ": cannot read: not enough memory"};
    }
}

}  // namespace raster
