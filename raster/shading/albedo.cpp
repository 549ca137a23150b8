// albedo.cpp: the sum over pairs of directions.
#include <raster/shading/albedo.h>

namespace raster {

glm::vec3 diffuse_albedo(const AnyReflectance& model) {
    // Pairs are counted by their half vector and the angles around it, where highlights are narrow in one variable only:
    // dl dv = 4 cos(theta_d) dh dd. Cells of theta_h grow with its square root, as a measured table's. What the sum gives
    // for Lambert's law divides it, so that white is 1 exactly.
    constexpr int n_h = 32, n_d = 24, n_phi = 16;
    constexpr float half_pi = 1.57079633f;
    const RuntimeModel any{model};
    const glm::vec3 n(0, 0, 1), y(0, 1, 0);
    glm::dvec3 sum(0.0);
    double white = 0;
    for (int i = 0; i < n_h; ++i) {
        const float root = (float(i) + 0.5f) / n_h;
        const float sin_h = sin(root * root * half_pi), cos_h = cos(root * root * half_pi);
        const glm::vec3 h(sin_h, 0, cos_h), x(cos_h, 0, -sin_h);
        for (int j = 0; j < n_d; ++j) {
            const float theta_d = (float(j) + 0.5f) / n_d * half_pi;
            const float sin_d = sin(theta_d), cos_d = cos(theta_d);
            for (int k = 0; k < n_phi; ++k) {
                // Half a turn: the other half has l and v exchanged.
                const float phi = (float(k) + 0.5f) / n_phi * (2 * half_pi);
                const glm::vec3 l = (x * cos(phi) + y * sin(phi)) * sin_d + h * cos_d, v = h * (2 * cos_d) - l;
                if (!(l.z > 0 && v.z > 0)) continue;
                const double weight = double(root * sin_h * sin_d * cos_d) * double(v.z);
                const Reflectance<float> value = any.evaluate(make_frame(n, v, x), l);
                sum += glm::dvec3(value.diffuse) * weight;
                white += double(l.z) * weight;
            }
        }
    }
    return glm::vec3(sum / white);
}

glm::vec3 own_color(const AnyReflectance& model) {
    const bool is_colored = std::visit([]<class M>(const M&) { return has_own_color<M>; }, model);
    return is_colored ? diffuse_albedo(model) : glm::vec3(1.0f);
}

}  // namespace raster
