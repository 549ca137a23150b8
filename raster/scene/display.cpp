// display.cpp: exposure and transfer, pixel by pixel.
#include <raster/scene/display.h>

#include <raster/stages/blend.h>

namespace raster {

void expose(Target& target, float exposure) {
    const float factor = exp2(exposure);
    for (glm::vec4& color : target.color_float()) color = glm::vec4(glm::vec3(color) * factor, color.a);
}

Target displayed(const Target& light, const Display& display) {
    Target picture(light.width(), light.height(), ColorFormat::rgba8);
    std::vector<std::uint32_t>& bytes = picture.color8();
    const std::vector<glm::vec4>& colors = light.color_float();
    const float factor = exp2(display.exposure);
    for (std::size_t i = 0; i < bytes.size(); ++i) {
        glm::vec4 color = colors[i];
        for (int c = 0; c < 3; ++c) {
            color[c] *= factor;
            if (display.srgb) color[c] = srgb_encode(color[c]);
        }
        bytes[i] = std::uint32_t(pack_rgba8(color));
    }
    return picture;
}

glm::vec4 light_for(const glm::vec4& shown, const Display& display) {
    glm::vec4 light = shown;
    for (int c = 0; c < 3; ++c)
        light[c] = (display.srgb ? srgb_decode(shown[c]) : shown[c]) * exp2(-display.exposure);
    return light;
}

}  // namespace raster
