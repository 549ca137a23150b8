// obj_material.cpp: one row a key; texture lines through tinyobjloader.
#include <raster/scene/obj_material.h>

#include <algorithm>
#include <iterator>

#include <tiny_obj_loader.h>

#include <raster/scene/obj_lines.h>
#include <raster/scene/obj_tokens.h>

namespace raster::obj {
namespace {

constexpr std::size_t most_materials = 65536;
constexpr std::size_t most_files = 1000;

struct ColorKey {
    std::string_view key;
    glm::vec3 Material::*value;
};
constexpr ColorKey color_keys[] = {
    {"Ka", &Material::ambient}, {"Kd", &Material::diffuse}, {"Ks", &Material::specular}, {"Ke", &Material::emission}};

struct NumberKey {
    std::string_view key;
    float Material::*value;
    float low, high;
};
constexpr float unbounded = 3.4e38f;
constexpr NumberKey number_keys[] = {
    {"Ns", &Material::shininess, 0, unbounded},
    {"Ni", &Material::index_of_refraction, 0, unbounded},
    {"d", &Material::alpha, 0, 1},
    {"Pr", &Material::roughness, 0, 1},
    {"Pm", &Material::metallic, 0, 1},
    {"Ps", &Material::sheen, 0, 1},
    {"Pc", &Material::clearcoat, 0, 1},
    {"Pcr", &Material::clearcoat_roughness, 0, 1},
    {"aniso", &Material::anisotropy, 0, 1},
    {"anisor", &Material::anisotropy_rotation, 0, 1},
};

struct TextureKey {
    std::string_view key;
    int Material::*slot;
};
constexpr TextureKey texture_keys[] = {{"map_Ka", &Material::ambient_texture},
                                       {"map_Kd", &Material::diffuse_texture},
                                       {"map_Ks", &Material::specular_texture},
                                       {"map_Ke", &Material::emission_texture},
                                       {"map_d", &Material::alpha_texture}};

constexpr std::string_view unused_keys[] = {
    "Tf",   "Kt",       "sharpness", "map_Ns", "map_bump", "map_Bump", "bump",    "map_Pr", "map_disp", "map_Disp",
    "disp", "map_refl", "refl",      "map_Pm", "map_Ps",   "norm",     "map_aat", "map_Tr", "decal",    "map_decal"};

template <class Row, std::size_t n>
const Row* find_key(const Row (&rows)[n], std::string_view key) {
    const Row* row = std::find_if(rows, rows + n, [&](const Row& r) { return r.key == key; });
    return row == rows + n ? nullptr : row;
}

/// How a texture line differs from one without options.
struct TextureLine {
    std::string name;
    bool clamp = false;
    bool has_unused_options = false;
};

/// tinyobjloader reads the line, but takes three numbers where -o, -s and -t may have one or two (and two for
/// -mm), so that the file name is lost; here they are filled up.
TextureLine read_texture_line(std::string_view text) {
    std::string full;
    bool has_unused_options = false;
    while (text.starts_with('-')) {
        std::string_view rest = text;
        const std::string_view option = next_word(rest);
        int numbers = option == "-mm" ? 2 : (option == "-o" || option == "-s" || option == "-t") ? 3 : 0;
        const bool has_word = option == "-clamp" || option == "-blendu" || option == "-blendv" || option == "-boost" ||
                              option == "-bm" || option == "-texres" || option == "-imfchan" || option == "-type" ||
                              option == "-colorspace";
        if (numbers == 0 && !has_word) break;  // a file name that starts with -
        has_unused_options |= option != "-clamp";
        full += std::string(option) + " ";
        if (has_word) full += std::string(next_word(rest)) + " ";
        const std::string filling = option == "-s" ? "1 " : "0 ";
        for (bool given = true; numbers > 0; --numbers) {
            std::string_view ahead = rest;
            const std::string_view word = next_word(ahead);
            const float number = given ? parse_number(word) : 0.0f;
            given = given && number - number == 0;
            full += given ? std::string(word) + " " : filling;
            if (given) rest = ahead;
        }
        text = rest;
    }
    full += text;
    TextureLine line;
    tinyobj::texture_option_t options{};
    tinyobj::ParseTextureNameAndOption(&line.name, &options, full.c_str());
    line.clamp = options.clamp;
    line.has_unused_options = has_unused_options;
    return line;
}

class MtlReader {
public:
    MtlReader(const std::string& file, const std::string& folder, MaterialLibrary& library, Log& log)
        : file_(file), folder_(folder), library_(library), log_(log) {}

    void statement(std::string_view text, std::size_t line) {
        at_ = {file_, line};
        const std::string_view key = next_word(text);
        if (key == "newmtl") return begin(text);
        if (!current_) {
            if (!skipping_) log_.count(at_, "statement before the first newmtl", "statements before the first newmtl");
            return;
        }
        Material& material = current_->material;
        if (const auto* row = find_key(color_keys, key)) {
            read_color(without_comment(text), key, material.*row->value);
        } else if (const auto* row = find_key(number_keys, key)) {
            has_d_ |= key == "d";
            material.physically_based |= key.starts_with('P') || key.starts_with("aniso");
            read_number(without_comment(text), key, *row);
        } else if (key == "Tr") {
            // The opposite of d. Where both stand, d counts.
            float transparency = 0;
            if (take_number(without_comment(text), key, transparency) && !has_d_)
                material.alpha = 1.0f - std::clamp(transparency, 0.0f, 1.0f);
        } else if (key == "illum") {
            float number = float(material.illumination);
            if (take_number(without_comment(text), key, number))
                material.illumination = int(std::clamp(number, 0.0f, 10.0f));
        } else if (const auto* row = find_key(texture_keys, key)) {
            read_texture(text, key, row->slot);
        } else if (std::find(std::begin(unused_keys), std::end(unused_keys), key) != std::end(unused_keys)) {
            log_.note(at_, std::string(key) + " is not used here");
        } else {
            log_.warn(at_, "unknown key " + in_quotes(key));
        }
    }

private:
    void begin(std::string_view name) {
        current_ = nullptr;
        skipping_ = true;
        has_d_ = false;
        if (library_.index.contains(name)) {
            log_.warn(at_, "material " + in_quotes(name) + " is defined again; the first definition counts");
        } else if (library_.entries.size() >= most_materials) {
            log_.warn(at_, "more than " + std::to_string(most_materials) + " materials; the rest is left out");
        } else {
            library_.index.emplace(name, int(library_.entries.size()));
            library_.entries.push_back({{}, {}, file_, folder_});
            current_ = &library_.entries.back();
            current_->material.name = name;
        }
    }

