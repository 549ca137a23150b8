// target.cpp: clearing a target and copying its planes out as images.
#include <raster/target.h>

#include <algorithm>
#include <mutex>
#include <utility>

#include <raster/tiles/isolated.h>

namespace raster {

void Target::clear(glm::vec4 color, float depth) {
    pending_ = true;
    pending_color_ = color;
    pending_color8_ = std::uint32_t(pack_rgba8(color));
    pending_depth_ = encode_clear_depth(depth_format_, depth);
}

namespace {
/// One value in a box, cut to the plane; whole rows at one go.
template <class T>
void fill_box(std::vector<T>& plane, int plane_width, int plane_height, int x, int y, int width, int height,
              const T& value) {
    const int columns = std::min(width, plane_width - x);
    int rows = std::min(height, plane_height - y);
    if (columns <= 0 || rows <= 0) return;
    std::size_t run = std::size_t(columns);
    if (columns == plane_width) run *= std::size_t(std::exchange(rows, 1));
    T* p = plane.data() + std::size_t(y) * std::size_t(plane_width) + std::size_t(x);
    for (int row = 0; row < rows; ++row, p += plane_width) std::fill_n(p, run, value);
}
}  // namespace

void Target::write_clear_color(int x, int y, int width, int height) {
    if (color_format_ == ColorFormat::rgba8) {
        fill_box(color8_, width_, height_, x, y, width, height, pending_color8_);
    } else {
        fill_box(color_float_, width_, height_, x, y, width, height, pending_color_);
    }
    for (auto& plane : extra_) fill_box(plane, width_, height_, x, y, width, height, 0.0f);
}

void Target::write_clear_depth(int x, int y, int width, int height) {
    fill_box(depth_, width_, height_, x, y, width, height, pending_depth_);
}

namespace {
std::mutex one_writer;
}

void Target::write_pending_color() {
    const std::lock_guard lock(one_writer);
    if (!pending_) return;
    // A small picture is written before another thread wakes.
    const int rows = pixels() < (std::size_t(1) << 20) ? height_ : tiles::tile_size;
    tiles::isolated_parallel_for(std::size_t((height_ + rows - 1) / rows),
                                 [&](std::size_t i) { write_clear_color(0, int(i) * rows, width_, rows); });
    std::fill(depth_waits_.begin(), depth_waits_.end(), char(1));
    std::atomic_ref(depths_wait_).store(true, std::memory_order_release);
    std::atomic_ref(pending_).store(false, std::memory_order_release);
}

void Target::write_waiting_depths() {
    const std::lock_guard lock(one_writer);
    if (!depths_wait_) return;
    const int tiles_x = tiles::tiles_along(width_);
    for (std::size_t tile = 0; tile < depth_waits_.size(); ++tile)
        if (std::exchange(depth_waits_[tile], char(0)))
            write_clear_depth(int(tile) % tiles_x * tiles::tile_size, int(tile) / tiles_x * tiles::tile_size,
                              tiles::tile_size, tiles::tile_size);
    std::atomic_ref(depths_wait_).store(false, std::memory_order_release);
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
