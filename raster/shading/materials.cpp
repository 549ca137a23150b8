// materials.cpp: a table of substances, and indices of refraction from colours.
#include <raster/shading/materials.h>

#include <raster/shading/fresnel.h>

namespace raster {
namespace {

// n and k at 650, 550 and 450 nm, interpolated between the neighbours in the tables of: gold, silver, copper: Johnson and
// Christy, Optical constants of the noble metals, Phys. Rev. B 6, 4370 (1972); iron: the same, Optical constants of
// transition metals, Phys. Rev. B 9, 5056 (1974); aluminium: McPeak et al., Plasmonic films can easily be better, ACS
// Photonics 2, 326 (2015). As tabulated by refractiveindex.info (CC0).
struct Metal {
    std::string_view name, reflectance;
    glm::vec3 n, k;
    float roughness, anisotropy;
};
const glm::vec3 aluminium_n(1.246f, 0.789f, 0.489f), aluminium_k(6.852f, 5.852f, 4.778f);
const Metal metals[] = {
    {"gold", "cook-torrance", {0.156f, 0.424f, 1.383f}, {3.602f, 2.472f, 1.916f}, 0.35f, 0},
    {"silver", "cook-torrance", {0.052f, 0.060f, 0.040f}, {4.409f, 3.597f, 2.648f}, 0.35f, 0},
    {"copper", "cook-torrance", {0.238f, 1.007f, 1.240f}, {3.626f, 2.582f, 2.393f}, 0.35f, 0},
    {"aluminium", "cook-torrance", aluminium_n, aluminium_k, 0.35f, 0},
    {"iron", "cook-torrance", {2.911f, 2.950f, 2.585f}, {3.089f, 2.932f, 2.767f}, 0.35f, 0},
    {"brushed-aluminium", "ward", aluminium_n, aluminium_k, 0.3f, 0.9f},
    {"ground-aluminium", "he-torrance", aluminium_n, aluminium_k, 0.25f, 0},
};

// Reduced scattering and absorption in 1/mm, and the refractive index: the table of Jensen et al. 2001, figure 5.
struct Translucent {
    std::string_view name;
    glm::vec3 scattering, absorption;
    float n, roughness;
};
const Translucent translucents[] = {
    {"marble", {2.19f, 2.62f, 3.00f}, {0.0021f, 0.0041f, 0.0071f}, 1.5f, 0.25f},
    {"skin", {0.74f, 0.88f, 1.01f}, {0.032f, 0.17f, 0.48f}, 1.3f, 0.4f},
    {"milk", {2.55f, 3.21f, 3.77f}, {0.0011f, 0.0024f, 0.014f}, 1.3f, 0.15f},
    {"ketchup", {0.18f, 0.07f, 0.03f}, {0.061f, 0.97f, 1.45f}, 1.3f, 0.2f},
};

// Chosen by eye.
struct Plain {
    std::string_view name, reflectance;
    glm::vec3 diffuse, specular;
    float roughness, anisotropy;
};
const Plain plains[] = {
    {"paper", "lambert", glm::vec3(0.8f), glm::vec3(0), 0, 0},
    {"clay", "oren-nayar", {0.50f, 0.25f, 0.16f}, glm::vec3(0), 0.5f, 0},
    {"plaster", "oren-nayar", glm::vec3(0.85f), glm::vec3(0), 0.35f, 0},
    {"moon", "oren-nayar", glm::vec3(0.35f), glm::vec3(0), 0.7f, 0},
    {"plastic", "cook-torrance", {0.55f, 0.04f, 0.03f}, glm::vec3(1), 0.2f, 0},
    {"rubber", "cook-torrance", glm::vec3(0.04f), glm::vec3(1), 0.5f, 0},
    {"glazed-clay", "torrance-sparrow", {0.50f, 0.25f, 0.16f}, glm::vec3(1), 0.15f, 0},
    {"satin", "ward", {0.22f, 0.03f, 0.06f}, {0.35f, 0.12f, 0.16f}, 0.35f, 0.8f},
    {"velvet", "velvet", {0.10f, 0.01f, 0.03f}, {0.9f, 0.25f, 0.40f}, 0.4f, 0},
};

Material named(std::string_view name, std::string_view reflectance, float roughness) {
    Material m;
    m.name = name;
    m.reflectance = reflectance;
    m.roughness = roughness;
    return m;
}

Material to_material(const Metal& metal) {
    Material m = named(metal.name, metal.reflectance, metal.roughness);
    m.ambient = m.diffuse = glm::vec3(0.0f);
    m.specular = glm::vec3(1.0f);
    m.refractive_index = metal.n;
    m.extinction = metal.k;
    m.anisotropy = metal.anisotropy;
    return m;
}

Material to_material(const Translucent& t) {
    Material m = named(t.name, "subsurface", t.roughness);
    m.ambient = m.diffuse = m.specular = glm::vec3(1.0f);
    m.scattering = t.scattering;
    m.absorption = t.absorption;
    m.index_of_refraction = t.n;
    return m;
}

Material to_material(const Plain& p) {
    Material m = named(p.name, p.reflectance, p.roughness);
    m.ambient = m.diffuse = p.diffuse;
    m.specular = p.specular;
    m.anisotropy = p.anisotropy;
    m.index_of_refraction = 1.5f;
    return m;
}

/// Calls visit with every row of the three tables.
template <class Visit>
void for_each_row(const Visit& visit) {
    for (const Metal& row : metals) visit(row);
    for (const Translucent& row : translucents) visit(row);
    for (const Plain& row : plains) visit(row);
}

}  // namespace

std::vector<std::string_view> material_names() {
    std::vector<std::string_view> names;
    for_each_row([&](const auto& row) { names.push_back(row.name); });
    return names;
}

std::optional<Material> find_material(std::string_view name) {
    std::optional<Material> found;
    for_each_row([&](const auto& row) {
        if (row.name == name) found = to_material(row);
    });
    return found;
}

Material physically_based(const Material& material) {
    if (!material.physically_based || !material.reflectance.empty()) return material;
    Material m = material;
    const float metal = clamp(m.metallic, 0.0f, 1.0f);
    const float n = m.index_of_refraction > 1.0f ? m.index_of_refraction : 1.5f;
    const float r0 = (n - 1) * (n - 1) / ((n + 1) * (n + 1));
    m.reflectance = "cook-torrance";
    m.roughness = max(m.roughness * m.roughness, 0.02f);
    m.illumination = 2;
    m.specular = glm::vec3(1.0f);
    m.specular_texture = -1;
    if (metal > 0.0f) {
        m.diffuse = material.diffuse * (1.0f - metal);
        if (!m.ambient_counts) m.ambient = m.diffuse;
        // n and k of a given reflectance at normal incidence (Gulbrandsen, Artist Friendly Metallic Fresnel, 2014), with
        // an edge tint of one half.
        for (int c = 0; c < 3; ++c) {
            const float r = clamp(r0 * (1.0f - metal) + material.diffuse[c] * metal, 0.01f, 0.99f);
            const float root = sqrt(r);
            const float index = 0.5f * (1 - r) / (1 + r) + 0.5f * (1 + root) / (1 - root);
            m.refractive_index[c] = index;
            m.extinction[c] = sqrt(max((r * (index + 1) * (index + 1) - (index - 1) * (index - 1)) / (1 - r), 0.0f));
        }
    }
    if (m.anisotropy > 0.0f) {
        m.reflectance = "ward";  // which has no Fresnel term; a metal's colour is that of n and k
        if (!(metal > 0.0f)) m.specular = glm::vec3(r0);
    }
    return m;
}

glm::vec3 metal_ambient(const Material& m) {
    return m.specular * Fresnel{}.with_material(m)(1.0f);
}

}  // namespace raster
