// texture.cpp: images into packed texels, and the sRGB table.
#include <raster/shading/texture.h>

#include <array>

#include <raster/image/pages.h>
#include <raster/math.h>

namespace raster {

PackedTexture pack_texture(const Image8& image) {
    if (image.empty() || image.width > max_texture_size || image.height > max_texture_size) return {};
    PackedTexture texture{image.width, image.height, {}};
    const std::size_t count = std::size_t(image.width) * std::size_t(image.height);
    resize_whole(texture.texels, count);
    const bool has_color = image.channels >= 3;
    const bool has_alpha = image.channels == 2 || image.channels == 4;
    for (std::size_t i = 0; i < count; ++i) {
        const std::uint8_t* p = image.samples.data() + i * std::size_t(image.channels);
        const std::uint32_t r = p[0], g = p[has_color ? 1 : 0], b = p[has_color ? 2 : 0];
        const std::uint32_t a = has_alpha ? p[image.channels - 1] : 255u;
        texture.texels[i] = std::int32_t(r | g << 8 | b << 16 | a << 24);
    }
    return texture;
}

const float* srgb_decode_table() {
    static const std::array<float, 256> table = [] {
        std::array<float, 256> values;
        for (int i = 0; i < 256; ++i) {
            const float encoded = float(i) / 255.0f;
            values[std::size_t(i)] =
                encoded <= 0.04045f ? encoded / 12.92f : raster::pow((encoded + 0.055f) / 1.055f, 2.4f);
        }
        return values;
    }();
    return table.data();
}

}  // namespace raster