    void bad(std::string_view key, std::string_view text) {
        log_.warn(at_, std::string(key) + " without a number that can be used: " + in_quotes(text));
    }

    bool take_number(std::string_view text, std::string_view key, float& value) {
        const Numbers numbers = parse_numbers(text);
        if (numbers.count == 0 || !(numbers.value[0] - numbers.value[0] == 0)) {
            bad(key, text);
            return false;
        }
        value = numbers.value[0];
        return true;
    }

    void read_number(std::string_view text, std::string_view key, const NumberKey& row) {
        if (text.starts_with("-halo")) next_word(text);
        float& value = current_->material.*row.value;
        if (!take_number(text, key, value)) return;
        value = std::clamp(value, row.low, row.high);
    }

    void read_color(std::string_view text, std::string_view key, glm::vec3& color) {
        const Numbers numbers = parse_numbers(text);
        if (text.starts_with("spectral") || text.starts_with("xyz")) {
            log_.note(at_, std::string(key) + " in other terms than r g b is not used here");
        } else if (numbers.count == 0 || !numbers.finite()) {
            bad(key, text);
        } else {
            // One number is a grey.
            for (int i = 0; i < 3; ++i) color[i] = numbers.value[i < numbers.count ? i : 0];
        }
    }

    void read_texture(std::string_view text, std::string_view key, int Material::*slot) {
        const TextureLine line = read_texture_line(text);
        if (line.name.empty()) return log_.warn(at_, std::string(key) + " without a file name");
        if (line.has_unused_options) log_.note(at_, "texture options other than -clamp are not used here");
        current_->material.clamp_texture |= line.clamp;
        std::erase_if(current_->textures, [&](const TextureUse& use) { return use.slot == slot; });
        current_->textures.push_back({line.name, at_.line, slot});
    }

    const std::string& file_;
    const std::string& folder_;
    MaterialLibrary& library_;
    Log& log_;
    Place at_;
    MaterialEntry* current_ = nullptr;
    bool skipping_ = false;
    bool has_d_ = false;
};

}  // namespace

void read_mtl(std::string_view bytes, const std::string& file, const std::string& folder, MaterialLibrary& library,
              Log& log) {
    constexpr std::size_t longest_line = 65536;
    if (is_utf16(bytes)) return log.warn({file}, "this is UTF-16 text and is not read; save it as UTF-8");
    LineReader lines(bytes, longest_line);
    MtlReader reader(file, folder, library, log);
    while (!log.failed() && lines.next()) reader.statement(lines.text(), lines.line());
    if (lines.is_too_long())
        log.warn({file, lines.line()}, "longer than 65536 bytes; this line and the rest are left out");
    if (lines.first_line_with_zeros() > 0)
        log.warn({file, lines.first_line_with_zeros()}, "zero bytes, taken for blanks");
}

void MaterialFiles::read(std::string_view names, const Place& place, MaterialLibrary& library, Log& log) {
    if (names.empty()) return log.warn(place, "mtllib without a file name");
    if (!finder_) return log.warn(place, "material file " + in_quotes(names) + " is not opened");
    if (!statements_.emplace(names).second) return;
    if (statements_.size() > most_files)
        return log.warn(place, "more than " + std::to_string(most_files) + " mtllib statements; the rest is left out");

    // The whole line may be one name with blanks.
    const Result<std::string> whole = finder_->find(names, finder_->folder());
    if (whole) return read_found(*whole, names, place, library, log);
    std::vector<std::pair<std::string_view, Result<std::string>>> files;
    std::string_view rest = names;
    for (std::string_view word = next_word(rest); !word.empty() && files.size() < most_files; word = next_word(rest))
        files.emplace_back(word, finder_->find(word, finder_->folder()));
    if (std::none_of(files.begin(), files.end(), [](const auto& file) { return bool(file.second); }))
        return log.warn(place, "material file " + in_quotes(names) + ": " + whole.error().message);
    for (const auto& [word, path] : files) {
        if (path) {
            read_found(*path, word, place, library, log);
        } else {
            log.warn(place, "material file " + in_quotes(word) + ": " + path.error().message);
        }
    }
}

void MaterialFiles::read_found(const std::string& path, std::string_view name, const Place& place,
                               MaterialLibrary& library, Log& log) {
    if (opened_.size() >= most_files || !opened_.emplace(path).second) return;
    const Result<Bytes> bytes = read_file(path, max_bytes_);
    if (!bytes) return log.warn(place, "material file " + in_quotes(name) + ": " + bytes.error().message);
    const std::string_view text(reinterpret_cast<const char*>(bytes->data()), bytes->size());
    read_mtl(text, printable(name), folder_of(path), library, log);
}

}  // namespace raster::obj
