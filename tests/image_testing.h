// image_testing.h: what the tests of images share: random pictures, a folder of their own, bytes from text.
#pragma once

#include <stdlib.h>

#include <algorithm>
#include <bit>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <type_traits>

#include <gtest/gtest.h>

#include <raster/image/file.h>
#include <raster/image/image.h>

#include "random.h"

namespace raster::testing {

inline Bytes bytes_of(const std::string& text) {
    Bytes bytes(text.size());
    std::transform(text.begin(), text.end(), bytes.begin(), [](char c) { return std::byte(c); });
    return bytes;
}

inline std::string text_of(const Bytes& bytes) {
    std::string text(bytes.size(), ' ');
    std::transform(bytes.begin(), bytes.end(), text.begin(), [](std::byte b) { return char(b); });
    return text;
}

inline std::string content(const std::string& path) {
    std::ifstream in(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

/// Noise over the whole range of T; floats are any bits but NaN, which equals nothing.
template <class T>
Image<T> random_image(int width, int height, int channels, std::uint64_t seed) {
    Random random(seed);
    Image<T> image(width, height, channels);
    for (T& sample : image.samples) {
        if constexpr (std::is_same_v<T, float>) {
            do sample = std::bit_cast<float>(std::uint32_t(random.bits()));
            while (sample != sample);
        } else {
            sample = T(random.bits());
        }
    }
    return image;
}

/// A folder that lives as long as the test.
class InFolder : public ::testing::Test {
protected:
    void SetUp() override {
        std::string name = (std::filesystem::temp_directory_path() / "raster-test-XXXXXX").string();
        ASSERT_NE(::mkdtemp(name.data()), nullptr);
        folder = name;
        std::filesystem::permissions(folder, std::filesystem::perms(0755));
    }
    void TearDown() override { std::filesystem::remove_all(folder); }

    std::string in_folder(const std::string& name) const { return folder + "/" + name; }
    /// Files in the folder, temporaries that were left behind included.
    std::size_t file_count() const {
        namespace fs = std::filesystem;
        return std::size_t(std::distance(fs::directory_iterator(folder), fs::directory_iterator{}));
    }

    std::string folder;
};

}  // namespace raster::testing
