// specs.cpp: tables from keys to members, so that a new key is a line.
#include "specs.h"

#include <algorithm>
#include <functional>
#include <string>

#include <raster/shading/materials.h>

#include "parse.h"

namespace raster::tool {

const char* const light_help =
    "A light; may be given again and again, and then the default one goes. KIND[:KEY=VALUE]...\n"
    "head: the default, a white light over the viewer's left shoulder and some ambient light\n"
    "ambient: from everywhere\n"
    "directional: parallel, along dir\n"
    "point: from pos to all sides\n"
    "spot: from pos along dir, into a cone of cutoff degrees (0 to 180, half its opening) [30], weakened by"
    " cos^falloff from its axis [0]\n"
    "Keys: color=COLOR [1,1,1]; intensity=N, which multiplies it [1]; diffuse=COLOR, specular=COLOR, ambient=COLOR set"
    " the three terms apart; decay=C1,C2,C3 weakens by min(1/(C1 + C2 d + C3 d^2), 1) at distance d [1,0,0];"
    " space=world|eye, where eye moves with the viewer [world]; units=relative|radiometric [relative], where radiometric"
    " is W/sr of point and spot, W/m^2 of directional lights, weakened by 1/d^2 alone, d in metres, and colours become"
    " radiance. dir is [0,0,-1], pos [0,0,0].\n"
    "A COLOR is R,G,B of 0 and up, one number, or #RRGGBB.\n"
    "[head]";

std::string material_help() {
    std::string names;
    for (const std::string_view name : material_names()) names += (names.empty() ? "" : ", ") + std::string(name);
    return "Changes all materials: NAME[:KEY=VALUE]... or KEY=VALUE[:KEY=VALUE]... NAME is a substance with its reflectance"
           " model: " + names + "."
           " Metals have their indices n + ik at 650, 550 and 450 nm.\n"
           "Keys: color=COLOR (diffuse, without its texture, and ambient), ambient, diffuse, specular, emission=COLOR;"
           " shininess=N (the highlight's exponent, 0 to 1000); alpha=N (0 to 1, 1 is opaque); reflectance=NAME, as"
           " --reflectance, for these materials; for models that read them: roughness=N (0 to 1; a facet slope, oren-nayar's"
           " sigma in radians), ior=N (index of refraction, 1 to 4), anisotropy=N (0 to 1),"
           " anisotropy_rotation=N (of the grain, 0 to 1 is a whole turn); metallic=N (0 to 1), as MTL's Pm: with it"
           " roughness is Pr, and the color that of the metal; layers on top, each 0 to 1: sheen=N, fine fibres; clearcoat=N,"
           " varnish, and clearcoat_roughness=N, its slope's square root; brdf=FILE, a measured BRDF in the MERL layout.";
}

namespace {

/// A key's value through its parser into its place; an error that names the key.
template <class T, class Parsed>
Status store(T& into, const std::string& key, Result<Parsed> parsed) {
    if (!parsed && parsed.error().kind != ErrorKind::usage) return parsed.error();
    if (!parsed) return usage(key + "=" + parsed.error().message);
    into = *parsed;
    return Done{};
}

Result<Attenuation> parse_decay(std::string_view text) {
    const Result<glm::vec3> c = parse_vector(text);
    const bool weakens = c && c->x >= 0 && c->y >= 0 && c->z >= 0 && *c != glm::vec3(0.0f);
    if (!weakens) return usage(in_quotes(text) + " is not C1,C2,C3: three numbers of 0 and up, not all 0");
    return Attenuation{c->x, c->y, c->z};
}

Result<LightSpace> parse_space(std::string_view text) {
    if (text == "world") return LightSpace::world;
    if (text == "eye") return LightSpace::eye;
    return usage(in_quotes(text) + " is none of world, eye");
}

Result<std::shared_ptr<const MeasuredTable>> read_brdf(const std::string& name, const FindFile& find) {
    const Result<std::string> path = find(name);
    if (!path) return path.error();
    Result<MeasuredTable> table = read_measured(*path);
    if (!table) return table.error();
    return std::make_shared<const MeasuredTable>(std::move(*table));
}

Result<std::string> parse_reflectance_name(std::string_view text) {
    if (const auto found = parse_reflectance(text); !found) return found.error();
    return std::string(text);
}

Result<LightUnits> parse_units(std::string_view text) {
    if (text == "relative") return LightUnits::relative;
    if (text == "radiometric") return LightUnits::radiometric;
    return usage(in_quotes(text) + " is none of relative, radiometric");
}

/// What a light specification says; which keys a kind of light knows is told by `allowed`.
struct LightKeys {
    Light light;
    std::optional<glm::vec3> color, diffuse, specular, ambient;
    float intensity = 1.0f;

