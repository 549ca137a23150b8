// bssrdf.cpp: what a BRDF leaves out of light below the surface: the same light and materials with Jensen's dipole, which
// says how much light comes out at each distance from where it went in.
//
// raster_bssrdf spheres: an OBJ file of four spheres with 10 mm of radius whose vertex colours are the light that leaves
//     them: marble and skin, each with the BRDF and with the BSSRDF. Single scattering and reflections are left out.
// raster_bssrdf edge: a plane of which the half x < 0 is lit: x in mm; of marble's and of skin's red, green and blue
//     radiosity with the BSSRDF over the irradiance; of both the green one with the BRDF.
#include <cmath>
#include <cstdio>
#include <string_view>
#include <vector>

#include <raster/math.h>
#include <raster/scene/shapes.h>
#include <raster/shading/fresnel.h>
#include <raster/shading/materials.h>
#include <raster/shading/subsurface.h>

using namespace raster;

namespace {

constexpr float pi = 3.14159265f;

Subsurface subsurface(const char* name) { return Subsurface{}.with_material(*find_material(name)); }

/// Rd(r) of Jensen et al. 2001, equation 4: a source zr below the surface and its mirror image zv above. One channel, 1/mm^2.
struct Dipole {
    float albedo, extinction, zr, zv;

    Dipole(const Subsurface& m, int c) {
        const float fdr = fresnel_diffuse(m.n), a = (1 + fdr) / (1 - fdr), reduced = m.scattering[c] + m.absorption[c];
        albedo = m.scattering[c] / reduced;
        extinction = sqrt(3 * m.absorption[c] * reduced);
        zr = 1 / reduced;
        zv = zr * (1 + 4.0f / 3 * a);
    }
    float operator()(float r2) const {
        const auto source = [&](float z) {
            const float d2 = r2 + z * z, d = sqrt(d2);
            return z * (1 + extinction * d) * raster::exp(-extinction * d) / (d2 * d);
        };
        return albedo / (4 * pi) * (source(zr) + source(zv));
    }
    /// The integral over a disc of the area `area`, in closed form.
    float of_disc(float area) const {
        const auto source = [&](float z) {
            const float d = sqrt(area / pi + z * z);
            return raster::exp(-extinction * z) - z * raster::exp(-extinction * d) / d;
        };
        return albedo / 2 * (source(zr) + source(zv));
    }
};

/// What each vertex of a sphere sends out under light from l: of a white surface that faces it 1.
std::vector<glm::vec3> radiosities(const Model& model, float radius, const Subsurface& m, const glm::vec3& l, bool spread) {
    const std::size_t count = model.vertices.size();
    std::vector<float> area(count), entering(count);
    for (std::size_t i = 0; i < model.indices.size(); i += 3) {
        const auto corner = [&](std::size_t c) { return model.vertices[model.indices[i + c]].position * radius; };
        const float third = glm::length(glm::cross(corner(1) - corner(0), corner(2) - corner(0))) / 6;
        for (std::size_t c = 0; c < 3; ++c) area[model.indices[i + c]] += third;
    }
    for (std::size_t i = 0; i < count; ++i) {
        const float n_l = max(glm::dot(model.vertices[i].normal, l), 0.0f);
        entering[i] = n_l * (1 - fresnel_dielectric(n_l, m.n));
    }
    std::vector<glm::vec3> out(count);
    for (int c = 0; c < 3; ++c) {
        const Dipole dipole(m, c);
        for (std::size_t i = 0; i < count; ++i) {
            float sum = spread ? dipole.of_disc(area[i]) * entering[i] : m.diffuse_reflectance()[c] * entering[i];
            for (std::size_t j = 0; spread && j < count; ++j) {
                const glm::vec3 apart = (model.vertices[i].position - model.vertices[j].position) * radius;
                if (j != i && entering[j] > 0) sum += dipole(glm::dot(apart, apart)) * entering[j] * area[j];
            }
            out[i][c] = sum;
        }
    }
    return out;
}

int print_spheres() {
    const Model model = icosphere(28);
    const glm::vec3 l = glm::normalize(glm::vec3(-1, 0.5f, 0.1f));
    std::size_t first = 1;
    float place = -3.3f;
    for (const char* name : {"marble", "skin"}) {
        for (const bool spread : {false, true}) {
            const std::vector<glm::vec3> color = radiosities(model, 10, subsurface(name), l, spread);
            for (std::size_t i = 0; i < model.vertices.size(); ++i) {
                const glm::vec3 p = model.vertices[i].position, n = model.vertices[i].normal;
                std::printf("v %.5f %.5f %.5f %.5f %.5f %.5f\nvn %.5f %.5f %.5f\n", double(p.x + place), double(p.y),
                            double(p.z), double(color[i].x), double(color[i].y), double(color[i].z), double(n.x),
                            double(n.y), double(n.z));
            }
            for (std::size_t i = 0; i < model.indices.size(); i += 3) {
                std::printf("f");
                for (std::size_t c = 0; c < 3; ++c)
                    std::printf(" %zu//%zu", first + model.indices[i + c], first + model.indices[i + c]);
                std::printf("\n");
            }
            first += model.vertices.size();
            place += 2.2f;
        }
    }
    return 0;
}

/// Of a half plane that begins at the distance x > 0: of each ring the part that lies in it.
float half_plane(const Dipole& dipole, float x) {
    constexpr int steps = 4000;
    constexpr float longest = 200;  // mm
    float sum = 0;
    for (int i = 0; i < steps; ++i) {
        const float s = (float(i) + 0.5f) / steps, r = x + longest * s * s;
        sum += dipole(r * r) * 2 * raster::acos(min(x / r, 1.0f)) * r * longest * 2 * s / steps;
    }
    return sum;
}

int print_edge() {
    const Subsurface materials[] = {subsurface("marble"), subsurface("skin")};
    for (int i = -120; i <= 120; ++i) {
        const float x = float(i) / 10;
        std::printf("%.1f", double(x));
        for (const Subsurface& m : materials) {
            for (int c = 0; c < 3; ++c) {
                const float dark = half_plane(Dipole(m, c), std::abs(x));
                std::printf(" %.5f", double(x > 0 ? dark : m.diffuse_reflectance()[c] - dark));
            }
        }
        for (const Subsurface& m : materials) std::printf(" %.5f", double(x > 0 ? 0 : m.diffuse_reflectance().y));
        std::printf("\n");
    }
    return 0;
}

}  // namespace

int main(int argc, char** argv) {
    const std::string_view what = argc > 1 ? argv[1] : "";
    if (what == "spheres") return print_spheres();
    if (what == "edge") return print_edge();
    std::fputs("usage: raster_bssrdf spheres | raster_bssrdf edge\n", stderr);
    return 2;
}
