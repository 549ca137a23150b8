// math.h: powers, logarithms and angles that give the same bits on every machine.
//
// The C library's sin, exp and pow differ between versions and even between processors, so whatever decides a
// picture uses these instead. They are made of + - * /, sqrt, comparisons and bit operations only, in an
// order written down here; a lane of a pack gets exactly what the scalar gets. The polynomials are minimax
// fits (Remez), the reductions the classic ones (Cody and Waite, Software Manual for the Elementary
// Functions, 1980). The errors in the comments are bounds over dense sweeps against the C library's long
// double; tests/math_test.cpp holds them.
//
// In a shader write `raster::pow(x, y)` with the namespace: for F = float a bare `pow` may find the C
// library's.
#pragma once

#include <initializer_list>
#include <limits>

#include <raster/lanes.h>

namespace raster {

/// float or a pack of floats.
template <class F>
concept FloatOrPack = requires { typename detail::Companions<F>::Int; };

// ------------------------------------------------------------------------------------- powers and logarithms

/// 2 to the power of x, relative error at most 1.2e-7. Below x = -126 the result is 0 (no denormals), from x
/// = 128 on infinity; whole x are exact; NaN gives NaN.
template <FloatOrPack F>
inline F exp2(F x) {
    // The clamp keeps the conversion to an integer in range, for NaN too; its ends give 0 and infinity by
    // themselves.
    const F c = clamp(x, -127.0f, 128.0f);
    const Int<F> whole = round_to_int(c);
    const F f = c - to_float(whole);  // exact, in [-1/2, 1/2]
    const F p = (((((F(1.55946807e-4f) * f + 1.34066441e-3f) * f + 9.61769297e-3f) * f + 5.55031055e-2f) * f +
                  2.40226528e-1f) * f + 6.93147215e-1f) * f + 1.0f;
    const F scaled = as_float(as_int(p) + (whole << 23));  // p * 2^whole, by its exponent field
    return select(x != x, x, select(x < -126.0f, 0.0f, scaled));
}

/// Logarithm to base 2, relative error at most 2.3e-7 (also near x = 1, where the result is near 0). Below
/// 2^-126 (0 and denormals) the result is -infinity; infinity gives infinity; a negative x or NaN gives NaN.
template <FloatOrPack F>
inline F log2(F x) {
    constexpr float smallest = std::numeric_limits<float>::min();
    constexpr float largest = std::numeric_limits<float>::max();
    constexpr float infinity = std::numeric_limits<float>::infinity();
    constexpr float nan = std::numeric_limits<float>::quiet_NaN();
    constexpr std::int32_t sqrt_half = 0x3f3504f3;  // the bits of sqrt(1/2)

    // x = m * 2^e with m in [sqrt(1/2), sqrt(2)), so that e + log2(m) never cancels.
    const Int<F> i = as_int(clamp(x, smallest, largest)) - sqrt_half;
    const F e = to_float(i >> 23);
    const F f = as_float((i & 0x007fffff) + sqrt_half) - 1.0f;  // m - 1, exact
    // log(m) = 2 artanh(s) with s = (m - 1)/(m + 1), an odd series in s.
    const F s = f / (f + 2.0f);
    const F s2 = s * s;
    const F p = ((F(0.431735879f) * s2 + 0.576714384f) * s2 + 0.961798848f) * s2 + 2.88539008f;
    const F finite = e + s * p;
    const F outside = select(x > largest, x, select(x >= 0.0f, F(-infinity), F(nan)));
    return select((x >= smallest) & (x <= largest), finite, outside);
}

/// x to the power of y, for x >= 0. Relative error at most 1.6e-7 + 1.8e-7 |log2 of the result|: 2e-6 where 8
/// bits can show it, 2e-5 down to 1e-36. pow(x, 0) = 1 for every x, pow(0, y > 0) = 0, pow(1, y) = 1; results
/// below 2^-126 are 0 and a denormal x counts as 0. No NaN for x >= 0 and finite y; a negative x gives NaN.
template <FloatOrPack F>
inline F pow(F x, std::type_identity_t<F> y) {
    return select(y == 0.0f, 1.0f, exp2(y * log2(x)));
}

/// x to the power of an exponent that all pixels share, as specular exponents are. A whole exponent from 1 to 256 is
/// multiplied out (Knuth, The Art of Computer Programming, 4.6.3): several times as fast, for every x, and of a relative
/// error at most exponent * 6e-8. Other exponents are pow's.
template <FloatOrPack F>
inline F pow_shared(F x, float exponent) {
    if (!(exponent >= 1.0f && exponent <= 256.0f && float(int(exponent)) == exponent)) return pow(x, F(exponent));
    const std::uint32_t whole = std::uint32_t(exponent);
    F r = x;
    for (std::uint32_t bit = std::bit_floor(whole) >> 1; bit; bit >>= 1) {
        r = r * r;
        if (whole & bit) r = r * x;
    }
    return r;
}

/// e to the power of x, relative error at most (2 + |x|) * 8e-8. Results below 2^-126 are 0, above float's
/// range infinity.
template <FloatOrPack F>
inline F exp(F x) { return exp2(x * 1.44269504f); }

// ---------------------------------------------------------------------------------------------------- angles

namespace detail {

/// sin and cos of r + quadrant * pi/2, before the quadrant is put right. |r| <= pi/4.
template <class F>
struct Reduced {
    F sin, cos;
    Int<F> quadrant;
};

template <class F>
inline Reduced<F> reduce_angle(F x) {
    const F c = clamp(x, -8192.0f, 8192.0f);
    const Int<F> quadrant = round_to_int(c * 0.636619772f);
    const F n = to_float(quadrant);
    // pi/2 in three parts; the first two have 11 bits, so n times them is exact.
    const F r = ((c - n * 1.5703125f) - n * 4.83751297e-4f) - n * 7.54978942e-8f;
    const F r2 = r * r;
    const F s = ((F(-1.95152827e-4f) * r2 + 8.33216076e-3f) * r2 - 1.66666546e-1f) * r2 * r + r;
    const F k = ((F(2.44331571e-5f) * r2 - 1.38873163e-3f) * r2 + 4.16666456e-2f) * r2 * r2;
    return {s, k - r2 * 0.5f + 1.0f, quadrant};
}

template <class F>
inline F negate_if_bit_1(F x, Int<F> i) {
    return as_float(as_int(x) ^ ((i & 2) << 30));
}

/// NaN for NaN and infinity, else value.
template <class F>
inline F unless_not_finite(F x, F value) {
    const auto finite = abs(x) <= std::numeric_limits<float>::max();
    return select(finite, value, std::numeric_limits<float>::quiet_NaN());
}

}  // namespace detail

/// Sine of x in radians, absolute error at most 8e-8 for |x| <= 8192. Beyond, x is clamped to that.
template <FloatOrPack F>
inline F sin(F x) {
    const auto [s, c, quadrant] = detail::reduce_angle(x);
    const F value = select((quadrant & 1) != 0, c, s);
    return detail::unless_not_finite(x, detail::negate_if_bit_1<F>(value, quadrant));
}

/// Cosine of x in radians, absolute error at most 8e-8 for |x| <= 8192. Beyond, x is clamped to that.
template <FloatOrPack F>
inline F cos(F x) {
    const auto [s, c, quadrant] = detail::reduce_angle(x);
    const F value = select((quadrant & 1) != 0, s, c);
    return detail::unless_not_finite(x, detail::negate_if_bit_1<F>(value, quadrant + 1));
}

/// Tangent of x in radians, for |x| <= 8192: the exact tangent of some x' with |x' - x| <= 1.2e-7, and for
/// |x| <= 1.5 also within a relative error of 2.2e-7. Beyond, x is clamped.
template <FloatOrPack F>
inline F tan(F x) {
    const auto [s, c, quadrant] = detail::reduce_angle(x);
    const auto odd = (quadrant & 1) != 0;
    return detail::unless_not_finite<F>(x, select(odd, -c, s) / select(odd, s, c));
}

/// The angle of the point (x, y) in radians, in [-pi, pi], absolute error at most 3e-7; (0, 0) gives 0.
template <FloatOrPack F>
inline F atan2(F y, std::type_identity_t<F> x) {
    const F ax = abs(x), ay = abs(y);
    const F larger = max(ax, ay);
    const F t = min(ax, ay) / select(larger > 0.0f, larger, 1.0f);
    const F u = t * t;
    const F p = ((((((F(2.92069511e-3f) * u - 1.63679384e-2f) * u + 4.32118773e-2f) * u - 7.55221546e-2f) *
                   u + 1.06660053e-1f) * u - 1.42110556e-1f) * u + 1.99937731e-1f) * u - 3.33331525e-1f;
    const F first = p * u * t + t;  // atan(t), t in [0, 1]
    const F half = select(ay > ax, F(1.57079633f) - first, first);
    const F whole = select(x < 0.0f, F(3.14159265f) - half, half);
    return select(y < 0.0f, -whole, whole);
}

/// Arc cosine of x in [-1, 1] in radians, absolute error at most 3.1e-7; x is clamped to that range.
template <FloatOrPack F>
inline F acos(F x) {
    const F a = min(abs(x), 1.0f);
    // Near 1, acos(a) = 2 asin(sqrt((1 - a)/2)) keeps the digits that 1 - a has.
    const auto near_one = a > 0.5f;
    const F u = select(near_one, (F(1.0f) - a) * 0.5f, a * a);
    const F t = select(near_one, sqrt(u), a);
    const F p = (((F(4.21663374e-2f) * u + 2.41794959e-2f) * u + 4.54703793e-2f) * u + 7.49529749e-2f) * u +
                1.66667521e-1f;
    const F asin = p * u * t + t;
    const F positive = select(near_one, asin * 2.0f, F(1.57079633f) - asin);
    return select(x < 0.0f, F(3.14159265f) - positive, positive);
}

// --------------------------------------------------------------------------- angles in degrees, for matrices

/// Sine and cosine of one angle.
struct SinCos {
    double sin, cos;
};

/// Both of an angle in degrees, in double precision, absolute error at most 2e-16 for |degrees| <= 1e6, and
/// exact at multiples of 90. Matrices and models are made with it and rounded to float at the end. |degrees|
/// < 1e11 is asked.
inline SinCos sin_cos_degrees(double degrees) {
    constexpr double radians_per_degree = 0.017453292519943295;
    const double turns = degrees / 90.0;
    const auto quadrant = static_cast<long long>(turns < 0.0 ? turns - 0.5 : turns + 0.5);
    const double r = (degrees - double(quadrant) * 90.0) * radians_per_degree;  // the difference is exact
    const double r2 = r * r;
    // The Taylor series, 1/n! each: at 45 degrees the next term is below 1e-17.
    double s = -7.647163731819816e-13;
    for (double k : {1.6059043836821613e-10, -2.505210838544172e-08, 2.7557319223985893e-06,
                     -1.984126984126984e-04, 8.333333333333333e-03, -1.6666666666666666e-01}) {
        s = s * r2 + k;
    }
    s = s * r2 * r + r;
    double c = 4.779477332387385e-14;
    for (double k : {-1.1470745597729725e-11, 2.08767569878681e-09, -2.755731922398589e-07,
                     2.48015873015873e-05, -1.388888888888889e-03, 4.1666666666666664e-02}) {
        c = c * r2 + k;
    }
    c = (c * r2 - 0.5) * r2 + 1.0;
    switch (quadrant & 3) {
        case 0: return {s, c};
        case 1: return {c, -s};
        case 2: return {-s, -c};
        default: return {-c, s};
    }
}

/// Tangent of an angle in degrees, in double precision. |degrees| < 1e11 is asked; 90 gives infinity.
inline double tan_degrees(double degrees) {
    const auto [s, c] = sin_cos_degrees(degrees);
    return s / c;
}

}  // namespace raster
