// measured_table.cpp: MERL files.
#include <raster/shading/measured_table.h>

#include <bit>
#include <cstdint>

#include <raster/image/file.h>

namespace raster {
namespace {

constexpr double scale[3] = {1.0 / 1500.0, 1.15 / 1500.0, 1.66 / 1500.0};
constexpr float largest = 1e6f;  // 1/sr; above it a value is damaged

template <class Integer>
Integer read_little_endian(const std::byte* p) {
    Integer value = 0;
    for (std::size_t i = sizeof value; i-- > 0;) value = Integer(value << 8 | Integer(p[i]));
    return value;
}
template <class Integer>
void append_little_endian(std::vector<std::byte>& out, Integer value) {
    for (std::size_t i = 0; i < sizeof value; ++i) out.push_back(std::byte(value >> 8 * i & 255));
}

}  // namespace

Result<MeasuredTable> decode_measured(std::span<const std::byte> bytes) {
    const auto bad = [](const std::string& what) { return Error{ErrorKind::bad_input, "no MERL table: " + what}; };
    if (bytes.size() < 12) return bad("shorter than its 12 bytes of size");
    std::size_t cells = 1;
    int size[3];
    for (std::size_t i = 0; i < 3; ++i) {
        const std::uint32_t n = read_little_endian<std::uint32_t>(bytes.data() + 4 * i);
        if (n < 1 || n > 4096) return bad("a size of " + std::to_string(n) + " is not from 1 to 4096");
        size[i] = int(n);
        cells *= n;
        if (cells > max_measured_cells) return bad("more than " + std::to_string(max_measured_cells) + " cells");
    }
    const std::size_t expected = 12 + 24 * cells;
    if (bytes.size() < expected)
        return bad(std::to_string(bytes.size()) + " bytes instead of " + std::to_string(expected));

    MeasuredTable table{{size[0], size[1], size[2]}, std::vector<float>(4 * cells)};
    for (std::size_t cell = 0; cell < cells; ++cell) {
        glm::vec4 sample(1.0f);
        for (std::size_t c = 0; c < 3; ++c) {
            const std::byte* p = bytes.data() + 12 + 8 * (c * cells + cell);
            const double value = std::bit_cast<double>(read_little_endian<std::uint64_t>(p)) * scale[c];
            if (!(value >= 0)) sample.x = 0.0f;
            sample[int(c) + 1] = value < double(largest) ? float(value) : largest;
        }
        if (sample.x > 0.0f) table.at(cell) = sample;
    }
    return table;
}

std::vector<std::byte> encode_measured(const MeasuredTable& table) {
    const std::size_t cells = table.size.cells();
    std::vector<std::byte> bytes;
    bytes.reserve(12 + 24 * cells);
    for (const int n : {table.size.theta_h, table.size.theta_d, table.size.phi_d})
        append_little_endian(bytes, std::uint32_t(n));
    for (int c = 0; c < 3; ++c) {
        for (std::size_t cell = 0; cell < cells; ++cell) {
            const glm::vec4& sample = table.at(cell);
            const double value = sample.x > 0.0f ? double(sample[c + 1]) / scale[c] : -1.0;
            append_little_endian(bytes, std::bit_cast<std::uint64_t>(value));
        }
    }
    return bytes;
}

Result<MeasuredTable> read_measured(const std::string& path) {
    const Result<Bytes> bytes = read_file(path, 12 + 24 * max_measured_cells);
    if (!bytes) return bytes.error();
    Result<MeasuredTable> table = decode_measured(*bytes);
    if (!table) return Error{table.error().kind, path + ": " + table.error().message};
    return table;
}

Status write_measured(const std::string& path, const MeasuredTable& table) {
    return write_file(path, encode_measured(table));
}

}  // namespace raster
