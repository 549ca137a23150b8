// obj_text.h: a Model as the text of an OBJ and an MTL file, which give the same floats when read.
#pragma once

#include <array>
#include <charconv>
#include <map>
#include <string>
#include <vector>

#include <raster/scene/model.h>

namespace raster::models {

/// The shortest decimal number that is read as this float again.
inline std::string number(float x) {
    std::array<char, 32> room;
    return {room.data(), std::to_chars(room.data(), room.data() + room.size(), x).ptr};
}

template <int L>
std::string statement(const char* key, const vec<L, float>& v) {
    std::string line = key;
    for (int i = 0; i < L; ++i) line += " " + number(v[i]);
    return line + "\n";
}

/// Collects each different vector once, in the order of first use, and numbers them from 1.
template <int L>
class Numbered {
public:
    explicit Numbered(const char* key) : key_(key) {}

    std::string number_of(const vec<L, float>& v) {
        std::array<float, L> values;
        for (int i = 0; i < L; ++i) values[i] = v[i];
        const auto [at, is_new] = numbers_.try_emplace(values, numbers_.size() + 1);
        if (is_new) text_ += statement(key_, v);
        return std::to_string(at->second);
    }

    const std::string& text() const { return text_; }

private:
    const char* key_;
    std::string text_;
    std::map<std::array<float, L>, std::size_t> numbers_;
};

/// `comment` is lines that start with "# ". `mtl_name` is named if the model has materials.
inline std::string obj_text(const Model& model, const std::string& comment, const std::string& mtl_name) {
    Numbered<3> positions("v"), normals("vn");
    Numbered<2> uvs("vt");
    std::string faces;
    for (const Part& part : model.parts) {
        faces += "o " + part.name + "\n";
        if (part.material >= 0) faces += "usemtl " + model.materials[part.material].name + "\n";
        for (std::uint32_t i = 0; i < part.index_count; ++i) {
            const auto& v = model.vertices[model.indices[part.first_index + i]];
            if (i % 3 == 0) faces += "f";
            faces += " " + positions.number_of(v.position);
            faces += "/" + uvs.number_of(v.uv);
            faces += "/" + normals.number_of(v.normal);
            if (i % 3 == 2) faces += "\n";
        }
    }
    const std::string library = model.materials.empty() ? "" : "mtllib " + mtl_name + "\n";
    return comment + library + positions.text() + uvs.text() + normals.text() + faces;
}

inline std::string mtl_text(const Model& model, const std::string& comment) {
    std::string text = comment;
    for (const Material& m : model.materials) {
        text += "newmtl " + m.name + "\n";
        text += statement("Ka", m.ambient) + statement("Kd", m.diffuse) + statement("Ks", m.specular);
        if (m.emission != glm::vec3(0.0f)) text += statement("Ke", m.emission);
        if (m.specular != glm::vec3(0.0f)) text += "Ns " + number(m.shininess) + "\n";
        text += "illum " + std::to_string(m.illumination) + "\n";
        if (m.diffuse_texture >= 0) text += "map_Kd " + model.textures[m.diffuse_texture].name + "\n";
    }
    return text;
}

}  // namespace raster::models
