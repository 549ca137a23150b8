// opengl_models.cpp: a page of GLSL a model.
#include "opengl_models.h"

namespace raster::tool {
namespace {

const char* const lambert = R"(
void reflect_light(vec3 n, vec3 v, vec3 t, vec3 b, vec3 l, out vec3 diffuse, out vec3 specular) {
    diffuse = vec3(dot(n, l));
    specular = vec3(0.0);
}
)";

const char* const phong = R"(
uniform float exponent;
void reflect_light(vec3 n, vec3 v, vec3 t, vec3 b, vec3 l, out vec3 diffuse, out vec3 specular) {
    vec3 r = 2.0 * dot(n, l) * n - l;
    diffuse = vec3(dot(n, l));
    specular = vec3(dot(r, v) > 0.0 ? pow(dot(r, v), exponent) : 0.0);
}
)";

const char* const blinn_phong = R"(
uniform float exponent;
void reflect_light(vec3 n, vec3 v, vec3 t, vec3 b, vec3 l, out vec3 diffuse, out vec3 specular) {
    float n_h = dot(n, normalize(l + v));
    diffuse = vec3(dot(n, l));
    specular = vec3(n_h > 0.0 ? pow(n_h, exponent) : 0.0);
}
)";

// Fresnel's amplitudes, perpendicular and parallel, with the index n + ik of one channel; complex numbers are vec2.
const char* const fresnel = R"(
uniform vec3 index, extinction;
vec2 times(vec2 a, vec2 b) { return vec2(a.x * b.x - a.y * b.y, a.x * b.y + a.y * b.x); }
float share(float c, float n, float k) {
    if (k == 0.0) {
        float inside = sqrt(1.0 - (1.0 - c * c) / (n * n));
        float s = (c - n * inside) / (c + n * inside), p = (n * c - inside) / (n * c + inside);
        return 0.5 * (s * s + p * p);
    }
    vec2 n2 = times(vec2(n, k), vec2(n, k)), z = n2 - vec2(1.0 - c * c, 0.0);
    vec2 root = vec2(sqrt(max(0.5 * (length(z) + z.x), 0.0)), sqrt(max(0.5 * (length(z) - z.x), 0.0)));
    vec2 s1 = vec2(c, 0.0) - root, s2 = vec2(c, 0.0) + root, p1 = n2 * c - root, p2 = n2 * c + root;
    return 0.5 * (dot(s1, s1) / dot(s2, s2) + dot(p1, p1) / dot(p2, p2));
}
vec3 fresnel(float c) {
    return vec3(share(c, index.x, extinction.x), share(c, index.y, extinction.y), share(c, index.z, extinction.z));
}
)";

// Mirrors in grooves: pi times F G D / (4 pi (n l)(n v)) times n l; D without its pi.
const char* const grooves = R"(
uniform float slope, spread_constant, brightness;
uniform float beckmann;
float distribution(float n_h) {
    if (beckmann > 0.0) return exp((n_h * n_h - 1.0) / (n_h * n_h * slope * slope)) / pow(slope * n_h * n_h, 2.0);
    float alpha = atan(sqrt(max(1.0 - n_h * n_h, 0.0)), n_h);
    return spread_constant * exp(-alpha * alpha / (slope * slope));
}
float facets(vec3 n, vec3 v, vec3 l) {
    vec3 h = normalize(l + v);
    float n_l = dot(n, l), n_v = dot(n, v), n_h = dot(n, h), v_h = dot(v, h);
    if (n_v <= 0.0) return 0.0;
    float masked = min(1.0, min(2.0 * n_h * n_v / v_h, 2.0 * n_h * n_l / v_h));
    return brightness * masked * distribution(n_h) / (4.0 * n_v);
}
)";

const char* const microfacet = R"(
void reflect_light(vec3 n, vec3 v, vec3 t, vec3 b, vec3 l, out vec3 diffuse, out vec3 specular) {
    diffuse = vec3(dot(n, l));
    specular = fresnel(dot(v, normalize(l + v))) * facets(n, v, l);
}
)";

