// obj_build.cpp: the steps from polygons to an indexed triangle mesh, one function each.
#include <raster/scene/obj_build.h>

#include <algorithm>
#include <atomic>
#include <numeric>

#include <raster/scene/obj_dedup.h>
#include <raster/scene/triangulate.h>
#include <raster/tiles/parallel.h>

namespace raster::obj {
namespace {

bool is_finite(const glm::vec3& v) { return v.x - v.x == 0 && v.y - v.y == 0 && v.z - v.z == 0; }

std::size_t first_corner(const ObjData& data, std::size_t face) { return face == 0 ? 0 : data.face_ends[face - 1]; }

/// Whether test(i) is true for all i below `count`, on all threads.
template <class Test>
bool all_in_chunks(std::size_t count, const Test& test) {
    constexpr std::size_t chunk = 16384;
    std::atomic<bool> all{true};
    tiles::parallel_for((count + chunk - 1) / chunk, [&](std::size_t n) {
        bool good = true;
        for (std::size_t i = n * chunk; i < std::min((n + 1) * chunk, count); ++i) good = good && test(i);
        if (!good) all = false;
    });
    return all;
}

/// Frees the memory, which clear() does not.
template <class T>
void release(std::vector<T>& v) {
    std::vector<T>().swap(v);
}

// A face may come before its vertices, so the ends of the arrays are known only now. A position beyond is an error,
// anything else counts as missing. Afterwards an index is -1 or points at something finite; positions may be NaN.
void check_indices(ObjData& data, std::string_view file, Log& log) {
    const std::size_t positions = data.positions.size(), uvs = data.uvs.size(), normals = data.normals.size();
    const auto is_good = [&](const Corner& c) {
        return std::size_t(c.position) < positions &&
               (c.uv < 0 || (std::size_t(c.uv) < uvs && data.uvs[c.uv].x - data.uvs[c.uv].x == 0)) &&
               (c.normal < 0 || (std::size_t(c.normal) < normals && is_finite(data.normals[c.normal])));
    };
    if (all_in_chunks(data.corners.size(), [&](std::size_t c) { return is_good(data.corners[c]); })) return;
    for (std::size_t face = 0; face < data.face_ends.size(); ++face) {
        const Place place{file, data.face_lines[face]};
        for (std::size_t c = first_corner(data, face); c < data.face_ends[face]; ++c) {
            Corner& corner = data.corners[c];
            if (std::size_t(corner.position) >= data.positions.size())
                return log.fail(place, "vertex " + std::to_string(std::int64_t(corner.position) + 1) +
                                           " does not exist: the file has " + std::to_string(data.positions.size()));
            if (corner.uv >= 0 && std::size_t(corner.uv) >= data.uvs.size()) {
                corner.uv = -1;
                report_bad_uv_index(place, log);
            }
            if (corner.normal >= 0 && std::size_t(corner.normal) >= data.normals.size()) {
                corner.normal = -1;
                report_bad_normal_index(place, log);
            }
            if (corner.uv >= 0 && !(data.uvs[corner.uv].x - data.uvs[corner.uv].x == 0)) corner.uv = -1;
            if (corner.normal >= 0 && !is_finite(data.normals[corner.normal])) corner.normal = -1;
        }
    }
}

/// Triangles, as corners of the file's faces, and where they came from.
struct Triangles {
    std::vector<std::uint32_t> corners;
    std::vector<Run> runs;  ///< with first_face counting triangles
};

Triangles cut_faces(const ObjData& data, std::string_view file, Log& log) {
    Triangles triangles;
    const std::size_t count = data.face_ends.size();
    const auto is_good_triangle = [&](std::size_t face) {
        const Corner* const c = &data.corners[3 * face];
        const glm::vec3 &p = data.positions[c[0].position], &q = data.positions[c[1].position],
                        &r = data.positions[c[2].position];
        return is_finite(p) && is_finite(q) && is_finite(r) && !has_zero_area(p, q, r);
    };
    // A face has three corners at least, so all have three if there are three times as many.
    if (data.corners.size() == 3 * count && data.bad_positions == 0 && all_in_chunks(count, is_good_triangle)) {
        triangles.corners.resize(3 * count);
        std::iota(triangles.corners.begin(), triangles.corners.end(), 0u);
        triangles.runs = data.runs;
        return triangles;
    }
    triangles.corners.reserve(3 * count);
    Triangulator triangulate;
    std::vector<glm::vec3> polygon;
    const std::string why_not_finite = "a corner has no finite position (" + data.bad_position_word + " in line " +
                                       std::to_string(data.bad_position_line) + ")";
    bool bad_ones_used = false;
    std::size_t run = 0;
    for (std::size_t face = 0; face < data.face_ends.size() && !log.failed(); ++face) {
        if (run < data.runs.size() && data.runs[run].first_face == face) {
            triangles.runs.push_back(data.runs[run++]);
            triangles.runs.back().first_face = std::uint32_t(triangles.corners.size() / 3);
        }
        const std::size_t first = first_corner(data, face), before = triangles.corners.size();
        const auto position = [&](std::size_t c) { return data.positions[data.corners[c].position]; };
        bool all_finite = true;
        for (std::size_t c = first; c < data.face_ends[face]; ++c) all_finite = all_finite && is_finite(position(c));
        if (all_finite && data.face_ends[face] - first == 3) {
            if (!has_zero_area(position(first), position(first + 1), position(first + 2)))
                for (std::uint32_t c = 0; c < 3; ++c) triangles.corners.push_back(std::uint32_t(first) + c);
        } else if (all_finite) {
            polygon.clear();
            for (std::size_t c = first; c < data.face_ends[face]; ++c) polygon.push_back(position(c));
            triangulate(polygon, triangles.corners);
            for (std::size_t c = before; c < triangles.corners.size(); ++c)
                triangles.corners[c] += std::uint32_t(first);
        }
        if (triangles.corners.size() > before) continue;

        bad_ones_used |= !all_finite;
        const std::string why = all_finite ? "zero area" : why_not_finite;
        ++log.report().dropped_faces;
        log.count({file, data.face_lines[face]}, "face dropped: " + why, "faces dropped: " + why);
    }
    if (data.bad_positions > 0 && !bad_ones_used)
        log.count({file, data.bad_position_line}, "vertex without a finite position, which no face uses",
                  "vertices without a finite position, which no face uses", data.bad_positions);
    return triangles;
}

/// Made-up normals, one a corner; empty if no triangle needs them.
std::vector<glm::vec3> missing_normals(const ObjData& data, const Triangles& triangles, const ObjOptions& options) {
    const auto needs_one = [&](std::uint32_t corner) { return data.corners[corner].normal < 0; };
    if (std::none_of(triangles.corners.begin(), triangles.corners.end(), needs_one)) return {};
    std::vector<std::uint32_t> positions(data.corners.size());
    for (std::size_t c = 0; c < positions.size(); ++c) positions[c] = std::uint32_t(data.corners[c].position);
    std::vector<std::uint32_t> groups(data.face_ends.size());
    for (std::size_t r = 0; r < data.runs.size(); ++r) {
        const std::size_t end = r + 1 < data.runs.size() ? data.runs[r + 1].first_face : groups.size();
        std::fill(groups.begin() + data.runs[r].first_face, groups.begin() + std::ptrdiff_t(end),
                  data.runs[r].smoothing);
    }
    Creases creases;
    creases.angle = options.crease_angle.value_or(creases.angle);
    creases.within_groups = options.crease_angle.has_value();
    return make_normals(data.positions, {positions, data.face_ends, groups}, creases);
}

/// One vertex for each distinct combination of position, normal, texture coordinate and colour.
void index_vertices(const ObjData& data, const Triangles& triangles, const std::vector<glm::vec3>& made_normals,
                    Model& model) {
    model.indices.reserve(triangles.corners.size());
    // Some positions have several vertices, and a vector that grows leaves fresh memory behind.
    const std::size_t positions = data.positions.size();
    model.vertices.reserve(std::min(positions + positions / 8, triangles.corners.size()));
    Dedup<SurfaceVertex<float>> number(model.vertices, model.vertices.capacity());
    // Most corners are the vertex that their position had the last time, which takes no search. Position and colour are
    // the same then.
    constexpr std::uint32_t none = 0xffffffffu;
    std::vector<std::uint32_t> latest(data.positions.size(), none);
    const auto vertex_of = [&](std::uint32_t c) -> SurfaceVertex<float> {
        const Corner& corner = data.corners[c];
        return {data.positions[corner.position], corner.normal < 0 ? made_normals[c] : data.normals[corner.normal],
                corner.uv < 0 ? glm::vec2(0) : data.uvs[corner.uv],
                data.colors.empty() ? glm::vec3(1) : data.colors[corner.position]};
    };
    constexpr std::size_t ahead = 8;
    for (std::size_t i = 0; i < triangles.corners.size(); ++i) {
        if (i + ahead < triangles.corners.size()) {
            const std::uint32_t c = triangles.corners[i + ahead];
            if (latest[data.corners[c].position] == none) number.ask_ahead(vertex_of(c));
        }
        const std::uint32_t c = triangles.corners[i];
        const Corner& corner = data.corners[c];
        const glm::vec3& normal = corner.normal < 0 ? made_normals[c] : data.normals[corner.normal];
        const glm::vec2 uv = corner.uv < 0 ? glm::vec2(0) : data.uvs[corner.uv];
        std::uint32_t& index = latest[corner.position];
        if (index == none || !same_bits(model.vertices[index].normal, normal) ||
            !same_bits(model.vertices[index].uv, uv))
            index = number(vertex_of(c));
        model.indices.push_back(index);
    }
}

void make_parts(const ObjData& data, const Triangles& triangles, Model& model) {
    for (std::size_t r = 0; r < triangles.runs.size(); ++r) {
        const Run& run = triangles.runs[r];
        const std::size_t end =
            r + 1 < triangles.runs.size() ? triangles.runs[r + 1].first_face : triangles.corners.size() / 3;
        const auto count = std::uint32_t(3 * (end - run.first_face));
        if (count == 0) continue;
        const std::string name = run.name < 0 ? "" : data.names[run.name];
        Part* last = model.parts.empty() ? nullptr : &model.parts.back();
        if (last && last->name == name && last->material == run.material) {
            last->index_count += count;  // only the smoothing group changed
        } else {
            model.parts.push_back({name, run.material, 3 * run.first_face, count});
        }
    }
}

}  // namespace

Model build_model(ObjData& data, std::string_view file, const ObjOptions& options, Log& log) {
    const auto progress = [&](double done) {
        if (options.progress) options.progress(done);
    };
    Model model;
    check_indices(data, file, log);
    if (log.failed()) return model;
    const Triangles triangles = cut_faces(data, file, log);
    release(data.face_lines);
    if (log.failed()) return model;
    progress(0.8);
    std::vector<glm::vec3> made_normals = missing_normals(data, triangles, options);
    log.report().made_normals = !made_normals.empty();
    release(data.face_ends);
    progress(0.9);
    index_vertices(data, triangles, made_normals, model);
    make_parts(data, triangles, model);
    return model;
}

}  // namespace raster::obj