    Status set(const std::string& key, const std::string& value) {
        if (key == "color") return store(color, key, parse_color(value));
        if (key == "diffuse") return store(diffuse, key, parse_color(value));
        if (key == "specular") return store(specular, key, parse_color(value));
        if (key == "ambient") return store(ambient, key, parse_color(value));
        if (key == "intensity") return store(intensity, key, parse_number_within(value, 0.0f, 1e6f));
        if (key == "pos") return store(light.position, key, parse_vector(value));
        if (key == "dir") return store(light.direction, key, parse_direction(value));
        if (key == "decay") return store(light.attenuation, key, parse_decay(value));
        if (key == "cutoff") return store(light.cutoff_degrees, key, parse_number_within(value, 0.0f, 180.0f));
        if (key == "falloff") return store(light.falloff_exponent, key, parse_number_within(value, 0.0f, 1e4f));
        if (key == "units") return store(light.units, key, parse_units(value));
        return store(light.space, key, parse_space(value));
    }
};

struct LightForm {
    const char* name;
    LightKind kind;
    std::vector<std::string> keys;
};

const std::vector<LightForm>& light_forms() {
    static const std::vector<LightForm> all = {
        {"head", LightKind::directional, {"color", "intensity"}},
        {"ambient", LightKind::ambient, {"color", "intensity"}},
        {"directional",
         LightKind::directional,
         {"dir", "color", "intensity", "diffuse", "specular", "ambient", "space", "units"}},
        {"point",
         LightKind::point,
         {"pos", "decay", "color", "intensity", "diffuse", "specular", "ambient", "space", "units"}},
        {"spot",
         LightKind::spot,
         {"pos", "dir", "cutoff", "falloff", "decay", "color", "intensity", "diffuse", "specular", "ambient", "space",
          "units"}},
    };
    return all;
}

std::string joined(const std::vector<std::string>& words) {
    std::string out;
    for (const std::string& word : words) out += (out.empty() ? "" : ", ") + word;
    return out;
}

}  // namespace

Result<AnyReflectance> parse_reflectance(std::string_view text) {
    std::vector<std::string> names;
    for (const std::string_view name : reflectance_names()) {
        names.emplace_back(name);
        if (name == text) return *find_reflectance(name);
    }
    return usage(in_quotes(text) + " is none of " + joined(names) + did_you_mean(text, names));
}

Result<std::vector<Light>> parse_light(std::string_view text) {
    const Result<Spec> spec = parse_spec(text);
    if (!spec) return spec.error();
    std::vector<std::string> names;
    for (const LightForm& kind : light_forms()) names.emplace_back(kind.name);
    const auto kind = std::ranges::find_if(light_forms(), [&](const LightForm& k) { return k.name == spec->name; });
    if (kind == light_forms().end())
        return usage(in_quotes(text) + ": " + in_quotes(spec->name) + " is none of " + joined(names) +
                     did_you_mean(spec->name, names));

    LightKeys keys;
    keys.light.kind = kind->kind;
    for (const auto& [key, value] : spec->values) {
        if (std::ranges::find(kind->keys, key) == kind->keys.end())
            return usage(in_quotes(text) + ": a light of kind " + spec->name + " has no " + in_quotes(key) + ", but " +
                         joined(kind->keys) + did_you_mean(key, kind->keys));
        if (const Status status = keys.set(key, value); !status)
            return usage(in_quotes(text) + ": " + status.error().message);
    }

    const glm::vec3 color = keys.color.value_or(glm::vec3(1.0f)) * keys.intensity;
    if (spec->name == "head") {
        std::vector<Light> lights = default_lights();
        for (Light& light : lights) {
            light.ambient *= color;
            light.diffuse *= color;
            light.specular *= color;
        }
        return lights;
    }
    Light light = keys.light;
    if (light.kind == LightKind::ambient) {
        light.ambient = color;
        light.diffuse = light.specular = glm::vec3(0.0f);
    } else {
        light.diffuse = keys.diffuse ? *keys.diffuse * keys.intensity : color;
        light.specular = keys.specular ? *keys.specular * keys.intensity : color;
        if (keys.ambient) light.ambient = *keys.ambient * keys.intensity;
    }
    return std::vector<Light>{light};
}

void MaterialChange::apply_to(Material& m) const {
    const auto set = [](auto& into, const auto& value) {
        if (value) into = *value;
    };
    if (substance) {
        const std::string name = m.name;
        const glm::vec3 grain = m.grain;
        m = *substance;
        m.name = name;
        m.grain = grain;
    }
    if (color) {
        m.diffuse = m.ambient = *color;
        m.diffuse_texture = m.ambient_texture = -1;
    }
    if (brdf) {
        m.measured = *brdf;
        m.reflectance = Measured::name;
        m.diffuse = glm::vec3(1.0f);
        m.diffuse_texture = -1;
        m.refractive_index = m.extinction = glm::vec3(0.0f);
    }
    set(m.reflectance, reflectance);
    set(m.ambient, ambient);
    if (ambient) m.ambient_counts = true;
    set(m.diffuse, diffuse);
    set(m.specular, specular);
    set(m.emission, emission);
    set(m.shininess, shininess);
    set(m.alpha, alpha);
    set(m.roughness, roughness);
    set(m.metallic, metallic);
    if (metallic) m.physically_based = true;
    set(m.anisotropy, anisotropy);
    set(m.anisotropy_rotation, anisotropy_rotation);
    set(m.sheen, sheen);
    set(m.clearcoat, clearcoat);
    set(m.clearcoat_roughness, clearcoat_roughness);
    set(m.index_of_refraction, index_of_refraction);
    if (index_of_refraction) m.refractive_index = m.extinction = glm::vec3(0.0f);
    // A file that turned highlights off did not mean the one that is asked for here.
    if (specular && m.illumination < 2) m.illumination = 2;
}

Result<MaterialChange> parse_material(std::string_view text) {
    return parse_material_finding(text, [](const std::string& name) { return name; }, {});
}

Result<MaterialChange> parse_material_finding(std::string_view text, const FindFile& find,
                                              const std::vector<std::string>& own_names) {
    const Result<Spec> spec = parse_spec(text);
    if (!spec) return spec.error();
    MaterialChange change;
    if (!spec->name.empty()) {
        change.substance = find_material(spec->name);
        const auto names = material_names();
        std::vector<std::string> words;
        if (spec->values.empty()) words = own_names;
        words.insert(words.end(), names.begin(), names.end());
        if (!change.substance)
            return usage(in_quotes(text) + ": " + in_quotes(spec->name) + " is none of " + joined(words) +
                         did_you_mean(spec->name, words) + "; or give KEY=VALUE:KEY=VALUE");
    } else if (spec->values.empty()) {
        return usage(in_quotes(text) + " is neither a material's NAME nor KEY=VALUE");
    }
    const std::vector<std::pair<std::string, std::optional<glm::vec3> MaterialChange::*>> colors = {
        {"color", &MaterialChange::color},
        {"ambient", &MaterialChange::ambient},
        {"diffuse", &MaterialChange::diffuse},
        {"specular", &MaterialChange::specular},
        {"emission", &MaterialChange::emission}};
    struct Number {
        std::string key;
        std::optional<float> MaterialChange::*member;
        float high;
        float low = 0.0f;
    };
    const std::vector<Number> numbers = {{"shininess", &MaterialChange::shininess, 1000.0f},
                                         {"alpha", &MaterialChange::alpha, 1.0f},
                                         {"roughness", &MaterialChange::roughness, 1.0f},
                                         {"metallic", &MaterialChange::metallic, 1.0f},
                                         {"anisotropy", &MaterialChange::anisotropy, 1.0f},
                                         {"anisotropy_rotation", &MaterialChange::anisotropy_rotation, 1.0f},
                                         {"sheen", &MaterialChange::sheen, 1.0f},
                                         {"clearcoat", &MaterialChange::clearcoat, 1.0f},
                                         {"clearcoat_roughness", &MaterialChange::clearcoat_roughness, 1.0f},
                                         {"ior", &MaterialChange::index_of_refraction, 4.0f, 1.0f}};
    for (const auto& [key, value] : spec->values) {
        Status status = Done{};
        std::vector<std::string> known = {"reflectance", "brdf"};
        bool found = key == "reflectance" || key == "brdf";
        if (key == "reflectance") status = store(change.reflectance, key, parse_reflectance_name(value));
        if (key == "brdf") status = store(change.brdf, key, read_brdf(value, find));
        for (const auto& [name, member] : colors) {
            known.push_back(name);
            if (name != key) continue;
            found = true;
            status = store(change.*member, key, parse_color(value));
        }
        for (const Number& number : numbers) {
            known.push_back(number.key);
            if (number.key != key) continue;
            found = true;
            status = store(change.*number.member, key, parse_number_within(value, number.low, number.high));
        }
        if (!found)
            return usage(in_quotes(text) + ": a material has no " + in_quotes(key) + ", but " + joined(known) +
                         did_you_mean(key, known));
        if (!status && status.error().kind != ErrorKind::usage) return status.error();
        if (!status) return usage(in_quotes(text) + ": " + status.error().message);
    }
    return change;
}

}  // namespace raster::tool
