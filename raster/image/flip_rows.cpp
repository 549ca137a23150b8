// flip_rows.cpp: the colour spaces of flip_color.h over packs of pixels.
//
// Packs go by reference: how they are passed by value depends on the instruction set.
#include <raster/image/flip_rows.h>

#include <cstdint>
#include <cstring>

#include <raster/image/dispatch.h>
#include <raster/image/flip_color.h>

namespace raster::flip {
namespace {

#if defined(__GNUC__)
using IntegerPack = std::int32_t __attribute__((vector_size(4 * pack_size)));

RASTER_INLINE void clamp_to_0_1(Pack& x) {
    x = x > 0.0f ? x : Pack{};
    x = x < 1.0f ? x : Pack{} + 1.0f;
}

RASTER_INLINE void respond(Pack& t) {
    constexpr float delta = 6.0f / 29.0f, bend = delta * delta * delta;
    const Pack x = t > bend ? t : Pack{} + bend;
    // The cube root; flip_color.h says why.
    const Pack third = __builtin_convertvector((IntegerPack)x, Pack) * (1.0f / 3.0f);
    Pack z = (Pack)(0x54a2fa8c - __builtin_convertvector(third, IntegerPack));
    for (int step = 0; step < 2; ++step) {
        const Pack h = 1.0f - x * z * z * z;
        z = z + z * h * (h * (2.0f / 9.0f) + 1.0f / 3.0f);
    }
    const Pack root = x * z * z, line = t * (1.0f / (3.0f * delta * delta)) + 4.0f / 29.0f;
    t = t > bend ? root : line;
}
#else
RASTER_INLINE void clamp_to_0_1(float& x) { x = clamp(x, 0.0f, 1.0f); }
RASTER_INLINE void respond(float& t) { t = lab_response(t); }
#endif

RASTER_INLINE void multiply(const detail::Matrix& m, Pack& x, Pack& y, Pack& z) {
    const Pack in[3] = {x, y, z};
    x = in[0] * float(m.m[0][0]) + in[1] * float(m.m[0][1]) + in[2] * float(m.m[0][2]);
    y = in[0] * float(m.m[1][0]) + in[1] * float(m.m[1][1]) + in[2] * float(m.m[1][2]);
    z = in[0] * float(m.m[2][0]) + in[1] * float(m.m[2][1]) + in[2] * float(m.m[2][2]);
}

RASTER_INLINE void load(const Planes& planes, int i, Pack& a, Pack& b, Pack& c) {
    std::memcpy(&a, planes.a + i, sizeof a);
    std::memcpy(&b, planes.b + i, sizeof b);
    std::memcpy(&c, planes.c + i, sizeof c);
}
RASTER_INLINE void store(const Planes& planes, int i, const Pack& a, const Pack& b, const Pack& c) {
    std::memcpy(planes.a + i, &a, sizeof a);
    std::memcpy(planes.b + i, &b, sizeof b);
    std::memcpy(planes.c + i, &c, sizeof c);
}

RASTER_INLINE void find_opponents(const Planes& rgb, int count, const Planes& out) {
    for (int i = 0; i < count; i += pack_size) {
        Pack x, y, z;
        load(rgb, i, x, y, z);
        multiply(detail::to_xyz, x, y, z);
        store(out, i, y, x - y, y - z);
    }
}

// In short loops: of one long one, the steps would wait for each other.
RASTER_INLINE void see(const Planes& colors, int count) {
    for (int i = 0; i < count; i += pack_size) {
        Pack y, red_green, blue_yellow;
        load(colors, i, y, red_green, blue_yellow);
        Pack a = y + red_green, b = y, c = y - blue_yellow;
        multiply(detail::to_rgb, a, b, c);
        clamp_to_0_1(a), clamp_to_0_1(b), clamp_to_0_1(c);
        multiply(detail::to_xyz, a, b, c);
        store(colors, i, a, b, c);
    }
    for (float* const plane : {colors.a, colors.b, colors.c})
        for (int i = 0; i < count; i += pack_size) {
            Pack t;
            std::memcpy(&t, plane + i, sizeof t);
            respond(t);
            std::memcpy(plane + i, &t, sizeof t);
        }
    for (int i = 0; i < count; i += pack_size) {
        Pack x, y, z;
        load(colors, i, x, y, z);
        const Pack l = y * 116.0f - 16.0f;
        store(colors, i, l, (x - y) * 5.0f * l, (y - z) * 2.0f * l);
    }
}

RASTER_DISPATCHED(opponents_here, find_opponents, (const Planes& rgb, int count, const Planes& out), (rgb, count, out))
RASTER_DISPATCHED(see_here, see, (const Planes& colors, int count), (colors, count))

}  // namespace

void opponent_colors(const Planes& rgb, int count, const Planes& out) { opponents_here(rgb, count, out); }
void seen_colors(const Planes& colors, int count) { see_here(colors, count); }

}  // namespace raster::flip
