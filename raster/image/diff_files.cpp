// diff_files.cpp: both files are read and decoded at once; folders are walked and matched.
#include <raster/image/diff_files.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <filesystem>
#include <map>
#include <new>
#include <system_error>

#include <raster/image/diff_steps.h>
#include <raster/image/pages.h>
#include <raster/tiles/parallel.h>

namespace raster {
namespace {

namespace fs = std::filesystem;

/// Reads, and decodes if the bytes are not those of `same_as`. What is wrong, in words, or "".
std::string read_picture(ComparedPicture& picture) {
    // The largest that load_image reads.
    const std::size_t most = 16 * std::size_t(ImageLimits{}.max_pixels) + (std::size_t(1) << 20);
    Result<Bytes> file = read_file(picture.path, most);
    if (!file) return file.error().message;
    picture.file = std::move(*file);
    return "";
}

std::string decode_picture(ComparedPicture& picture) {
    Result<AnyImage> image = decode_image(picture.file, picture.path);
    if (!image) return image.error().message;
    picture.image = std::move(*image);
    return "";
}

std::string joined(const std::string& a, const std::string& b) { return a + (a.empty() || b.empty() ? "" : "; ") + b; }

void collect(const std::string& folder, std::map<std::string, FilePair>& pairs, std::string FilePair::*side) {
    constexpr std::string_view endings[] = {".png", ".jpg", ".jpeg", ".bmp", ".tga", ".pgm", ".ppm", ".pfm"};
    for (auto entry = fs::recursive_directory_iterator(folder); entry != fs::recursive_directory_iterator(); ++entry) {
        const std::string file_name = entry->path().filename().string();
        if (file_name.starts_with('.')) {
            if (entry->is_directory()) entry.disable_recursion_pending();
            continue;
        }
        std::string ending = entry->path().extension().string();
        for (char& c : ending) c = c >= 'A' && c <= 'Z' ? char(c - 'A' + 'a') : c;
        if (std::find(std::begin(endings), std::end(endings), ending) == std::end(endings) || entry->is_directory())
            continue;
        const std::string name = entry->path().lexically_relative(folder).generic_string();
        pairs[name].name = name;
        pairs[name].*side = entry->path().string();
    }
}

}  // namespace

Result<Comparison> diff_files(const std::string& expected_path, const std::string& actual_path,
                              const DiffOptions& options) try {
    Comparison pair;
    pair.expected.path = expected_path;
    pair.actual.path = actual_path;
    pair.golden = expected_path;
    pair.name = fs::path(expected_path.empty() ? actual_path : expected_path).filename().string();
    ComparedPicture* const sides[2] = {&pair.expected, &pair.actual};
    std::string problems[2];
    tiles::parallel_for(2, [&](std::size_t i) {
        if (!sides[i]->path.empty()) problems[i] = read_picture(*sides[i]);
    });

    std::vector<float> zeros;  // a pixel each
    const bool equal_bytes = !pair.expected.file.empty() && pair.expected.file == pair.actual.file;
    if (equal_bytes) {
        problems[0] = decode_picture(pair.expected);
        pair.actual.image = pair.expected.image;
    } else {
        std::atomic<int> done = 0;
        tiles::parallel_for(2, [&](std::size_t i) {
            if (!sides[i]->path.empty() && problems[i].empty()) problems[i] = decode_picture(*sides[i]);
            // Of two pictures, one is there first: time to get memory for what comes next.
            if (sides[i]->image && done++ == 0) {
                const diff_steps::Shape shape = diff_steps::shape_of(*sides[i]->image);
                resize_whole(zeros, std::size_t(shape.width) * std::size_t(shape.height));
            }
        });
    }
    if (const std::string problem = joined(problems[0], problems[1]); !problem.empty()) {
        pair.diff.verdict = Verdict::unreadable;
        pair.diff.reason = problem;
    } else if (actual_path.empty()) {
        pair.diff.verdict = Verdict::missing;
        pair.diff.reason = "there is no actual picture for " + expected_path;
    } else if (expected_path.empty()) {
        pair.diff.verdict = Verdict::added;
        pair.diff.reason = "there is no expected picture for " + actual_path;
    } else {
        Result<Diff> diff =
            diff_steps::diff_images(*pair.expected.image, *pair.actual.image, options, std::move(zeros));
        if (!diff) return diff.error();
        pair.diff = std::move(*diff);
    }
    return pair;
} catch (const std::bad_alloc&) {
    return Error{ErrorKind::input_output, actual_path + ": not enough memory to compare it"};
}

Result<std::vector<FilePair>> match_folders(const std::string& expected_folder, const std::string& actual_folder) {
    std::map<std::string, FilePair> pairs;
    try {
        collect(expected_folder, pairs, &FilePair::expected_path);
        collect(actual_folder, pairs, &FilePair::actual_path);
    } catch (const fs::filesystem_error& error) {
        return Error{ErrorKind::input_output, error.path1().string() + ": cannot read: " + error.code().message()};
    }
    std::vector<FilePair> sorted;
    for (auto& [name, pair] : pairs) {
        pair.golden = (fs::path(expected_folder) / name).string();
        sorted.push_back(std::move(pair));
    }
    return sorted;
}

}  // namespace raster
