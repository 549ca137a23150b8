// obj_path.cpp: names from a file, resolved and checked before anything is opened.
#include <raster/scene/obj_path.h>

#include <algorithm>
#include <filesystem>
#include <system_error>

namespace raster::obj {
namespace {

namespace fs = std::filesystem;

Error problem(const std::string& text) { return {ErrorKind::bad_input, text}; }

/// Whether `path` lies in or below `folder`; both absolute and in normal form.
bool is_below(const fs::path& path, const fs::path& folder) {
    return std::mismatch(folder.begin(), folder.end(), path.begin(), path.end()).first == folder.end();
}

bool has_drive(std::string_view name) { return name.size() >= 2 && name[1] == ':'; }

}  // namespace

std::string folder_of(const std::string& path) {
    const std::string folder = fs::path(path).parent_path().string();
    return folder.empty() ? "." : folder;
}

Finder::Finder(const std::string& folder, bool allow_outside) : allow_outside_(allow_outside) {
    std::error_code failed;
    folder_ = fs::canonical(folder, failed).string();
    if (failed) folder_ = folder;
}

Result<std::string> Finder::find(std::string_view name, const std::string& from) const {
    constexpr std::size_t longest_name = 4096;  // of a path in Linux
    std::string slashed(name);
    std::replace(slashed.begin(), slashed.end(), '\\', '/');
    if (slashed.empty() || slashed.size() > longest_name || slashed.find('\0') != slashed.npos)
        return problem("not a file name");
    const char* const outside = "refused: leads out of the model's folder";
    if (!allow_outside_ && (slashed.front() == '/' || has_drive(slashed))) return problem(outside);
    const fs::path path = fs::path(from) / slashed;
    if (!allow_outside_ && !is_below(path.lexically_normal(), folder_)) return problem(outside);

    // The name stays inside; now links, which may lead anywhere. Whoever can change the folder between this look
    // and the opening can as well change the files.
    std::error_code failed;
    const fs::path real = fs::canonical(path, failed);
    if (failed == std::errc::no_such_file_or_directory) return problem("not found");
    if (failed) return problem("not found: " + failed.message());
    if (!allow_outside_ && !is_below(real, folder_)) return problem(outside);

    const fs::file_status status = fs::status(real, failed);
    if (fs::is_directory(status)) return problem("refused: a folder");
    if (!fs::is_regular_file(status)) return problem("refused: not a regular file");
    return real.string();
}

}  // namespace raster::obj
