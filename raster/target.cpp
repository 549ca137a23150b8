// target.cpp: clearing a target and copying its planes out as images.
#include <raster/target.h>

#include <algorithm>

namespace raster {

void Target::clear(glm::vec4 color, float depth) {
    std::fill(color8_.begin(), color8_.end(), std::uint32_t(pack_rgba8(color)));
    std::fill(color_float_.begin(), color_float_.end(), color);
    std::fill(depth_.begin(), depth_.end(), std::uint32_t(encode_depth(depth_format_, depth)));
    for (auto& plane : extra_) std::fill(plane.begin(), plane.end(), 0.0f);
}

glm::vec4 Target::color(int x, int y) const {
    return color_format_ == ColorFormat::rgba8 ? unpack_rgba8(color8_[index(x, y)]) : color_float_[index(x, y)];
}

Image8 Target::color_image() const {
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
    for (std::size_t i = 0; i < pixels(); ++i) image.samples[i] = decode_depth(depth_format_, depth_[i]);
    return image;
}

ImageF Target::extra_image(int channel) const {
    ImageF image(width_, height_, 1);
    image.samples = extra(channel);
    return image;
}

}  // namespace raster