const char* const oren_nayar = R"(
uniform float sigma;
void reflect_light(vec3 n, vec3 v, vec3 t, vec3 b, vec3 l, out vec3 diffuse, out vec3 specular) {
    float s2 = sigma * sigma, a = 1.0 - 0.5 * s2 / (s2 + 0.33), b1 = 0.45 * s2 / (s2 + 0.09);
    float n_l = dot(n, l), n_v = max(dot(n, v), 0.0);
    float sin_l = length(l - n * n_l), sin_v = length(v - n * n_v);
    float cos_phi = (dot(l, v) - n_l * n_v) / max(sin_l * sin_v, 1e-12);
    float high = min(n_l, n_v), low = max(n_l, n_v);
    float sines = sqrt(max(1.0 - high * high, 0.0)) * sqrt(max(1.0 - low * low, 0.0)) / low;
    diffuse = vec3(n_l * (a + b1 * max(cos_phi, 0.0) * sines));
    specular = vec3(0.0);
}
)";

const char* const ward = R"(
uniform float along, across, bounded;
void reflect_light(vec3 n, vec3 v, vec3 t, vec3 b, vec3 l, out vec3 diffuse, out vec3 specular) {
    vec3 h = l + v;
    float n_l = dot(n, l), n_v = dot(n, v), n_h = dot(n, h);
    vec2 grain = vec2(dot(t, h) / along, dot(b, h) / across);
    float lobe = exp(-dot(grain, grain) / (n_h * n_h)) / (along * across);
    diffuse = vec3(n_l);
    lobe *= bounded > 0.0 ? dot(h, h) / pow(n_h, 4.0) : 0.25 / sqrt(n_l * max(n_v, 1e-6));
    specular = vec3(n_v > 0.0 ? lobe * n_l : 0.0);
}
)";

const char* const velvet = R"(
uniform float slope;
void reflect_light(vec3 n, vec3 v, vec3 t, vec3 b, vec3 l, out vec3 diffuse, out vec3 specular) {
    float n_l = dot(n, l), n_v = dot(n, v), n_h = dot(n, normalize(l + v));
    float cos2 = n_h * n_h, sin2 = max(1.0 - cos2, 1e-4), m2 = slope * slope;
    float d = (1.0 + 4.0 * exp(-cos2 / (sin2 * m2)) / (sin2 * sin2)) / (1.0 + 4.0 * m2);
    diffuse = vec3(n_l);
    specular = vec3(n_v > 0.0 ? n_l * d / (4.0 * (n_l + n_v - n_l * n_v)) : 0.0);
}
)";

const char* const subsurface = R"(
uniform vec3 scattering, absorption;
uniform float index_below;
float share(float c) {
    float inside = sqrt(1.0 - (1.0 - c * c) / (index_below * index_below));
    float s = (c - index_below * inside) / (c + index_below * inside);
    float p = (index_below * c - inside) / (index_below * c + inside);
    return 0.5 * (s * s + p * p);
}
void reflect_light(vec3 n, vec3 v, vec3 t, vec3 b, vec3 l, out vec3 diffuse, out vec3 specular) {
    float n_l = dot(n, l), n_v = dot(n, v), n1 = index_below;
    diffuse = specular = vec3(0.0);
    if (n_v <= 0.0) return;
    float f_dr = -1.440 / (n1 * n1) + 0.710 / n1 + 0.668 + 0.0636 * n1, a = (1.0 + f_dr) / (1.0 - f_dr);
    vec3 albedo = scattering / (scattering + absorption), root = sqrt(3.0 * (1.0 - albedo));
    vec3 r_d = 0.5 * albedo * (1.0 + exp(-4.0 / 3.0 * a * root)) * exp(-root);
    float below_l = sqrt(1.0 - (1.0 - n_l * n_l) / (n1 * n1)), below_v = sqrt(1.0 - (1.0 - n_v * n_v) / (n1 * n1));
    diffuse = (1.0 - share(n_l)) * (1.0 - share(n_v)) * n_l * (r_d + albedo / (4.0 * (below_l + below_v)));
    specular = vec3(share(dot(v, normalize(l + v))) * facets(n, v, l));
}
)";

