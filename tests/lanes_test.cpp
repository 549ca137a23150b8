// Each lane of a pack gets what the scalar gets, bit for bit. Built twice: with the compiler's vectors and without.
#include <raster/lanes.h>

#include <algorithm>
#include <array>
#include <vector>

#include <gtest/gtest.h>

#include "random.h"

namespace {

using namespace raster;
using raster::testing::Random;

constexpr float infinity = std::numeric_limits<float>::infinity();
constexpr float nan = std::numeric_limits<float>::quiet_NaN();

/// Numbers at which implementations part: signed zeros, denormals, halves, the ends of integers and of floats.
const std::vector<float> special = {
    0.0f,         -0.0f,         0.5f,           -0.5f,    1.0f,       -1.0f,      1.5f,       -1.5f,
    2.5f,         -2.5f,         0.1f,           1e-45f,   -1e-45f,    1e-38f,     -1e-38f,    1.17549435e-38f,
    0.49999997f,  -0.49999997f,  3e38f,          -3e38f,   8388607.5f, 8388608.0f, 8388609.0f, 16777215.0f,
    -16777217.0f, 2147483520.0f, -2147483648.0f, 255.5f,   254.5f,     infinity,   -infinity,  nan,
    -nan,         1e-20f,        1e20f,          123456.5f};

float any_float(Random& random) {
    if (random.integer(0, 1)) return special[std::size_t(random.integer(0, int(special.size()) - 1))];
    return as_float(std::int32_t(std::uint32_t(random.bits())));
}
/// A float that fits an integer.
float int_sized(Random& random) {
    for (;;) {
        const float x = random.integer(0, 1) ? any_float(random) : float(random.integer(-2000, 2000)) / 4.0f;
        if (x > -2147483648.0f && x < 2147483648.0f) return x;
    }
}
std::int32_t any_int(Random& random) {
    constexpr std::array ends = {0, 1, -1, 2147483647, -2147483647 - 1, 255, 256, 65536};
    return random.integer(0, 3) ? std::int32_t(std::uint32_t(random.bits()))
                                : ends[std::size_t(random.integer(0, int(ends.size()) - 1))];
}

std::uint32_t bits(float x) { return std::bit_cast<std::uint32_t>(x); }
/// For results of arithmetic, where a NaN is a NaN: whose sign and payload it carries is not defined.
std::uint32_t number_bits(float x) { return x == x ? bits(x) : 0x7fc00000u; }

template <class F>
class Lanes : public ::testing::Test {
protected:
    static constexpr int n = lanes<F>;
    using Floats = std::array<float, n>;
    using Ints = std::array<std::int32_t, n>;

    template <class Make>
    Floats floats(const Make& make) {
        Floats a;
        for (float& x : a) x = make(random);
        return a;
    }
    Ints ints() {
        Ints a;
        for (std::int32_t& x : a) x = any_int(random);
        return a;
    }
    static F pack(const Floats& a) { return load<F>(a.data()); }
    static Int<F> pack(const Ints& a) { return load_int<F>(a.data()); }

    /// on_pack(packs...) against on_scalar(lane of each), for many values.
    template <class OnPack, class OnScalar>
    void same(const OnPack& on_pack, const OnScalar& on_scalar, bool exact_nan = false) {
        for (int round = 0; round < 2000; ++round) {
            const Floats a = floats(any_float), b = floats(any_float);
            const auto result = on_pack(pack(a), pack(b));
            for (int i = 0; i < n; ++i) {
                const float x = a[std::size_t(i)], y = b[std::size_t(i)];
                if constexpr (std::is_same_v<std::remove_cvref_t<decltype(result)>, F>) {
                    const float got = lane(result, i), want = on_scalar(x, y);
                    ASSERT_EQ(exact_nan ? bits(got) : number_bits(got), exact_nan ? bits(want) : number_bits(want))
                        << x << " " << y;
                } else {
                    ASSERT_EQ(lane(result, i), on_scalar(x, y)) << x << " " << y;
                }
            }
        }
    }
    template <class OnPack, class OnScalar>
    void same_ints(const OnPack& on_pack, const OnScalar& on_scalar) {
        for (int round = 0; round < 2000; ++round) {
            const Ints a = ints(), b = ints();
            const auto result = on_pack(pack(a), pack(b));
            for (int i = 0; i < n; ++i) {
                const std::int32_t x = a[std::size_t(i)], y = b[std::size_t(i)];
                ASSERT_EQ(lane(result, i), on_scalar(x, y)) << x << " " << y;
            }
        }
    }

