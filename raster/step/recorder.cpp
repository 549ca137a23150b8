// recorder.cpp: events into records.
#include <raster/step/recorder.h>

#include <algorithm>

#include <raster/stages/coverage.h>
#include <raster/trace/event_json.h>

namespace raster::step {
namespace {

template <class Span>
std::vector<float> copy(const Span& span) {
    return {span.begin(), span.end()};
}

bool same(const glm::vec4& a, const glm::vec4& b) {
    for (int i = 0; i < 4; ++i)
        if (as_int(a[i]) != as_int(b[i])) return false;
    return true;
}

/// Which edge of the polygon before a new corner lies on, and where, by the arithmetic of clip_against.
void find_origin(CornerRecord& corner, const std::vector<CornerRecord>& before) {
    const int count = int(before.size());
    for (int i = 0; i < count; ++i)
        if (before[std::size_t(i)].distance >= 0 && same(before[std::size_t(i)].clip, corner.clip)) return;
    for (int i = 0; i < count; ++i) {
        for (const auto& [from, to] : {std::pair(i, (i + 1) % count), std::pair((i + 1) % count, i)}) {
            const CornerRecord &a = before[std::size_t(from)], &b = before[std::size_t(to)];
            if ((a.distance >= 0) == (b.distance >= 0)) continue;
            const float t = a.distance / (a.distance - b.distance);
            glm::vec4 p;
            for (int c = 0; c < 4; ++c) p[c] = a.clip[c] + t * (b.clip[c] - a.clip[c]);
            if (!same(p, corner.clip)) continue;
            corner.from = from, corner.to = to, corner.t = t;
            return;
        }
    }
}

}  // namespace

void Recorder::on(const DrawEvent& event) {
    const PlannedDraw& draw = event.planned;
    draw_ = &draw;
    draw_number_ = event.draw;
    vertices_.clear();
    DrawRecord d;
    d.frequency = draw.frequency;
    d.level = draw.level;
    d.reflectance = std::visit([](const auto& m) { return std::string(m.name); }, draw.reflectance);
    if (const auto* blinn = std::get_if<BlinnPhong>(&draw.reflectance))
        d.n_h_power = blinn->convention == BlinnPhong::Exponent::alpha ? blinn->exponent : blinn->exponent * 0.25f;
    if (const auto* phong = std::get_if<Phong>(&draw.reflectance)) d.r_v_power = phong->exponent;
    d.state = draw.state;
    d.vertices = draw.mesh.vertices.size();
    d.varyings = varying_names(draw.frequency, draw.level);
    d.clip_from_object = draw.uniforms.clip_from_object;
    d.eye_from_object = draw.uniforms.eye_from_object;
    record_.draws.push_back(std::move(d));
}

void Recorder::on(const VertexEvent& event) {
    vertices_.push_back(
        {event.vertex, copy(event.attributes), event.clip, copy(event.varyings), glm::vec4(0.0f), glm::vec4(0.0f), {}});
}

void Recorder::on(const AssembleEvent& event) {
    ++record_.draws.back().triangles;
    number_ = number_in_model(*draw_, event.triangle);
    corners_ = event.vertices;
    polygon_.clear();
    const auto why = chosen_.find(number_);
    is_chosen_ = why != chosen_.end();
    if (!is_chosen_) return;
    TriangleRecord t;
    t.number = number_;
    t.order = event.triangle;
    t.draw = draw_number_;
    t.why = why->second;
    t.vertices = event.vertices;
    t.bad_index = event.bad_index;
    for (const std::uint32_t v : event.vertices)
        if (v < vertices_.size()) t.corners.push_back(vertices_[v]);
    for (VertexRecord& v : t.corners) {
        const glm::vec3 object(v.attributes[0], v.attributes[1], v.attributes[2]);
        v.world = transform_point(world_from_object_, object);
        v.eye = transform_point(draw_->uniforms.eye_from_object, object);
    }
    record_.triangles.push_back(std::move(t));
}

void Recorder::on(const ClipPlaneEvent& event) {
    polygon_.clear();
    for (const ClipCorner& corner : event.after) polygon_.push_back(copy(corner.varyings));
    if (!is_chosen_) return;
    PlaneRecord plane{event.plane, {}, {}};
    for (const ClipCorner& c : event.before) plane.before.push_back({c.clip, c.distance});
    for (const ClipCorner& c : event.after) plane.after.push_back({c.clip, c.distance});
    for (CornerRecord& c : plane.after) find_origin(c, plane.before);
    triangle()->planes.push_back(std::move(plane));
}

void Recorder::on(const ClipEvent& event) {
    if (!is_chosen_) return;
    triangle()->outcodes = event.outcodes;
    triangle()->clip = event.verdict;
}

void Recorder::on(const ProjectEvent& event) {
    piece_.window = event.window;
    for (std::size_t c = 0; c < 3; ++c)
        piece_.varyings[c] = polygon_.empty() ? vertices_[corners_[c]].varyings
                                              : polygon_[std::size_t(clip_fan(event.piece)[c])];
    if (!is_chosen_) return;
    PieceRecord piece;
    piece.clip = event.clip;
    piece.window = event.window;
    piece.subpixel = event.subpixel;
    for (std::size_t c = 0; c < 3; ++c) piece.ndc[c] = glm::vec3(event.clip[c]) * event.window[c].oow;
    if (!polygon_.empty()) piece.varyings = piece_.varyings;
    triangle()->pieces.push_back(std::move(piece));
}

void Recorder::on(const CullEvent& event) {
    piece_.front_facing = event.front_facing;
    if (!is_chosen_) return;
    PieceRecord& p = triangle()->pieces.back();
    p.area = event.area;
    p.front_facing = event.front_facing;
    p.verdict = event.verdict;
    if (draw_->frequency != ShadingFrequency::gouraud) return;
    for (VertexRecord& v : triangle()->corners)
        v.shading = shading_of_corner(*draw_, v.number, event.front_facing, v.varyings);
}

void Recorder::on(const SetupEvent& event) {
    const TriangleSetup& s = event.setup;
    piece_.order = s.order;
    piece_.basis = s.basis;
    piece_.oow = event.oow;
    const auto corner = [&](std::size_t i) { return std::size_t(s.order[i]); };
    piece_.affine.clear();
    for (std::size_t i = 0; i < event.varyings.size(); ++i)
        piece_.affine.push_back(make_plane(s.basis, piece_.varyings[corner(0)][i], piece_.varyings[corner(1)][i],
                                           piece_.varyings[corner(2)][i]));
    for (std::size_t i = 0; i < 3; ++i) {
        std::array<float, 3> one{};
        one[i] = 1;
        piece_.affine_weights[i] = make_plane(s.basis, one[0], one[1], one[2]);
        one[i] = record_.bug == Bug::affine ? 1 : piece_.window[corner(i)].oow;
        piece_.weights[i] = make_plane(s.basis, one[0], one[1], one[2]);
    }
    if (!is_chosen_) return;

    PieceRecord& p = triangle()->pieces.back();
    SetupRecord r;
    r.setup = s;
    r.oow = event.oow;
    r.varyings.assign(event.varyings.begin(), event.varyings.end());
    for (std::size_t i = 0; i < 3; ++i) {
        const auto &a = p.subpixel[corner(i)], &b = p.subpixel[corner((i + 1) % 3)];
        r.owned_opengl[i] = make_edge(a, b, FillRule::bottom_left).inclusive;
        r.owned_direct3d[i] = make_edge(a, b, FillRule::top_left).inclusive;
    }
    const Region& region = record_.region;
    CoverageRecord& c = r.coverage;
    c.x0 = std::max(s.box.min_x, region.x0);
    c.y0 = std::max(s.box.min_y, region.y0);
    c.width = std::max(std::min(s.box.max_x, region.x1) - c.x0 + 1, 0);
    c.height = std::max(std::min(s.box.max_y, region.y1) - c.y0 + 1, 0);
    if (c.width == 0 || c.height == 0) c.width = c.height = 0;
    p.setup = std::move(r);
}

void Recorder::on(const CoverageEvent& event) {
    if (!is_chosen_) return;
    SetupRecord& s = *setup();
    ++s.tested;
    s.covered += event.covered;
    if (in_region(event.x, event.y)) s.coverage.edges.push_back(event.edges);
}

void Recorder::on(const DepthEvent& event) {
    if (is_chosen_) setup()->passed += event.passed;
    if (!in_region(event.x, event.y)) return;
    FragmentRecord f;
    f.triangle = number_;
    f.draw = draw_number_;
    f.piece = event.piece;
    f.x = event.x;
    f.y = event.y;
    f.z = event.z;
    f.incoming = event.incoming;
    f.stored = event.stored;
    f.passed = event.passed;
    const float px = float(event.x), py = float(event.y);
    const float w = 1.0f / value_at(piece_.oow, px, py);
    for (const Plane<float>& plane : piece_.affine) f.affine.push_back(value_at(plane, px, py));
    for (std::size_t i = 0; i < 3; ++i) {
        f.affine_weights[i] = value_at(piece_.affine_weights[i], px, py);
        f.weights[i] = value_at(piece_.weights[i], px, py) * w;
    }
    record_.fragments.push_back(std::move(f));
}

FragmentRecord* Recorder::fragment(int x, int y) { return in_region(x, y) ? &record_.fragments.back() : nullptr; }

void Recorder::on(const InterpolateEvent& event) {
    FragmentRecord* f = fragment(event.x, event.y);
    if (!f) return;
    f->oow = event.oow;
    f->varyings = copy(event.varyings);
}

void Recorder::on(const FragmentEvent& event) {
    FragmentRecord* f = fragment(event.x, event.y);
    if (!f) return;
    f->outputs = copy(event.outputs);
    if (draw_->frequency == ShadingFrequency::gouraud)
        f->terms = terms_of_varyings(*draw_, piece_.front_facing, f->varyings, f->outputs);
    else
        f->shading = shading_at(*draw_, event.triangle, piece_.front_facing, record_.bug, f->varyings, f->outputs);
}

void Recorder::on(const BlendEvent& event) {
    FragmentRecord* f = fragment(event.x, event.y);
    if (!f) return;
    f->source = event.source;
    f->before = event.before;
    f->after = event.after;
}

}  // namespace raster::step
