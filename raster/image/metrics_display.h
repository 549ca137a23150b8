// metrics_display.h: pictures as a display shows them: what the metrics that model the eye look at.
#pragma once

#include <vector>

#include <raster/image/decode.h>

namespace raster {

/// Row by row access to a picture as light. 8 and 16 bits are sRGB encoded (IEC 61966-2-1), floats are linear and
/// clamped to 0..1; grey stands for all three colours; transparent pixels are blended, encoded, over a grey.
/// Keeps a pointer to the picture.
class Display {
public:
    /// `background` is the grey below transparent pixels, 0 (black) to 1 (white).
    Display(const AnyImage& image, float background);

    int width() const { return width_; }
    int height() const { return height_; }

    /// Linear red, green and blue, 0 to 1, of the pixels x0 to x0 + count - 1 of row y. Beyond the picture, its
    /// edge is repeated.
    void linear_row(int x0, int y, int count, float* red, float* green, float* blue) const;
    /// The same, sRGB encoded.
    void encoded_row(int x0, int y, int count, float* red, float* green, float* blue) const;
    /// The bytes of row y, if pixels are three of them: what linear_row decodes by linear_of_bytes(). Else nullptr. Has the
    /// pixels x0 to x0 + count - 1 of a row that will be asked for soon fetched.
    const std::uint8_t* bytes_row(int x0, int y, int count) const;
    /// Luma, 0 to 1: 0.299 R + 0.587 G + 0.114 B of encoded values (ITU-R BT.601).
    void luma_row(int x0, int y, int count, float* luma) const;

private:
    template <bool linear>
    void row(int x0, int y, int count, float* red, float* green, float* blue) const;

    const AnyImage* image_;
    int width_, height_;
    float background_;
    const float* linear_of_ = nullptr;  ///< sRGB decoding of each sample value; none for floats
    float scale_ = 1;                   ///< a sample times this is 0 to 1
};

/// Linear light of each sRGB encoded byte.
const float* linear_of_bytes();

/// Whether a pixel is not opaque.
bool has_transparency(const AnyImage& image);

}  // namespace raster