// z0 by Newton's method, from the right; 1 - erf by Abramowitz and Stegun 7.1.28; the series summed, not expanded.
const char* const he_torrance = R"(
uniform float sigma, tau, cos_source;
uniform vec3 wavelength;
const float pi = 3.14159265;
float erfc(float x) {
    float p = 1.0 + x * (0.0705230784 + x * (0.0422820123 + x * (0.0092705272 +
              x * (0.0001520143 + x * (0.0002765672 + x * 0.0000430638)))));
    p *= p, p *= p, p *= p;
    return 1.0 / (p * p);
}
float cotangent(float c) { return c / sqrt(max(1.0 - c * c, 1e-8)); }
float seen(float c) {
    float x = max(cotangent(c) * tau / (2.0 * sigma), 1e-9);
    return (1.0 - 0.5 * erfc(x)) / (1.0 + 0.5 * max(exp(-x * x) / (x * sqrt(pi)) - erfc(x), 0.0));
}
float hidden_slopes(float c) { return erfc(cotangent(c) * tau / (2.0 * sigma)) / cotangent(c); }
void reflect_light(vec3 n, vec3 v, vec3 t, vec3 b, vec3 l, out vec3 diffuse, out vec3 specular) {
    float n_l = dot(n, l), n_v = dot(n, v);
    diffuse = vec3(n_l);
    specular = vec3(0.0);
    if (n_v <= 0.0) return;
    vec3 h = l + v;
    float y = 0.25 * sqrt(2.0 / pi) * (hidden_slopes(n_l) + hidden_slopes(n_v)), x = sqrt(2.0 * log(1.0 + y));
    for (int i = 0; i < 12; ++i) x -= (x - y * exp(-0.5 * x * x)) / (1.0 + x * x);
    float height = sigma / sqrt(1.0 + x * x), n_h = n_l + n_v, aside = dot(h - n * n_h, h - n * n_h);
    vec3 f = fresnel(0.5 * length(h));
    float bent = dot(h, h) / n_h, geometry = bent * bent, visible = seen(n_l) * seen(n_v);
    bool mirror = dot(2.0 * n_l * n - l, v) >= cos_source;
    for (int c = 0; c < 3; ++c) {
        float k = 2.0 * pi / wavelength[c], phase = k * height * n_h, g = phase * phase, reach = 0.25 * k * k * tau * tau;
        float weight = exp(-g), sum = 0.0;
        for (int m = 1; m <= 100; ++m) {
            weight *= g / float(m);
            sum += weight / float(m) * exp(-reach * aside / float(m));
        }
        float directional = geometry * 0.25 * reach * sum / n_v;
        float sharp = mirror ? exp(-g) / (2.0 * (1.0 - cos_source)) : 0.0;
        specular[c] = f[c] * visible * (directional + sharp);
    }
}
)";

// Fibres and varnish over reflect_base. n = 1.5; Beckmann's facets.
const char* const layers = R"(
uniform vec3 base_specular;
uniform float fibres, varnish, varnish_slope;
float taken(float c) {
    float s = sqrt(c);
    return fibres * (0.985 - 0.961 * s - 0.502 * c + 0.524 * c * s);
}
float varnished(float c) {
    float inside = sqrt(1.0 - (1.0 - c * c) / 2.25);
    float s = (c - 1.5 * inside) / (c + 1.5 * inside), p = (1.5 * c - inside) / (1.5 * c + inside);
    return varnish * 0.5 * (s * s + p * p);
}
void reflect_light(vec3 n, vec3 v, vec3 t, vec3 b, vec3 l, out vec3 diffuse, out vec3 specular) {
    reflect_base(n, v, t, b, l, diffuse, specular);
    vec3 h = normalize(l + v);
    float n_l = dot(n, l), n_v = dot(n, v), n_h = dot(n, h), v_h = dot(v, h), seen = max(n_v, 0.0);
    float glow = 0.0, gloss = 0.0;
    if (n_v > 0.0) {
        float tan2 = (1.0 - n_h * n_h) / (n_h * n_h), d = exp(-tan2 / (varnish_slope * varnish_slope));
        d /= varnish_slope * varnish_slope * pow(n_h, 4.0);
        glow = fibres * 0.75 * pow(1.0 - n_h * n_h, 2.0) * n_l / (n_l + n_v - n_l * n_v);
        gloss = varnished(v_h) * d * min(1.0, min(2.0 * n_h * n_v / v_h, 2.0 * n_h * n_l / v_h)) / (4.0 * n_v);
    }
    float below_fibres = (1.0 - taken(n_l)) * (1.0 - taken(seen));
    float below_varnish = (1.0 - varnished(n_l)) * (1.0 - varnished(seen));
    diffuse *= below_fibres * below_varnish;
    specular = (specular * base_specular * below_fibres + glow) * below_varnish + gloss;
}
)";

