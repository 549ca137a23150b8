// display.h: from the light that was computed to the bytes that a screen wants: exposure and the sRGB transfer.
//
// All shading is done on linear values. The empirical models put them on the screen as they are, clamped at 1; that is
// the plain display. What is meant as radiance goes through the transfer function of sRGB (IEC 61966-2-1), the
// inverse of which textures went through when they were painted.
#pragma once

#include <glm/glm.hpp>

#include <raster/math.h>
#include <raster/shading/models.h>
#include <raster/target.h>

namespace raster {

struct Display {
    bool srgb = false;      ///< encode; else the plain values
    float exposure = 0.0f;  ///< in stops: every one doubles the light before it is encoded and clamped

    bool is_plain() const { return !srgb && exposure == 0.0f; }
};

/// The encoded value of linear light, 0 to 1 each; below 0 and NaN give 0, above 1 gives 1.
inline float srgb_encode(float linear) {
    const float x = linear > 0.0f ? min(linear, 1.0f) : 0.0f;
    return x <= 0.0031308f ? x * 12.92f : 1.055f * pow(x, 1.0f / 2.4f) - 0.055f;
}
inline float srgb_decode(float encoded) {
    const float x = encoded > 0.0f ? min(encoded, 1.0f) : 0.0f;
    return x <= 0.04045f ? x / 12.92f : pow((x + 0.055f) / 1.055f, 2.4f);
}

/// What a screen makes of a channel of light, before the clamp.
inline float shown_value(float light, const Display& display) {
    const float value = light * exp2(display.exposure);
    return display.srgb ? srgb_encode(value) : value;
}

/// Multiplies the light of a float target by 2^exposure; alpha stays.
void expose(Target& target, float exposure);

/// What is seen of a float target's light, as bytes. `exposure` and the transfer function are applied, then the clamp.
Target displayed(const Target& light, const Display& display);

/// The light that is shown as the given colour, so that a background looks as it was asked for.
glm::vec4 light_for(const glm::vec4& shown, const Display& display);

/// Whether a model is one of those that imitate a look, and are shown plainly: Lambert, Phong, Blinn-Phong.
inline bool is_empirical(const AnyReflectance& model) {
    return std::visit(
        []<class M>(const M&) {
            return std::is_same_v<M, Lambert> || std::is_same_v<M, Phong> || std::is_same_v<M, BlinnPhong>;
        },
        model);
}

}  // namespace raster
