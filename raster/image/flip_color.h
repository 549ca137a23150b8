// flip_color.h: the colour spaces of FLIP: linear RGB, opponent colours, CIELAB with the Hunt effect, HyAB.
#pragma once

#include <raster/math.h>

namespace raster::flip {

/// Cube root for 2^-100 <= x <= 2^100, relative error below 5e-7.
template <FloatOrPack F>
inline F cube_root(F x) {
    // 1 / cube root needs no division to improve: from a guess by the exponent, 3 % off at most, two steps of third
    // order, z (1 - h)^(-1/3) with h = 1 - x z^3 and the series of that power.
    const F third = to_float(as_int(x)) * (1.0f / 3.0f);
    F z = as_float(Int<F>(0x54a2fa8c) - truncate_to_int(third));
    for (int step = 0; step < 2; ++step) {
        const F h = F(1.0f) - x * z * z * z;
        z = z + z * h * (h * (2.0f / 9.0f) + 1.0f / 3.0f);
    }
    return x * z * z;
}

template <class F>
struct Rgb {
    F r, g, b;
};

/// Tristimulus values relative to those of white (D65): 0 to 1 for colours of the sRGB gamut.
template <class F>
struct RelativeXyz {
    F x, y, z;
};

/// The opponent colours that the eye filters separately. YCxCz of the paper (section 4.1) but for scales, which no
/// filter minds: y = (Y + 16) / 116, red_green = Cx / 500, blue_yellow = Cz / 200.
template <class F>
struct Opponent {
    F y, red_green, blue_yellow;
};

/// CIELAB with a and b scaled by lightness: colours fade in the dark (Hunt, cited in the paper, section 4.1).
template <class F>
struct HuntLab {
    F l, a, b;
};

namespace detail {

struct Matrix {
    double m[3][3];
};

/// Linear sRGB to XYZ, each row divided by white's value, so that white becomes (1, 1, 1).
constexpr Matrix xyz_from_rgb() {
    // IEC 61966-2-1 primaries and D65, as whole ratios; and the white of the FLIP paper's own code.
    Matrix to = {{{10135552.0 / 24577794.0, 8788810.0 / 24577794.0, 4435075.0 / 24577794.0},
                  {2613072.0 / 12288897.0, 8788810.0 / 12288897.0, 887015.0 / 12288897.0},
                  {1425312.0 / 73733382.0, 8788810.0 / 73733382.0, 70074185.0 / 73733382.0}}};
    const double white[3] = {0.950428545, 1.0, 1.088900371};
    for (int i = 0; i < 3; ++i)
        for (double& element : to.m[i]) element /= white[i];
    return to;
}

constexpr Matrix inverse(const Matrix& a) {
    const auto& m = a.m;
    const auto cofactor = [&](int i, int j) {
        const int i1 = (i + 1) % 3, i2 = (i + 2) % 3, j1 = (j + 1) % 3, j2 = (j + 2) % 3;
        return m[i1][j1] * m[i2][j2] - m[i1][j2] * m[i2][j1];
    };
    const double determinant = m[0][0] * cofactor(0, 0) + m[0][1] * cofactor(0, 1) + m[0][2] * cofactor(0, 2);
    Matrix r{};
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) r.m[i][j] = cofactor(j, i) / determinant;
    return r;
}

template <class F>
F row(const Matrix& a, int i, F x, F y, F z) {
    return x * float(a.m[i][0]) + y * float(a.m[i][1]) + z * float(a.m[i][2]);
}

inline constexpr Matrix to_xyz = xyz_from_rgb(), to_rgb = inverse(xyz_from_rgb());

}  // namespace detail

template <class F>
RelativeXyz<F> xyz_from_rgb(const Rgb<F>& c) {
    using detail::row, detail::to_xyz;
    return {row(to_xyz, 0, c.r, c.g, c.b), row(to_xyz, 1, c.r, c.g, c.b), row(to_xyz, 2, c.r, c.g, c.b)};
}

