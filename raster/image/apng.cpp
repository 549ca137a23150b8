// apng.cpp: PNG files taken apart into chunks and put together as frames.
#include <raster/image/apng.h>

#include <libdeflate.h>

#include <algorithm>
#include <cstring>
#include <string_view>

#include <raster/image/png.h>

namespace raster {
namespace {

constexpr std::size_t signature_size = 8;

void put32(Bytes& out, std::uint32_t value) {
    for (const int shift : {24, 16, 8, 0}) out.push_back(std::byte(value >> shift & 255));
}

std::uint32_t get32(const std::byte* in) {
    std::uint32_t value = 0;
    for (int i = 0; i < 4; ++i) value = value << 8 | std::uint32_t(in[i]);
    return value;
}

void put_chunk(Bytes& out, std::string_view type, const Bytes& data) {
    put32(out, std::uint32_t(data.size()));
    const std::size_t start = out.size();
    for (const char c : type) out.push_back(std::byte(c));
    out.insert(out.end(), data.begin(), data.end());
    put32(out, libdeflate_crc32(0, out.data() + start, out.size() - start));
}

/// Calls visit(type, data) for the chunks of a PNG file that encode_png has made.
template <class Visit>
void for_each_chunk(const Bytes& png, const Visit& visit) {
    for (std::size_t at = signature_size; at + 12 <= png.size();) {
        const std::size_t size = get32(&png[at]);
        const std::string_view type(reinterpret_cast<const char*>(&png[at + 4]), 4);
        visit(type, Bytes(png.begin() + std::ptrdiff_t(at + 8), png.begin() + std::ptrdiff_t(at + 8 + size)));
        at += 12 + size;
    }
}

/// The whole picture, shown for a time, replacing what was there.
Bytes frame_control(std::uint32_t sequence, const Image8& frame, int milliseconds) {
    Bytes data;
    for (const std::uint32_t value : {sequence, std::uint32_t(frame.width), std::uint32_t(frame.height), 0u, 0u})
        put32(data, value);
    for (const int value : {milliseconds, 1000})
        for (const int shift : {8, 0}) data.push_back(std::byte(value >> shift & 255));
    data.push_back(std::byte(0));
    data.push_back(std::byte(0));
    return data;
}

}  // namespace

Result<Bytes> encode_apng(std::span<const Image8> frames, int milliseconds) {
    if (frames.empty()) return Error{ErrorKind::usage, "an animation needs a frame"};
    const auto alike = [&](const Image8& f) {
        return f.width == frames[0].width && f.height == frames[0].height && f.channels == frames[0].channels;
    };
    if (!std::ranges::all_of(frames, alike))
        return Error{ErrorKind::usage, "the frames of an animation differ in size"};
    const int delay = std::clamp(milliseconds, 1, 65535);
    Bytes out;
    std::uint32_t sequence = 0;
    for (std::size_t i = 0; i < frames.size(); ++i) {
        const Result<Bytes> png = encode_png(frames[i]);
        if (!png) return png.error();
        if (i == 0) out.assign(png->begin(), png->begin() + signature_size);
        bool controlled = false;
        for_each_chunk(*png, [&](std::string_view type, const Bytes& data) {
            if (type == "IDAT") {
                if (!controlled) put_chunk(out, "fcTL", frame_control(sequence++, frames[i], delay));
                controlled = true;
                if (i == 0) return put_chunk(out, type, data);
                Bytes numbered;
                put32(numbered, sequence++);
                numbered.insert(numbered.end(), data.begin(), data.end());
                return put_chunk(out, "fdAT", numbered);
            }
            if (i > 0 || type == "IEND") return;
            put_chunk(out, type, data);
            if (type != "IHDR") return;
            Bytes control;
            put32(control, std::uint32_t(frames.size()));
            put32(control, 0);
            put_chunk(out, "acTL", control);
        });
    }
    put_chunk(out, "IEND", {});
    return out;
}

}  // namespace raster
