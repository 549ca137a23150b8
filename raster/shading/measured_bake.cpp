// measured_bake.cpp: directions from half and difference angles; eigenvectors by Eigen.
#include <raster/shading/measured_bake.h>

#include <algorithm>
#include <cmath>

#include <Eigen/Eigenvalues>

#include <raster/tiles/parallel.h>

namespace raster {
namespace {

constexpr float pi = 3.14159265f;
constexpr float log_floor = 1e-3f;  // 1/sr: darker differences do not count

/// l and v of a cell, above the normal +z, the half vector in the plane of x and z.
struct Directions {
    glm::vec3 l, v;
};
Directions directions_of(const MeasuredSize& size, int i, int j, int k) {
    const float root = (float(i) + 0.5f) / float(size.theta_h);
    const float theta_h = root * root * (pi / 2), theta_d = (float(j) + 0.5f) / float(size.theta_d) * (pi / 2);
    const float phi_d = (float(k) + 0.5f) / float(size.phi_d) * pi;
    const float sin_h = sin(theta_h), cos_h = cos(theta_h), sin_d = sin(theta_d), cos_d = cos(theta_d);
    const glm::vec3 h(sin_h, 0, cos_h), x(cos_h, 0, -sin_h), y(0, 1, 0);
    const glm::vec3 l = (x * cos(phi_d) + y * sin(phi_d)) * sin_d + h * cos_d;
    return {l, h * (2 * cos_d) - l};
}

std::vector<float> logarithms(const MeasuredTable& table) {
    const std::size_t cells = table.size.cells();
    std::vector<float> out(3 * cells);
    for (std::size_t cell = 0; cell < cells; ++cell)
        for (int c = 0; c < 3; ++c) out[3 * cell + std::size_t(c)] = log2(table.at(cell)[c + 1] + log_floor);
    return out;
}

double dot(const std::vector<float>& a, const std::vector<float>& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += double(a[i]) * double(b[i]);
    return sum;
}

}  // namespace

MeasuredTable bake_measured(const AnyReflectance& model, const glm::vec3& kd, const glm::vec3& ks,
                            const MeasuredSize& size) {
    MeasuredTable table{size, std::vector<float>(4 * size.cells())};
    const RuntimeModel any{model};
    tiles::parallel_for(std::size_t(size.theta_h), [&](std::size_t i) {
        for (int j = 0; j < size.theta_d; ++j) {
            for (int k = 0; k < size.phi_d; ++k) {
                const auto [l, v] = directions_of(size, int(i), j, k);
                if (!(l.z > 0 && v.z > 0)) continue;
                const auto frame = make_frame(glm::vec3(0, 0, 1), v, glm::vec3(1, 0, 0));
                const Reflectance<float> value = any.evaluate(frame, l);
                const glm::vec3 f = (value.diffuse * kd + value.specular * ks) / (pi * l.z);
                const std::size_t cell =
                    (i * std::size_t(size.theta_d) + std::size_t(j)) * std::size_t(size.phi_d) + std::size_t(k);
                table.at(cell) = {1.0f, f.x, f.y, f.z};
            }
        }
    });
    return table;
}

MeasuredBasis::MeasuredBasis(std::span<const MeasuredTable> tables) : size_(tables[0].size) {
    const std::size_t cells = size_.cells();
    valid_.resize(cells);
    mean_.resize(3 * cells);
    std::vector<std::vector<float>> rows;
    for (const MeasuredTable& table : tables) {
        for (std::size_t i = 0; i < cells; ++i) valid_[i] = valid_[i] || table.at(i).x > 0.0f;
        rows.push_back(logarithms(table));
        for (std::size_t i = 0; i < mean_.size(); ++i) mean_[i] += rows.back()[i] / float(tables.size());
    }
    for (std::vector<float>& row : rows)
        for (std::size_t i = 0; i < row.size(); ++i) row[i] -= mean_[i];

    // There are far fewer tables than cells: the eigenvectors of the small matrix of products give those of the large
    // one of covariances.
    const auto n = Eigen::Index(rows.size());
    Eigen::MatrixXd products(n, n);
    for (Eigen::Index i = 0; i < n; ++i)
        for (Eigen::Index j = 0; j <= i; ++j)
            products(i, j) = products(j, i) = dot(rows[std::size_t(i)], rows[std::size_t(j)]);
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(products);
    for (Eigen::Index k = n - 1; k > 0; --k) {
        const double eigenvalue = solver.eigenvalues()(k);
        if (!(eigenvalue > 1e-9 * solver.eigenvalues()(n - 1)) || !(eigenvalue > 0)) break;
        std::vector<float> component(3 * cells);
        for (Eigen::Index i = 0; i < n; ++i) {
            const auto share = float(solver.eigenvectors()(i, k) / std::sqrt(eigenvalue));
            for (std::size_t c = 0; c < component.size(); ++c) component[c] += share * rows[std::size_t(i)][c];
        }
        components_.push_back(std::move(component));
        variances_.push_back(eigenvalue);
    }
}

double MeasuredBasis::variance(std::size_t count) const {
    double part = 0, all = 0;
    for (std::size_t k = 0; k < variances_.size(); ++k) (k < count ? part : all) += variances_[k];
    all += part;
    return all > 0 ? part / all : 1.0;
}

std::vector<float> MeasuredBasis::project(const MeasuredTable& table) const {
    std::vector<float> row = logarithms(table), coefficients;
    for (std::size_t i = 0; i < row.size(); ++i) row[i] -= mean_[i];
    for (const std::vector<float>& component : components_) coefficients.push_back(float(dot(row, component)));
    return coefficients;
}

MeasuredTable MeasuredBasis::reconstruct(std::span<const float> coefficients, std::size_t count) const {
    std::vector<float> row = mean_;
    for (std::size_t k = 0; k < std::min({count, coefficients.size(), components_.size()}); ++k)
        for (std::size_t i = 0; i < row.size(); ++i) row[i] += coefficients[k] * components_[k][i];
    MeasuredTable table{size_, std::vector<float>(4 * size_.cells())};
    for (std::size_t cell = 0; cell < size_.cells(); ++cell) {
        if (!valid_[cell]) continue;
        const auto value = [&](std::size_t c) { return max(exp2(row[3 * cell + c]) - log_floor, 0.0f); };
        table.at(cell) = {1.0f, value(0), value(1), value(2)};
    }
    return table;
}

double relative_error(const MeasuredTable& exact, const MeasuredTable& table) {
    double difference = 0, all = 0;
    std::size_t cell = 0;
    for (int i = 0; i < exact.size.theta_h; ++i) {
        for (int j = 0; j < exact.size.theta_d; ++j) {
            for (int k = 0; k < exact.size.phi_d; ++k, ++cell) {
                if (exact.at(cell).x == 0.0f || table.at(cell).x == 0.0f) continue;
                const double weight = double(directions_of(exact.size, i, j, k).l.z);
                for (int c = 1; c < 4; ++c) {
                    const double a = double(exact.at(cell)[c]) * weight, b = double(table.at(cell)[c]) * weight;
                    difference += (a - b) * (a - b);
                    all += a * a;
                }
            }
        }
    }
    return all > 0 ? std::sqrt(difference / all) : 0.0;
}

}  // namespace raster
