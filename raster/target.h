// target.h: what is drawn into: a colour plane, a depth plane and any number of extra float planes.
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <vector>

#include <glm/glm.hpp>

#include <raster/image/image.h>
#include <raster/image/pages.h>
#include <raster/stages/blend.h>
#include <raster/stages/depth.h>
#include <raster/tiles/scratch.h>
#include <raster/tiles/tiling.h>

namespace raster {

/// The largest width or height of a target: 14 bits of pixel and 8 of subpixel keep every tile-local edge value in
/// 32 bits and every edge value below 2^53.
inline constexpr int max_target_size = 16384;

enum class ColorFormat {
    rgba8,  ///< 8 bits a channel; fragments are rounded and blended there, as in OpenGL
    rgba_float,
};

/// A target's scratch memory: made when first used, not copied with it.
class ScratchOwner {
public:
    ScratchOwner() = default;
    ScratchOwner(const ScratchOwner&) {}
    ScratchOwner(ScratchOwner&&) = default;
    ScratchOwner& operator=(const ScratchOwner&) { return *this; }
    ScratchOwner& operator=(ScratchOwner&&) = default;
    tiles::Scratch& operator*() {
        if (!scratch_) scratch_ = std::make_unique<tiles::Scratch>();
        return *scratch_;
    }

private:
    std::unique_ptr<tiles::Scratch> scratch_;
};

/// Planes of one size, rows from top to bottom. The colour plane holds what fragments return, with no transfer curve.
class Target {
public:
    /// 1 <= width, height <= max_target_size. extra_channels float planes are filled by shaders with Outputs.
    Target(int width, int height, ColorFormat color_format = ColorFormat::rgba8,
           DepthFormat depth_format = DepthFormat::unorm24, int extra_channels = 0)
        : width_(width),
          height_(height),
          color_format_(color_format),
          depth_format_(depth_format),
          extra_(std::size_t(extra_channels)) {
        if (color_format == ColorFormat::rgba8) {
            resize_whole(color8_, pixels());
        } else {
            resize_whole(color_float_, pixels());
        }
        resize_whole(depth_, pixels());
        for (auto& plane : extra_) resize_whole(plane, pixels());
        depth_waits_.resize(tiles::tile_count(width, height));
        clear({0, 0, 0, 0});
    }

    int width() const { return width_; }
    int height() const { return height_; }
    ColorFormat color_format() const { return color_format_; }
    DepthFormat depth_format() const { return depth_format_; }
    int extra_channels() const { return int(extra_.size()); }

    /// Colour everywhere, depth (0 near to 1 far) everywhere, 0 in the extra planes.
    void clear(glm::vec4 color, float depth = 1.0f);

    /// The stored planes: colour as r | g << 8 | b << 16 | a << 24, or four floats; depth as encode_depth gives it. After a
    /// clear or a draw they are whole only when asked for anew: what a clear leaves is written when someone looks.
    std::vector<std::uint32_t>& color8() { return finished().color8_; }
    std::vector<glm::vec4>& color_float() { return finished().color_float_; }
    std::vector<std::uint32_t>& depth() { return finished_depth().depth_; }
    std::vector<float>& extra(int channel) { return finished().extra_[std::size_t(channel)]; }
    const std::vector<std::uint32_t>& color8() const { return finished().color8_; }
    const std::vector<glm::vec4>& color_float() const { return finished().color_float_; }
    const std::vector<std::uint32_t>& depth() const { return finished_depth().depth_; }
    const std::vector<float>& extra(int channel) const { return finished().extra_[std::size_t(channel)]; }

    std::size_t index(int x, int y) const { return std::size_t(y) * std::size_t(width_) + std::size_t(x); }
    /// The colour of one pixel, 0 to 1 a channel for rgba8.
    glm::vec4 color(int x, int y) const;
    /// The depth of one pixel, 0 near to 1 far.
    float depth(int x, int y) const { return decode_depth(depth_format_, depth()[index(x, y)]); }

    /// Copies as images: RGBA (floats are clamped and rounded as rgba8 would be), RGBA float, depth as one channel.
    Image8 color_image() const;
    ImageF color_image_float() const;
    ImageF depth_image() const;
    ImageF extra_image(int channel) const;

    // For the tile drivers: a clear is only noted, and written by the next draw with the tiles that it writes anyway, or
    // by whoever looks first. The raw planes may therefore still hold what was there before. Depths that a clear leaves in
    // tiles where nothing is drawn are not written before someone looks at depths.
    bool clear_is_pending() const { return pending_; }
    std::uint32_t pending_depth() const { return pending_depth_; }
    void write_clear_color(int x, int y, int width, int height);
    void write_clear_depth(int x, int y, int width, int height);
    char& depth_waits(std::size_t tile) { return depth_waits_[tile]; }
    void clear_was_written() {
        depths_wait_ = depths_wait_ || pending_;
        pending_ = false;
    }
    std::uint32_t* raw_color8() { return color8_.data(); }
    glm::vec4* raw_color_float() { return color_float_.data(); }
    std::int32_t* raw_depth() { return reinterpret_cast<std::int32_t*>(depth_.data()); }
    const std::int32_t* raw_depth() const { return reinterpret_cast<const std::int32_t*>(depth_.data()); }
    std::uint32_t* raw_depth_bits() { return depth_.data(); }
    float* raw_extra(int channel) { return extra_[std::size_t(channel)].data(); }
    tiles::Scratch& scratch() { return *scratch_; }

private:
    std::size_t pixels() const { return std::size_t(width_) * std::size_t(height_); }
    /// This target with nothing pending but depths. Several threads may look at once, and the first writes the clear.
    Target& finished() {
        if (std::atomic_ref(pending_).load(std::memory_order_acquire)) write_pending_color();
        return *this;
    }
    const Target& finished() const { return const_cast<Target*>(this)->finished(); }
    Target& finished_depth() {
        finished();
        if (std::atomic_ref(depths_wait_).load(std::memory_order_acquire)) write_waiting_depths();
        return *this;
    }
    const Target& finished_depth() const { return const_cast<Target*>(this)->finished_depth(); }
    void write_pending_color();
    void write_waiting_depths();

    int width_, height_;
    ColorFormat color_format_;
    DepthFormat depth_format_;
    std::vector<std::uint32_t> color8_;
    std::vector<glm::vec4> color_float_;
    std::vector<std::uint32_t> depth_;
    std::vector<std::vector<float>> extra_;
    bool pending_ = false;
    bool depths_wait_ = false;       ///< some of these may be set
    std::vector<char> depth_waits_;  ///< a tile: its depths are pending_depth_, and not written yet; void while pending_
    glm::vec4 pending_color_{0.0f};
    std::uint32_t pending_color8_ = 0;
    std::uint32_t pending_depth_ = 0;
    ScratchOwner scratch_;
};

}  // namespace raster
