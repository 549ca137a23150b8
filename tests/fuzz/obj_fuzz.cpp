// obj_fuzz.cpp: libFuzzer target for OBJ files: whatever the bytes, a sound model or an error, and the same twice.
// Build: clang++ -fsanitize=fuzzer,address,undefined; seeds: tests/fuzz/corpus/obj.
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <string_view>

#include <raster/scene/obj.h>
#include <raster/scene/obj_parse.h>
#include <raster/scene/triangulate.h>

namespace {

using namespace raster;

void require(bool condition) {
    if (!condition) std::abort();
}

void require_sound(const Model& m) {
    require(!m.indices.empty() && m.indices.size() % 3 == 0);
    for (const std::uint32_t i : m.indices) require(i < m.vertices.size());
    for (const auto& v : m.vertices) {
        for (const float f :
             {v.position.x, v.position.y, v.position.z, v.uv.x, v.uv.y, v.color.x, v.color.y, v.color.z})
            require(std::isfinite(f));
        require(std::abs(glm::dot(v.normal, v.normal) - 1) < 1e-5f);
    }
    for (std::size_t i = 0; i < m.indices.size(); i += 3)
        require(!has_zero_area(m.vertices[m.indices[i]].position, m.vertices[m.indices[i + 1]].position,
                               m.vertices[m.indices[i + 2]].position));
    std::uint32_t next = 0;
    for (const Part& part : m.parts) {
        require(part.first_index == next && part.index_count > 0 && part.index_count % 3 == 0 && part.material == -1);
        next += part.index_count;
    }
    require(next == m.indices.size());
}

void require_readable(std::string_view message) {
    require(!message.empty() && message.size() < 2000 && message.starts_with("x.obj"));
    for (const char c : message) require(static_cast<unsigned char>(c) >= 0x20 && c != 0x7f);
}

struct Outcome {
    Result<Model> model;
    LoadReport report;
};

Outcome parse(std::string_view text, bool strict) {
    ObjOptions options;
    options.strict = strict;
    options.max_triangles = 100'000;
    options.max_line_bytes = 50'000;
    LoadReport report;
    Result<Model> model =
        parse_obj(std::as_bytes(std::span(text.data(), text.size())), "x.obj", std::nullopt, options, report);
    return {std::move(model), std::move(report)};
}

void require_same(const Outcome& a, const Outcome& b) {
    require(bool(a.model) == bool(b.model) && a.report.messages() == b.report.messages());
    if (!a.model) return require(a.model.error().message == b.model.error().message);
    require(a.model->indices == b.model->indices && a.model->vertices.size() == b.model->vertices.size() &&
            std::memcmp(a.model->vertices.data(), b.model->vertices.data(),
                        a.model->vertices.size() * sizeof a.model->vertices[0]) == 0);
}

struct Read {
    obj::ObjData data;
    LoadReport report;
    std::string error;
};

Read read_in_pieces(std::string_view text, std::size_t piece_bytes) {
    ObjOptions options;
    options.max_triangles = 1000;
    options.max_line_bytes = 1000;
    Read read;
    obj::Log log(read.report, options.strict);
    read.data = obj::parse_statements(text, "x.obj", nullptr, options, log, piece_bytes);
    if (log.failed()) read.error = log.error().message;
    return read;
}

template <class T>
bool same_bytes(const std::vector<T>& a, const std::vector<T>& b) {
    return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0);
}

// Where a text is cut into pieces makes no difference.
void require_same_in_pieces(std::string_view text) {
    const Read whole = read_in_pieces(text, text.size() + 1), pieces = read_in_pieces(text, text.size() / 5 + 1);
    require(whole.error == pieces.error && whole.report.messages() == pieces.report.messages());
    require(whole.report.positions == pieces.report.positions && whole.report.faces == pieces.report.faces);
    if (!whole.error.empty()) return;
    const obj::ObjData &a = whole.data, &b = pieces.data;
    require(same_bytes(a.positions, b.positions) && same_bytes(a.colors, b.colors) && same_bytes(a.uvs, b.uvs) &&
            same_bytes(a.normals, b.normals) && same_bytes(a.corners, b.corners) && same_bytes(a.runs, b.runs));
    require(a.face_ends == b.face_ends && a.face_lines == b.face_lines && a.names == b.names &&
            a.material_names == b.material_names && a.material_lines == b.material_lines);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    const Outcome plain = parse(text, false);
    for (const std::string& message : plain.report.messages())
        if (!message.starts_with("and ")) require_readable(message);
    if (plain.model) {
        require_sound(*plain.model);
    } else {
        require_readable(plain.model.error().message);
    }
    require_same(plain, parse(text, false));
    require_same_in_pieces(text);

    // What is without a fault is loaded as well when faults are errors, and nothing else is.
    const Outcome strict = parse(text, true);
    require(!strict.model || plain.model);
    if (strict.model) require_same(strict, plain);
    if (plain.model && plain.report.warnings.empty()) require_same(strict, plain);

    // The kind of line end makes no difference, as long as there is one kind.
    if (text.find('\r') == text.npos && text.find('\0') == text.npos && size < 20'000) {
        std::string crlf;
        for (const char c : text) crlf += c == '\n' ? std::string("\r\n") : std::string(1, c);
        require_same(plain, parse(crlf, false));
    }
    return 0;
}
