// measured_bake.h: tables made of reflectance models, and tables compressed to their principal components.
#pragma once

#include <span>
#include <vector>

#include <raster/shading/measured_table.h>
#include <raster/shading/models.h>

namespace raster {

/// The BRDF of a model with these kd and ks, at the middle of each cell. Of anisotropic models, which such a table cannot
/// hold, the part where the half vector leans along the grain.
MeasuredTable bake_measured(const AnyReflectance& model, const glm::vec3& kd, const glm::vec3& ks,
                            const MeasuredSize& size = {});

/// Principal components of a set of tables of one size: what a table of the set is made of, most important first, in the
/// logarithm of the BRDF, as the eye compares highlights with what is around them (Matusik et al. 2003).
class MeasuredBasis {
public:
    /// At least one table; all of the size of the first.
    explicit MeasuredBasis(std::span<const MeasuredTable> tables);

    /// At most the number of tables - 1.
    std::size_t components() const { return components_.size(); }
    /// The part of the set's variance that the first `count` components hold, 0 to 1.
    double variance(std::size_t count) const;
    /// How much of each component a table has.
    std::vector<float> project(const MeasuredTable& table) const;
    /// The table of the first `count` of these coefficients.
    MeasuredTable reconstruct(std::span<const float> coefficients, std::size_t count) const;

private:
    MeasuredSize size_;
    std::vector<bool> valid_;  ///< a cell, of any table
    std::vector<float> mean_;
    std::vector<std::vector<float>> components_;  ///< unit length
    std::vector<double> variances_;
};

/// The root mean square difference of two tables of one size over the root mean square of the first, both weighted by
/// cos(theta_l) and over cells that both have: the error that a picture under even light shows.
double relative_error(const MeasuredTable& exact, const MeasuredTable& table);

}  // namespace raster
