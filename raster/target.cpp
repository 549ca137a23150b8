// target.cpp: clearing a target and copying its planes out as images.
#include <raster/target.h>

#include <algorithm>
#include <mutex>

namespace raster {

void Target::clear(glm::vec4 color, float depth) {
    pending_ = true;
    pending_color_ = color;
    pending_color8_ = std::uint32_t(pack_rgba8(color));
    pending_depth_ = encode_clear_depth(depth_format_, depth);
}

void Target::write_clear(std::size_t index, int count) {
    const std::size_t n = std::size_t(count);
    if (color_format_ == ColorFormat::rgba8) {
        std::fill_n(color8_.data() + index, n, pending_color8_);
    } else {
        std::fill_n(color_float_.data() + index, n, pending_color_);
    }
    std::fill_n(depth_.data() + index, n, pending_depth_);
    for (auto& plane : extra_) std::fill_n(plane.data() + index, n, 0.0f);
}

void Target::write_clear_box(int x, int y, int width, int height) {
    const int columns = std::min(width, width_ - x);
    const int rows = std::min(height, height_ - y);
    if (columns <= 0 || rows <= 0) return;
    if (columns == width_) {
        write_clear(index(0, y), columns * rows);
    } else {
        for (int row = 0; row < rows; ++row) write_clear(index(x, y + row), columns);
    }
}

void Target::write_pending_clear() {
    static std::mutex one_writer;
    const std::lock_guard lock(one_writer);
    if (!pending_) return;
    for (int row = 0; row < height_; ++row) write_clear(index(0, row), width_);
    std::atomic_ref(pending_).store(false, std::memory_order_release);
}

glm::vec4 Target::color(int x, int y) const {
    return color_format_ == ColorFormat::rgba8 ? unpack_rgba8(color8()[index(x, y)]) : color_float()[index(x, y)];
}

Image8 Target::color_image() const {
    finished();
    Image8 image(width_, height_, 4);
    for (std::size_t i = 0; i < pixels(); ++i) {
        const std::uint32_t c =
            color_format_ == ColorFormat::rgba8 ? color8_[i] : std::uint32_t(pack_rgba8(color_float_[i]));
        for (int channel = 0; channel < 4; ++channel)
            image.samples[4 * i + std::size_t(channel)] = std::uint8_t(c >> (8 * channel));
    }
    return image;
}

ImageF Target::color_image_float() const {
    ImageF image(width_, height_, 4);
    for (int y = 0; y < height_; ++y)
        for (int x = 0; x < width_; ++x) {
            const glm::vec4 c = color(x, y);
            std::copy_n(&c.x, 4, image.pixel(x, y));
        }
    return image;
}

ImageF Target::depth_image() const {
    ImageF image(width_, height_, 1);
    for (std::size_t i = 0; i < pixels(); ++i) image.samples[i] = decode_depth(depth_format_, depth()[i]);
    return image;
}

ImageF Target::extra_image(int channel) const {
    ImageF image(width_, height_, 1);
    image.samples = extra(channel);
    return image;
}

}  // namespace raster
