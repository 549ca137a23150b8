// flip_rows.cpp: the colour spaces of flip_color.h over packs of pixels.
//
// Packs go by reference: how they are passed by value depends on the instruction set.
#include <raster/image/flip_rows.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>

#if defined(__SSE2__)
#include <emmintrin.h>
#endif

#include <raster/image/dispatch.h>
#include <raster/image/flip_color.h>
#include <raster/image/metrics_display.h>
#include <raster/image/metrics_rows.h>

namespace raster::flip {
namespace {

const ErrorCurve curve;

#if defined(__GNUC__)
using Quad = float __attribute__((vector_size(16)));

template <class P>
RASTER_INLINE void clamp_to_0_1(P& x) {
    x = x > 0.0f ? x : P{};
    x = x < 1.0f ? x : P{} + 1.0f;
}

template <class P>
RASTER_INLINE void respond(P& t) {
    constexpr float delta = 6.0f / 29.0f, bend = delta * delta * delta;
    const P x = t > bend ? t : P{} + bend;
    // The cube root; flip_color.h says why.
    const P third = __builtin_convertvector((IntegersOf<P>)x, P) * (1.0f / 3.0f);
    P z = (P)(0x54a2fa8c - __builtin_convertvector(third, IntegersOf<P>));
    for (int step = 0; step < 2; ++step) {
        const P h = 1.0f - x * z * z * z;
        z = z + z * h * (h * (2.0f / 9.0f) + 1.0f / 3.0f);
    }
    const P root = x * z * z, line = t * (1.0f / (3.0f * delta * delta)) + 4.0f / 29.0f;
    t = t > bend ? root : line;
}

// As in raster/math.h, for what differences of colours can be: their logarithms, and powers of errors, are finite.
template <class P>
RASTER_INLINE void take_log2(P& x) {
    constexpr float smallest = std::numeric_limits<float>::min();
    constexpr std::int32_t sqrt_half = 0x3f3504f3;
    const IntegersOf<P> i = (IntegersOf<P>)(x > smallest ? x : P{} + smallest) - sqrt_half;
    const P e = __builtin_convertvector(i >> 23, P);
    const P f = (P)((i & 0x007fffff) + sqrt_half) - 1.0f;
    const P s = f / (f + 2.0f), s2 = s * s;
    const P p = ((0.431735879f * s2 + 0.576714384f) * s2 + 0.961798848f) * s2 + 2.88539008f;
    x = e + s * p;
}
template <class P>
RASTER_INLINE void take_exp2(P& x) {
    constexpr float shift = 12582912.0f;  // 1.5 * 2^23: the sum's last bits are the nearest whole number
    const P shifted = x + shift, f = x - (shifted - shift);
    const IntegersOf<P> whole = (IntegersOf<P>)shifted - 0x4b400000;
    const P p = (((((1.55946807e-4f * f + 1.34066441e-3f) * f + 9.61769297e-3f) * f + 5.55031055e-2f) * f +
                     2.40226528e-1f) * f + 6.93147215e-1f) * f + 1.0f;
    x = (P)((IntegersOf<P>)p + (whole << 23));
}
#if defined(__SSE2__)
RASTER_INLINE void take_root(Pack<8>& x) {
    const Quad low = __builtin_shufflevector(x, x, 0, 1, 2, 3), high = __builtin_shufflevector(x, x, 4, 5, 6, 7);
    const Quad low_root = (Quad)_mm_sqrt_ps((__m128)low), high_root = (Quad)_mm_sqrt_ps((__m128)high);
    x = __builtin_shufflevector(low_root, high_root, 0, 1, 2, 3, 4, 5, 6, 7);
}
RASTER_INLINE void take_root(Pack<16>& x) {
    Pack<8> low = __builtin_shufflevector(x, x, 0, 1, 2, 3, 4, 5, 6, 7);
    Pack<8> high = __builtin_shufflevector(x, x, 8, 9, 10, 11, 12, 13, 14, 15);
    take_root(low), take_root(high);
    x = __builtin_shufflevector(low, high, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15);
}
#else
RASTER_INLINE void take_root(Pack<8>& x) {
    for (int i = 0; i < 8; ++i) x[i] = std::sqrt(x[i]);
}
#endif
template <class P>
RASTER_INLINE void take_magnitude(P& x) { x = (P)((IntegersOf<P>)x & 0x7fffffff); }
#else
RASTER_INLINE void clamp_to_0_1(float& x) { x = clamp(x, 0.0f, 1.0f); }
RASTER_INLINE void respond(float& t) { t = lab_response(t); }
RASTER_INLINE void take_log2(float& x) { x = raster::log2(x > 0.0f ? x : std::numeric_limits<float>::min()); }
RASTER_INLINE void take_exp2(float& x) { x = raster::exp2(x); }
RASTER_INLINE void take_root(float& x) { x = std::sqrt(x); }
RASTER_INLINE void take_magnitude(float& x) { x = std::abs(x); }
#endif

template <class P>
RASTER_INLINE void multiply(const detail::Matrix& m, P& x, P& y, P& z) {
    const P in[3] = {x, y, z};
    x = in[0] * float(m.m[0][0]) + in[1] * float(m.m[0][1]) + in[2] * float(m.m[0][2]);
    y = in[0] * float(m.m[1][0]) + in[1] * float(m.m[1][1]) + in[2] * float(m.m[1][2]);
    z = in[0] * float(m.m[2][0]) + in[1] * float(m.m[2][1]) + in[2] * float(m.m[2][2]);
}

template <class P>
RASTER_INLINE void load(const Planes& planes, int i, P& a, P& b, P& c) {
    std::memcpy(&a, planes.a + i, sizeof a);
    std::memcpy(&b, planes.b + i, sizeof b);
    std::memcpy(&c, planes.c + i, sizeof c);
}
template <class P>
RASTER_INLINE void store(const Planes& planes, int i, const P& a, const P& b, const P& c) {
    std::memcpy(planes.a + i, &a, sizeof a);
    std::memcpy(planes.b + i, &b, sizeof b);
    std::memcpy(planes.c + i, &c, sizeof c);
}

template <int lanes>
RASTER_INLINE void find_opponents(const Planes& rgb, int count, const Planes& out) {
    for (int i = 0; i < count; i += lanes) {
        Pack<lanes> x, y, z;
        load(rgb, i, x, y, z);
        multiply(detail::to_xyz, x, y, z);
        store(out, i, y, x - y, y - z);
    }
}

// In short loops: of one long one, the steps would wait for each other.
template <int lanes>
RASTER_INLINE void see(const Planes& colors, int count) {
    for (int i = 0; i < count; i += lanes) {
        Pack<lanes> y, red_green, blue_yellow;
        load(colors, i, y, red_green, blue_yellow);
        Pack<lanes> a = y + red_green, b = y, c = y - blue_yellow;
        multiply(detail::to_rgb, a, b, c);
        clamp_to_0_1(a), clamp_to_0_1(b), clamp_to_0_1(c);
        multiply(detail::to_xyz, a, b, c);
        store(colors, i, a, b, c);
    }
    for (float* const plane : {colors.a, colors.b, colors.c})
        for (int i = 0; i < count; i += lanes) {
            Pack<lanes> t;
            std::memcpy(&t, plane + i, sizeof t);
            respond(t);
            std::memcpy(plane + i, &t, sizeof t);
        }
    for (int i = 0; i < count; i += lanes) {
        Pack<lanes> x, y, z;
        load(colors, i, x, y, z);
        const Pack<lanes> l = y * 116.0f - 16.0f;
        store(colors, i, l, (x - y) * 5.0f * l, (y - z) * 2.0f * l);
    }
}

template <class P>
RASTER_INLINE void load(const float* from, P& pack) { std::memcpy(&pack, from, sizeof pack); }
template <class P>
RASTER_INLINE void store(const P& pack, float* to) { std::memcpy(to, &pack, sizeof pack); }

/// The length of the vectors (x[i], y[i]), ...
template <class P>
RASTER_INLINE void take_length(const float* x, const float* y, P& length) {
    P a, b;
    load(x, a), load(y, b);
    length = a * a + b * b;
    take_root(length);
}

template <int lanes>
RASTER_INLINE void find_errors(const SeenRow& e, const SeenRow& a, int count, float* errors, float* scratch) {
    float *const exponents = scratch, *const logarithms = scratch + (count + row_block - 1) / row_block * row_block;
    for (int i = 0; i < count; i += lanes) {
        Pack<lanes> edges, actual_edges, points, actual_points;
        take_length(e.edge_x + i, e.edge_y + i, edges), take_length(a.edge_x + i, a.edge_y + i, actual_edges);
        take_length(e.point_x + i, e.point_y + i, points), take_length(a.point_x + i, a.point_y + i, actual_points);
        edges -= actual_edges, points -= actual_points;
        take_magnitude(edges), take_magnitude(points);
        Pack<lanes> features = (edges > points ? edges : points) * 0.707106781f;
        take_root(features);
        const Pack<lanes> exponent = 1.0f - features;
        store(exponent > 0.0f ? exponent : Pack<lanes>{}, exponents + i);
    }
    for (int i = 0; i < count; i += lanes) {
        Pack<lanes> l, b, c, actual_l, actual_b, actual_c;
        load(e.colors, i, l, b, c);
        load(a.colors, i, actual_l, actual_b, actual_c);
        l -= actual_l, b -= actual_b, c -= actual_c;
        take_magnitude(l);
        Pack<lanes> chroma = b * b + c * c;
        take_root(chroma);
        store(l + chroma, errors + i);
    }
    const float log_knee = curve.log_knee(), log_slope = curve.log_slope(), power = ErrorCurve::power;
    Pack<lanes> largest = Pack<lanes>{} + log_knee;
    for (int i = 0; i < count; i += lanes) {
        Pack<lanes> distance, exponent;
        load(errors + i, distance), load(exponents + i, exponent);
        Pack<lanes> log_error = distance;
        take_log2(log_error);
        log_error *= power;
        store(log_error, logarithms + i);
        largest = log_error > largest ? log_error : largest;
        Pack<lanes> error = (log_error + log_slope) * exponent;
        take_exp2(error);
        store(distance > 0.0f ? error : Pack<lanes>{}, errors + i);
    }
    float most[lanes];
    store(largest, most);
    if (!std::any_of(most, most + lanes, [&](float lane) { return lane > log_knee; })) return;
    const float knee = curve.knee(), slope_beyond = curve.slope_beyond();
    for (int i = 0; i < count; i += lanes) {
        Pack<lanes> log_error, exponent, error;
        load(logarithms + i, log_error), load(exponents + i, exponent), load(errors + i, error);
        Pack<lanes> bent = log_error;
        take_exp2(bent);
        bent = (bent - knee) * slope_beyond + ErrorCurve::at_knee;
        take_log2(bent);
        bent *= exponent;
        take_exp2(bent);
        store(log_error > log_knee ? bent : error, errors + i);
    }
}

template <int>
RASTER_INLINE void find_steps(const float* __restrict errors, int count, std::uint8_t* __restrict steps) {
    for (int i = 0; i < count; ++i) {
        // In 1/65536 of a step, rounded up. Whole numbers, for the sake of compilers.
        std::int32_t bits = 0;
        std::memcpy(&bits, errors + i, sizeof bits);
        const std::int32_t more_than_none = std::int32_t(std::uint32_t(-bits) >> 31);
        const std::int32_t fraction = std::int32_t(errors[i] * float(most_step << 16)) | more_than_none;
        const std::int32_t step = (fraction + 0xffff) >> 16;
        steps[i] = std::uint8_t(step < most_step ? step : most_step);
    }
}

RASTER_DISPATCHED(steps_here, find_steps, (const float* errors, int count, std::uint8_t* steps), (errors, count, steps))
RASTER_DISPATCHED(opponents_here, find_opponents, (const Planes& rgb, int count, const Planes& out), (rgb, count, out))
RASTER_DISPATCHED(see_here, see, (const Planes& colors, int count), (colors, count))
RASTER_DISPATCHED(errors_here, find_errors,
                  (const SeenRow& expected, const SeenRow& actual, int count, float* errors, float* scratch),
                  (expected, actual, count, errors, scratch))

/// The tristimulus values x, y, z of each value of a red, a green and a blue byte. The sum of three is a colour's.
struct ByteTable {
    alignas(16) float of[3][256][4];

