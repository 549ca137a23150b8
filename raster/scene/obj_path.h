// obj_path.h: which files a model may open: regular ones, inside its own folder.
#pragma once

#include <string>
#include <string_view>

#include <raster/image/file.h>

namespace raster::obj {

/// The folder that a file lies in: "." for a bare name.
std::string folder_of(const std::string& path);

/// Finds the files that a model or its materials name.
class Finder {
public:
    /// `folder` is the model's. What leads out of it is refused unless `allow_outside`.
    Finder(const std::string& folder, bool allow_outside);

    /// The path to open for a name as the file has it, relative to the folder `from`: folder() or one that a path
    /// found earlier lies in. Backslashes count as slashes. Refused without opening anything: names that lead out of
    /// the model's folder, by `..`, an absolute path or a symbolic link; folders, FIFOs, devices. The message is the
    /// part after the name: "not found", "refused: leads out of the model's folder".
    Result<std::string> find(std::string_view name, const std::string& from) const;

    /// The model's folder, absolute and without links.
    const std::string& folder() const { return folder_; }

private:
    std::string folder_;
    bool allow_outside_;
};

}  // namespace raster::obj