    Random random{42};
};

using Packs = ::testing::Types<FloatPack<4>, FloatPack<8>, FloatPack<16>>;
TYPED_TEST_SUITE(Lanes, Packs);

#define BOTH(expression) [](auto a, [[maybe_unused]] auto b) { return expression; }
#define SAME(expression) this->same(BOTH(expression), BOTH(expression))

TYPED_TEST(Lanes, ArithmeticIsTheScalars) {
    SAME(a + b);
    SAME(a - b);
    SAME(a * b);
    SAME(a / b);
    SAME(a * b + a);  // contraction would show here
    SAME(sqrt(a));
    this->same(BOTH(-a), BOTH(-a), true);
    this->same([](auto a, auto b) { return a += b; }, BOTH(a + b));
    this->same([](auto a, auto b) { return a -= b; }, BOTH(a - b));
    this->same([](auto a, auto b) { return a *= b; }, BOTH(a * b));
    this->same([](auto a, auto b) { return a /= b; }, BOTH(a / b));
}

TYPED_TEST(Lanes, ComparisonsAreTheScalars) {
    SAME(a < b);
    SAME(a <= b);
    SAME(a > b);
    SAME(a >= b);
    SAME(a == b);
    SAME(a != b);
    SAME(a == a);
    SAME(!(a < b));
    SAME((a < b) | (b < a));
    SAME((a <= b) & (b <= a));
}

TYPED_TEST(Lanes, ChoosingKeepsEveryBitOfWhatIsChosen) {
    const auto exact = [this](const auto& on_pack, const auto& on_scalar) { this->same(on_pack, on_scalar, true); };
    exact(BOTH(select(a < b, a, b)), BOTH(select(a < b, a, b)));
    exact(BOTH(raster::min(a, b)), BOTH(a < b ? a : b));
    exact(BOTH(raster::max(a, b)), BOTH(a > b ? a : b));
    exact(BOTH(raster::clamp(a, b, 1.0f)), BOTH(raster::min(raster::max(a, b), 1.0f)));
    exact(BOTH(raster::abs(a)), BOTH(as_float(as_int(a) & 0x7fffffff)));
    exact(BOTH(as_float(as_int(a))), BOTH(a));
}

TEST(LanesScalar, MinAndMaxAreOneComparison) {
    EXPECT_EQ(bits(raster::min(0.0f, -0.0f)), bits(-0.0f));
    EXPECT_EQ(bits(raster::min(-0.0f, 0.0f)), bits(0.0f));
    EXPECT_EQ(raster::min(nan, 1.0f), 1.0f);
    EXPECT_TRUE(std::isnan(raster::min(1.0f, nan)));
    EXPECT_EQ(raster::max(nan, 1.0f), 1.0f);
    EXPECT_EQ(raster::clamp(nan, -2.0f, 3.0f), -2.0f);
    EXPECT_EQ(raster::clamp(7.0f, -2.0f, 3.0f), 3.0f);
}

TYPED_TEST(Lanes, IntegersWrap) {
    const auto wrap = [](std::int64_t x) { return std::int32_t(std::uint32_t(std::uint64_t(x))); };
    using I = Int<TypeParam>;
    const auto wide = [](std::int32_t x) { return std::int64_t(x); };
    this->same_ints([](I a, I b) { return a + b; }, [&](int a, int b) { return wrap(wide(a) + b); });
    this->same_ints([](I a, I b) { return a - b; }, [&](int a, int b) { return wrap(wide(a) - b); });
    this->same_ints([](I a, I b) { return a * b; }, [&](int a, int b) { return wrap(wide(a) * b); });
    this->same_ints(BOTH(a & b), BOTH(a & b));
    this->same_ints(BOTH(a | b), BOTH(a | b));
    this->same_ints(BOTH(a ^ b), BOTH(a ^ b));
    this->same_ints(BOTH(a << 7), BOTH(std::int32_t(std::uint32_t(a) << 7)));
    this->same_ints(BOTH(a >> 7), BOTH(a >> 7));
    this->same_ints(BOTH(a < b), BOTH(a < b));
    this->same_ints(BOTH(a <= b), BOTH(a <= b));
    this->same_ints(BOTH(a > b), BOTH(a > b));
    this->same_ints(BOTH(a >= b), BOTH(a >= b));
    this->same_ints(BOTH(a == b), BOTH(a == b));
    this->same_ints(BOTH(a != b), BOTH(a != b));
    this->same_ints(BOTH(select(a < b, a, b)), BOTH(std::min(a, b)));
    this->same_ints([](I a, I b) { return min(a, b); }, BOTH(std::min(a, b)));
    this->same_ints([](I a, I b) { return max(a, b); }, BOTH(std::max(a, b)));
}

TYPED_TEST(Lanes, ConversionsRoundAsTheyShould) {
    for (int round = 0; round < 5000; ++round) {
        const auto a = this->floats(int_sized);
        const TypeParam p = this->pack(a);
        const auto ints = this->ints();
        for (int i = 0; i < this->n; ++i) {
            const float x = a[std::size_t(i)];
            ASSERT_EQ(lane(truncate_to_int(p), i), std::int32_t(std::trunc(x))) << x;
            ASSERT_EQ(lane(round_to_int(p), i), std::int32_t(std::nearbyint(x))) << x;
            ASSERT_EQ(truncate_to_int(x), std::int32_t(std::trunc(x))) << x;
            ASSERT_EQ(round_to_int(x), std::int32_t(std::nearbyint(x))) << x;
            ASSERT_EQ(lane(floor_to_int(p), i), std::int32_t(std::floor(x))) << x;
            ASSERT_EQ(floor_to_int(x), std::int32_t(std::floor(x))) << x;
            ASSERT_EQ(lane(floor(p), i), std::floor(x)) << x;
            ASSERT_EQ(lane(to_float(this->pack(ints)), i), float(ints[std::size_t(i)]));
        }
    }
    EXPECT_EQ(round_to_int(0.5f), 0);
    EXPECT_EQ(round_to_int(1.5f), 2);
    EXPECT_EQ(round_to_int(2.5f), 2);
    EXPECT_EQ(round_to_int(-2.5f), -2);
    EXPECT_EQ(floor_to_int(-0.25f), -1);
}

TYPED_TEST(Lanes, EveryMaskIsRead) {
    constexpr int n = lanes<TypeParam>;
    for (std::uint32_t m = 0; m < (1u << n); ++m) {
        std::array<std::int32_t, n> ones;
        for (int i = 0; i < n; ++i) ones[std::size_t(i)] = std::int32_t(m >> i & 1);
        const Mask<TypeParam> mask = this->pack(ones) == Int<TypeParam>(1);
        ASSERT_EQ(bitmask(mask), m);
        ASSERT_EQ(any(mask), m != 0);
        ASSERT_EQ(all(mask), m == (1u << n) - 1);
        ASSERT_EQ(bitmask(!mask), ~m & ((1u << n) - 1));
        for (int i = 0; i < n; ++i) ASSERT_EQ(lane(mask, i), bool(m >> i & 1));
    }
    EXPECT_TRUE(all(Mask<TypeParam>(true)));
    EXPECT_FALSE(any(Mask<TypeParam>(false)));
}

TYPED_TEST(Lanes, MemoryIsReadAndWrittenUnaligned) {
    constexpr int n = lanes<TypeParam>;
    std::array<float, n + 3> from, to;
    for (std::size_t i = 0; i < from.size(); ++i) from[i] = any_float(this->random);
    for (std::size_t offset = 0; offset < 3; ++offset) {
        to.fill(7.0f);
        store(&to[offset], load<TypeParam>(&from[offset]));
        for (std::size_t i = 0; i < to.size(); ++i) {
            const bool inside = i >= offset && i < offset + std::size_t(n);
            ASSERT_EQ(bits(to[i]), inside ? bits(from[i]) : bits(7.0f));
        }
        to.fill(7.0f);
        store_int(&to[offset], load_int<TypeParam>(&from[offset]));
        for (std::size_t i = offset; i < offset + std::size_t(n); ++i) ASSERT_EQ(bits(to[i]), bits(from[i]));
    }
    for (int i = 0; i < n; ++i) EXPECT_EQ(lane(lane_index<TypeParam>(), i), i);
    EXPECT_EQ(lane_index<float>(), 0);
}

TYPED_TEST(Lanes, GatherFindsEachLanesOwn) {
    constexpr int n = lanes<TypeParam>;
    std::vector<float> table(400);
    std::vector<std::int32_t> numbers(400);
    for (std::size_t i = 0; i < table.size(); ++i) table[i] = any_float(this->random), numbers[i] = int(i * 7919);
    for (int round = 0; round < 200; ++round) {
        std::array<std::int32_t, n> index;
        for (auto& i : index) i = this->random.integer(0, 99);
        const auto where = this->pack(index);
        TypeParam parts[4];
        gather4(table.data(), where, parts[0], parts[1], parts[2], parts[3]);
        for (int i = 0; i < n; ++i) {
            const std::int32_t at = index[std::size_t(i)];
            ASSERT_EQ(bits(lane(gather(table.data(), where), i)), bits(table[std::size_t(at)]));
            ASSERT_EQ(lane(gather(numbers.data(), where), i), numbers[std::size_t(at)]);
            float scalar[4];
            gather4(table.data(), at, scalar[0], scalar[1], scalar[2], scalar[3]);
            for (int part = 0; part < 4; ++part) {
                ASSERT_EQ(bits(lane(parts[part], i)), bits(table[std::size_t(4 * at + part)]));
                ASSERT_EQ(bits(scalar[part]), bits(table[std::size_t(4 * at + part)]));
            }
        }
    }
}

TYPED_TEST(Lanes, SquaresOfNeighboursAreGathered) {
    constexpr int n = lanes<TypeParam>;
    std::vector<std::int32_t> numbers(500);
    for (std::size_t i = 0; i < numbers.size(); ++i) numbers[i] = int(i * 7919);
    for (const int step : {1, 2, 20, -20}) {
        std::array<std::int32_t, n> index;
        for (auto& i : index) i = this->random.integer(20, 450);
        Int<TypeParam> parts[4];
        gather_square(numbers.data(), this->pack(index), step, parts[0], parts[1], parts[2], parts[3]);
        for (int i = 0; i < n; ++i) {
            const std::int32_t at = index[std::size_t(i)];
            std::int32_t scalar[4];
            gather_square(numbers.data(), at, step, scalar[0], scalar[1], scalar[2], scalar[3]);
            for (int part = 0; part < 4; ++part) {
                const std::int32_t want = numbers[std::size_t(at + part % 2 + part / 2 * step)];
                ASSERT_EQ(lane(parts[part], i), want) << "lane " << i << ", part " << part;
                ASSERT_EQ(scalar[part], want);
            }
        }
    }
}

TYPED_TEST(Lanes, BytesOfIntegersAreTakenOut) {
    constexpr int n = lanes<TypeParam>;
    for (int round = 0; round < 100; ++round) {
        std::array<std::int32_t, n> x;
        for (auto& value : x) value = std::int32_t(std::uint32_t(this->random.bits()));
        const auto bytes_are = [&]<int byte>(std::integral_constant<int, byte>) {
            for (int i = 0; i < n; ++i) {
                const std::int32_t value = x[std::size_t(i)];
                ASSERT_EQ(lane(byte_of<byte>(this->pack(x)), i), int(std::uint32_t(value) >> (8 * byte) & 255));
                ASSERT_EQ(byte_of<byte>(value), int(std::uint32_t(value) >> (8 * byte) & 255));
            }
        };
        bytes_are(std::integral_constant<int, 0>());
        bytes_are(std::integral_constant<int, 1>());
        bytes_are(std::integral_constant<int, 2>());
        bytes_are(std::integral_constant<int, 3>());
    }
}

TYPED_TEST(Lanes, RecordsOfAnyLengthAreGatheredAndScattered) {
    constexpr int n = lanes<TypeParam>;
    std::vector<float> table(100 * 13 + 4);
    for (float& x : table) x = any_float(this->random);
    for (const int stride : {3, 4, 7, 12, 13})
        for (int count = 1; count <= n; ++count) {
            std::array<std::int32_t, n> index;
            for (auto& i : index) i = this->random.integer(0, 99);
            TypeParam parts[4];
            gather4(table.data(), this->pack(index), parts[0], parts[1], parts[2], parts[3], stride);
            std::vector<float> to(std::size_t(n * 13 + 4), 7.0f);
            scatter4(to.data(), count, stride, parts[0], parts[1], parts[2], parts[3]);
            for (int i = n - 1; i >= 0; --i)
                for (int part = 0; part < 4; ++part) {
                    const float want = table[std::size_t(stride * index[std::size_t(i)] + part)];
                    ASSERT_EQ(bits(lane(parts[part], i)), bits(want)) << "lane " << i << ", stride " << stride;
                    // The records of a stride of 3 overlap: the later lane's stays.
                    const bool overwritten = part >= stride && i + 1 < count;
                    if (i < count && !overwritten) {
                        ASSERT_EQ(bits(to[std::size_t(stride * i + part)]), bits(want));
                    }
                }
            for (std::size_t k = std::size_t(stride * (count - 1) + 4); k < to.size(); ++k) ASSERT_EQ(to[k], 7.0f);
        }
}

TEST(LanesOfThisBuild, TriplesAreTakenApart) {
    std::array<std::int32_t, 3 * native_lanes + 1> from;
    for (std::size_t i = 0; i < from.size(); ++i) from[i] = std::int32_t(100 + i);
    for (int offset = 0; offset < 2; ++offset) {
        IntN a, b, c;
        load3(&from[std::size_t(offset)], a, b, c);
        for (int i = 0; i < native_lanes; ++i) {
            EXPECT_EQ(lane(a, i), 100 + offset + 3 * i);
            EXPECT_EQ(lane(b, i), 101 + offset + 3 * i);
            EXPECT_EQ(lane(c, i), 102 + offset + 3 * i);
        }
    }
}

}  // namespace