    ByteTable() {
        const float* const linear = linear_of_bytes();
        for (int c = 0; c < 3; ++c)
            for (int v = 0; v < 256; ++v)
                for (int i = 0; i < 4; ++i)
                    of[c][v][i] = i < 3 ? linear[v] * float(detail::to_xyz.m[i][c]) : 0.0f;
    }
};

}  // namespace

void opponent_colors(const Planes& rgb, int count, const Planes& out) { opponents_here(rgb, count, out); }
void seen_colors(const Planes& colors, int count) { see_here(colors, count); }

void opponent_colors_of_bytes(const std::uint8_t* rgb, int count, const Planes& out) {
    static const ByteTable table;
#if defined(__GNUC__)
    const auto xyz = [&](const std::uint8_t* p) {
        Quad r, g, b;
        std::memcpy(&r, table.of[0][p[0]], sizeof r);
        std::memcpy(&g, table.of[1][p[1]], sizeof g);
        std::memcpy(&b, table.of[2][p[2]], sizeof b);
        return r + g + b;
    };
    for (int i = 0; i < count; i += 4, rgb += 12) {
        const Quad p = xyz(rgb), q = xyz(rgb + 3), r = xyz(rgb + 6), s = xyz(rgb + 9);
        const Quad xy_pq = __builtin_shufflevector(p, q, 0, 4, 1, 5), xy_rs = __builtin_shufflevector(r, s, 0, 4, 1, 5);
        const Quad z_pq = __builtin_shufflevector(p, q, 2, 6, 3, 7), z_rs = __builtin_shufflevector(r, s, 2, 6, 3, 7);
        const Quad x = __builtin_shufflevector(xy_pq, xy_rs, 0, 1, 4, 5);
        const Quad y = __builtin_shufflevector(xy_pq, xy_rs, 2, 3, 6, 7);
        const Quad z = __builtin_shufflevector(z_pq, z_rs, 0, 1, 4, 5);
        const Quad red_green = x - y, blue_yellow = y - z;
        std::memcpy(out.a + i, &y, sizeof y);
        std::memcpy(out.b + i, &red_green, sizeof y);
        std::memcpy(out.c + i, &blue_yellow, sizeof y);
    }
#else
    for (int i = 0; i < count; ++i, rgb += 3) {
        const auto sum = [&](int k) {
            return table.of[0][rgb[0]][k] + table.of[1][rgb[1]][k] + table.of[2][rgb[2]][k];
        };
        out.a[i] = sum(1), out.b[i] = sum(0) - sum(1), out.c[i] = sum(1) - sum(2);
    }
#endif
}

void errors_between(const SeenRow& expected, const SeenRow& actual, int count, float* errors, float* scratch) {
    errors_here(expected, actual, count, errors, scratch);
}

void steps_of_errors(const float* errors, int count, std::uint8_t* steps) { steps_here(errors, count, steps); }

}  // namespace raster::flip
