// deflate_stand_in.cpp: as much of libdeflate as reading PNG files needs, for compilers that have no such library.
#include <libdeflate.h>

extern "C" {

// Where this decompressor fails, the PNG reader leaves files to stb_image.
libdeflate_decompressor* libdeflate_alloc_decompressor(void) {
    static char nothing;
    return reinterpret_cast<libdeflate_decompressor*>(&nothing);
}
void libdeflate_free_decompressor(libdeflate_decompressor*) {}
libdeflate_result libdeflate_zlib_decompress(libdeflate_decompressor*, const void*, size_t, void*, size_t, size_t*) {
    return LIBDEFLATE_BAD_DATA;
}

uint32_t libdeflate_crc32(uint32_t crc, const void* data, size_t count) {
    crc = ~crc;
    for (const auto* byte = static_cast<const unsigned char*>(data); count > 0; --count, ++byte) {
        crc ^= *byte;
        for (int bit = 0; bit < 8; ++bit) crc = (crc >> 1) ^ (0xedb88320u & (0u - (crc & 1)));
    }
    return ~crc;
}
}
