// diff_files.h: comparing pictures that are files, one pair or the files of two folders by their names.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <raster/image/diff.h>
#include <raster/image/file.h>

namespace raster {

/// One side of a comparison. A picture that is no file has no path.
struct ComparedPicture {
    std::string path;
    Bytes file;                    ///< as read; empty when there is none or it cannot be read
    std::optional<AnyImage> image; ///< nothing when missing or unreadable
};

/// Two pictures, what came of comparing them, and the name that reports give them.
struct Comparison {
    std::string name;
    std::string golden;  ///< the file that approving replaces or makes: the expected one, also when it is missing
    ComparedPicture expected, actual;
    Diff diff;
};

/// Reads and compares two files. What is wrong with a file is a verdict (`unreadable`, `missing`, `added`: the
/// latter two for a path that is ""), not an error. Files of equal bytes are decoded once. Errors as diff_images.
Result<Comparison> diff_files(const std::string& expected_path, const std::string& actual_path,
                              const DiffOptions& options = {});

/// Paths of files of one name; "" where one is missing.
struct FilePair {
    std::string name;    ///< below the folders, with '/'
    std::string golden;  ///< where the expected one is or would be
    std::string expected_path, actual_path;
};

/// All pictures (png, jpg, jpeg, bmp, tga, pgm, ppm, pfm) below two folders, matched by name and sorted by it. Hidden
/// files and folders, and those links that lead to folders, are left out. Errors: input_output for a folder that
/// cannot be read.
Result<std::vector<FilePair>> match_folders(const std::string& expected_folder, const std::string& actual_folder);

}  // namespace raster
