// model.h: what a model file becomes: one vertex array, one index array, parts with materials, textures.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include <raster/image/image.h>
#include <raster/lanes.h>

namespace raster {

/// One corner of a surface, as every shader of this library takes it. All in object space.
template <class F>
struct SurfaceVertex {
    vec<3, F> position;
    vec<3, F> normal;  ///< unit length
    vec<2, F> uv;      ///< texture coordinate, v up as in OBJ files
    vec<3, F> color;   ///< linear RGB, 1 when the file has none
};

/// A texture as decoded. Row 0 is the top row, so v = 1 is row 0. An empty image means "not loaded".
struct Texture {
    std::string name;  ///< as the material file spells it
    Image8 image;
};

struct MeasuredTable;

/// A material in the terms of MTL files. Colours are as the file has them; a texture index of -1 means none.
struct Material {
    std::string name;
    std::string reflectance;  ///< name of a reflectance model (shading/models.h); empty: the one the picture is drawn with
    glm::vec3 ambient{0.0f};
    bool ambient_counts = false;    ///< whatever the picture is drawn with: many files have an arbitrary Ka
    glm::vec3 diffuse{0.8f};
    glm::vec3 specular{0.0f};
    glm::vec3 emission{0.0f};
    float shininess = 32.0f;        ///< Ns: Phong's exponent, 0 to 1000 in MTL files
    float alpha = 1.0f;             ///< d: 1 is opaque
    float index_of_refraction = 1;  ///< Ni
    int illumination = 2;           ///< illum: 0 colour only, 1 no specular, 2 highlight on, ...
    float roughness = 0;            ///< Pr
    float metallic = 0;             ///< Pm
    float sheen = 0;                ///< Ps
    float clearcoat = 0;            ///< Pc
    float clearcoat_roughness = 0;  ///< Pcr
    float anisotropy = 0;           ///< aniso: 0 is a round highlight, 1 a long one
    float anisotropy_rotation = 0;  ///< anisor: of the grain, 0 to 1 is a whole turn
    glm::vec3 grain{0, 1, 0};       ///< the direction of brush marks, object space, laid onto the surface
    bool physically_based = false;  ///< one of Pr ... anisor is given
    glm::vec3 refractive_index{0};  ///< n for each channel; 0: Ni for all, or the model's own
    glm::vec3 extinction{0};        ///< k for each channel, with n: above 0 for metals
    glm::vec3 scattering{0};        ///< below the surface, reduced, 1/mm; 0: the model's own
    glm::vec3 absorption{0};        ///< below the surface, 1/mm
    std::shared_ptr<const MeasuredTable> measured;  ///< for the model `measured`
    int ambient_texture = -1;       ///< map_Ka: index into Model::textures
    int diffuse_texture = -1;       ///< map_Kd
    int specular_texture = -1;      ///< map_Ks
    int emission_texture = -1;      ///< map_Ke
    int alpha_texture = -1;         ///< map_d
    bool clamp_texture = false;     ///< -clamp on
};

/// A run of triangles that share a material.
struct Part {
    std::string name;              ///< the o or g name it came from
    int material = -1;             ///< index into Model::materials; -1 is the default material
    std::uint32_t first_index = 0; ///< into Model::indices
    std::uint32_t index_count = 0; ///< a multiple of 3
};

/// A triangle mesh with materials. Indices are in range and positions are finite: loaders guarantee it.
struct Model {
    std::vector<SurfaceVertex<float>> vertices;
    std::vector<std::uint32_t> indices;  ///< three a triangle, counter-clockwise seen from the front
    std::vector<Part> parts;             ///< cover `indices` in order, without gaps
    std::vector<Material> materials;
    std::vector<Texture> textures;

    std::size_t triangle_count() const { return indices.size() / 3; }
};

/// Axis-aligned box of all vertices that a triangle uses; min > max when there is none.
struct Box {
    glm::vec3 min;
    glm::vec3 max;
};
Box bounding_box(const Model& model);

}  // namespace raster
