// measured_table.h: a measured BRDF as a table over half and difference angles, in the public MERL file layout.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include <glm/glm.hpp>

#include <raster/result.h>

namespace raster {

/// How many cells an angle has. Cell i of theta_h begins at (i / n)^2 90 degrees, so that highlights are fine; of theta_d
/// at (i / n) 90 degrees; of phi_d at (i / n) 180 degrees, which is all by reciprocity. MERL's is 90 x 90 x 180
/// (Matusik, Pfister, Brand and McMillan, A Data-Driven Reflectance Model, 2003; the angles are Rusinkiewicz's, 1998).
struct MeasuredSize {
    int theta_h = 90, theta_d = 90, phi_d = 180;

    std::size_t cells() const { return std::size_t(theta_h) * std::size_t(theta_d) * std::size_t(phi_d); }
    friend bool operator==(const MeasuredSize&, const MeasuredSize&) = default;
};

/// An isotropic BRDF. Its values stand for the middles of the cells.
struct MeasuredTable {
    MeasuredSize size;
    /// Cell by cell, phi_d fastest: 1 and r, g, b in 1/sr; four zeros where there is no value (below the horizon).
    std::vector<float> samples;

    bool empty() const { return samples.empty(); }
    glm::vec4& at(std::size_t cell) { return reinterpret_cast<glm::vec4&>(samples[4 * cell]); }
    const glm::vec4& at(std::size_t cell) const { return reinterpret_cast<const glm::vec4&>(samples[4 * cell]); }
};

/// The largest number of cells that is read.
inline constexpr std::size_t max_measured_cells = std::size_t(1) << 22;

/// A table from a file's bytes: three 32-bit integers, the size, then all red, all green, all blue values as 64-bit
/// floats, all with the least significant byte first; red times 1500, green 1500 / 1.15, blue 1500 / 1.66. Negative
/// values and NaN mean that there is none. Errors: bad_input.
Result<MeasuredTable> decode_measured(std::span<const std::byte> bytes);
/// The file's bytes; -1 where there is no value.
std::vector<std::byte> encode_measured(const MeasuredTable& table);

Result<MeasuredTable> read_measured(const std::string& path);
Status write_measured(const std::string& path, const MeasuredTable& table);

}  // namespace raster