template <class F>
Opponent<F> opponent_from_rgb(const Rgb<F>& c) {
    const RelativeXyz<F> xyz = xyz_from_rgb(c);
    return {xyz.y, xyz.x - xyz.y, xyz.y - xyz.z};
}

/// Filtering can lead out of what a screen shows; the paper clamps it back (section 4.1).
template <class F>
Rgb<F> clamped_rgb_from_opponent(const Opponent<F>& c) {
    using detail::row, detail::to_rgb;
    const F x = c.y + c.red_green, z = c.y - c.blue_yellow;
    return {clamp(row(to_rgb, 0, x, c.y, z), 0.0f, 1.0f), clamp(row(to_rgb, 1, x, c.y, z), 0.0f, 1.0f),
            clamp(row(to_rgb, 2, x, c.y, z), 0.0f, 1.0f)};
}

/// CIELAB's response to a relative tristimulus value.
template <FloatOrPack F>
F lab_response(F t) {
    constexpr float delta = 6.0f / 29.0f;
    const F root = cube_root<F>(max(t, delta * delta * delta));
    return select(t > delta * delta * delta, root, t * (1.0f / (3.0f * delta * delta)) + 4.0f / 29.0f);
}

template <class F>
HuntLab<F> hunt_lab_from_responses(F x, F y, F z) {
    const F l = y * 116.0f - 16.0f;
    return {l, (x - y) * 5.0f * l, (y - z) * 2.0f * l};  // 0.01 L times 500 and 200
}

template <class F>
HuntLab<F> hunt_lab_from_rgb(const Rgb<F>& c) {
    const RelativeXyz<F> xyz = xyz_from_rgb(c);
    return hunt_lab_from_responses(lab_response(xyz.x), lab_response(xyz.y), lab_response(xyz.z));
}

/// Distance that fits large colour differences: lightness by itself, hue and chroma together (Abasi, Tehran,
/// Fairchild: Distance Metrics for Very Large Color Differences, 2020).
template <class F>
F hyab(const HuntLab<F>& p, const HuntLab<F>& q) {
    const F a = p.a - q.a, b = p.b - q.b;
    return abs(p.l - q.l) + sqrt(a * a + b * b);
}

/// Maps a HyAB distance to an error of 0 to 1 (section 4.1): a power for the many small errors, then a bend that
/// gives 95 % of the range to the lower 40 %. 1 is the distance from green to blue.
class ErrorCurve {
public:
    ErrorCurve() {
        const auto lab = [](float r, float g, float b) { return hunt_lab_from_rgb(Rgb<float>{r, g, b}); };
        const float largest = raster::pow(hyab(lab(0, 1, 0), lab(0, 0, 1)), power);
        knee_ = 0.4f * largest;
        log_knee_ = raster::log2(knee_);
        log_slope_ = raster::log2(at_knee / knee_);
        slope_beyond_ = (1.0f - at_knee) / (largest - knee_);
    }

    /// The error of a distance, to the power of `exponent`, which is 0 to 1.
    float to_power(float distance, float exponent) const {
        if (!(distance > 0.0f)) return 0.0f;
        // Below the knee (d^0.7 slope)^exponent takes one logarithm and one power; few colours are beyond.
        const float log_error = raster::log2(distance) * power;
        if (!(log_error > log_knee_)) return raster::exp2((log_error + log_slope_) * exponent);
        const float bent = (raster::exp2(log_error) - knee_) * slope_beyond_ + at_knee;
        return raster::exp2(raster::log2(bent) * exponent);
    }

    static constexpr float power = 0.7f, at_knee = 0.95f;
    float knee() const { return knee_; }
    float log_knee() const { return log_knee_; }
    float log_slope() const { return log_slope_; }
    float slope_beyond() const { return slope_beyond_; }

private:
    float knee_, log_knee_, log_slope_, slope_beyond_;
};

}  // namespace raster::flip
