// image_fuzz.cpp: libFuzzer target for the picture decoders: whatever the bytes, no harm, and the same twice.
// Build: clang++ -fsanitize=fuzzer,address,undefined; seeds: tests/fuzz/corpus/image.
#include <cstdlib>
#include <cstring>

#include <raster/image/decode.h>
#include <raster/image/png.h>

namespace {

using raster::Image;

template <class A, class B>
bool same_samples(const Image<A>& a, const Image<B>& b) {
    return sizeof(A) == sizeof(B) && a.width == b.width && a.height == b.height && a.channels == b.channels &&
           std::memcmp(a.samples.data(), b.samples.data(), a.samples.size() * sizeof(A)) == 0;
}

void require(bool condition) {
    if (!condition) std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
    const std::span<const std::byte> file(reinterpret_cast<const std::byte*>(data), size);
    const raster::ImageLimits limits{2048, 1 << 18};
    // Under this name any bytes without a signature are read as TGA.
    const auto first = raster::decode_image(file, "x.tga", limits);
    const auto second = raster::decode_image(file, "x.tga", limits);
    require(bool(first) == bool(second));
    if (!first) {
        require(first.error().message == second.error().message && !first.error().message.empty());
        return 0;
    }
    std::visit([](const auto& a, const auto& b) { require(same_samples(a, b)); }, *first, *second);
    std::visit(
        [&]<class T>(const Image<T>& image) {
            require(image.width > 0 && image.width <= limits.max_side && image.channels <= 4);
            if constexpr (sizeof(T) < 4) {
                const auto again = raster::decode_image(*raster::encode_png(image), "x.png", limits);
                std::visit([&](const auto& decoded) { require(same_samples(image, decoded)); }, *again);
            }
        },
        *first);
    return 0;
}