using Uniforms = std::vector<std::pair<std::string, std::variant<float, glm::vec3>>>;

/// c of the Gaussian distribution, by numbers: its projected facets add up to pi, those beyond 90 degrees too.
float gaussian_constant(double m) {
    double integral = 0;
    constexpr int steps = 4000;
    for (int i = 0; i < steps; ++i) {
        const double alpha = (i + 0.5) / steps * 6 * m;
        integral +=
            exp(float(-(alpha / m) * (alpha / m))) * sin_cos_degrees(2 * alpha * 57.29577951308232).sin * 6 * m / steps;
    }
    return float(1 / integral);
}

Uniforms of_facets(float m, bool beckmann, float brightness) {
    return {{"slope", m}, {"beckmann", beckmann ? 1.0f : 0.0f}, {"spread_constant", gaussian_constant(double(m))},
            {"brightness", brightness}};
}

Uniforms with_fresnel(const Fresnel& f, Uniforms others) {
    others.emplace_back("index", f.n);
    others.emplace_back("extinction", f.k);
    return others;
}

GlslModel glsl(const Lambert&) { return {lambert, {}}; }
GlslModel glsl(const Phong& m) { return {phong, {{"exponent", m.exponent}}}; }
GlslModel glsl(const BlinnPhong& m) {
    return {blinn_phong, {{"exponent", m.convention == BlinnPhong::Exponent::alpha ? m.exponent : m.exponent / 4}}};
}
GlslModel glsl(const TorranceSparrow& m) {
    return {std::string(fresnel) + grooves + microfacet, with_fresnel(m.fresnel, of_facets(m.m, false, 1))};
}
GlslModel glsl(const CookTorrance& m) {
    const float brightness = m.denominator == CookTorrance::Denominator::pi ? 4.0f : 1.0f;
    return {
        std::string(fresnel) + grooves + microfacet,
        with_fresnel(m.fresnel, of_facets(m.m, m.distribution == CookTorrance::Distribution::beckmann, brightness))};
}
GlslModel glsl(const OrenNayar& m) { return {oren_nayar, {{"sigma", m.sigma}}}; }
GlslModel glsl(const Ward& m) {
    return {ward,
            {{"along", m.along}, {"across", m.across}, {"bounded", m.form == Ward::Form::bounded ? 1.0f : 0.0f}}};
}
GlslModel glsl(const Velvet& m) { return {velvet, {{"slope", m.m}}}; }
GlslModel glsl(const Subsurface& m) {
    Uniforms uniforms = of_facets(m.m, false, 1);
    uniforms.emplace_back("scattering", m.scattering);
    uniforms.emplace_back("absorption", m.absorption);
    uniforms.emplace_back("index_below", m.n);
    return {std::string(grooves) + subsurface, uniforms};
}
GlslModel glsl(const HeTorrance& m) {
    return {std::string(fresnel) + he_torrance,
            with_fresnel(m.fresnel, {{"sigma", m.sigma}, {"tau", m.tau}, {"wavelength", m.wavelength},
                                     {"cos_source", float(sin_cos_degrees(double(m.source_degrees)).cos)}})};
}

std::optional<GlslModel> glsl(const Layered& m) {
    std::optional<GlslModel> model = reflectance_in_glsl(m.base->model);
    if (!model) return model;
    model->source = "#define reflect_light reflect_base\n" + model->source + "#undef reflect_light\n" + layers;
    model->uniforms.insert(model->uniforms.end(), {{"base_specular", m.base_specular},
                                                   {"fibres", m.sheen.strength},
                                                   {"varnish", m.coat.strength},
                                                   {"varnish_slope", m.coat.m}});
    return model;
}

}  // namespace

std::optional<GlslModel> reflectance_in_glsl(const AnyReflectance& reflectance) {
    return std::visit(
        []<class M>(const M& model) -> std::optional<GlslModel> {
            if constexpr (requires { glsl(model); }) return glsl(model);
            return std::nullopt;
        },
        reflectance);
}

}  // namespace raster::tool
