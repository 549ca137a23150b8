// write_triangles.cpp: stages 1 to 7 as JSON.
#include <raster/step/parts.h>
#include <raster/trace/event_json.h>

namespace raster::step {
namespace {

void write(JsonText& json, const Plane<float>& p) {
    json.array([&] { json.value(p.origin), json.value(p.dadx), json.value(p.dady); });
}

/// Values as runs of equal steps: start, step, count, start, step, count, ...
void write_runs(JsonText& json, const std::vector<std::array<std::int64_t, 3>>& edges, std::size_t k) {
    json.array([&] {
        for (std::size_t i = 0; i < edges.size();) {
            std::size_t end = i + 1;
            const std::int64_t step = end < edges.size() ? edges[end][k] - edges[i][k] : 0;
            while (end < edges.size() && edges[end][k] - edges[end - 1][k] == step) ++end;
            json.value(edges[i][k]), json.value(step), json.value(end - i);
            i = end;
        }
    });
}

void write(JsonText& json, const std::vector<CornerRecord>& polygon) {
    json.array([&] {
        for (const CornerRecord& c : polygon) {
            json.object([&] {
                json.member("clip", c.clip);
                json.member("distance", c.distance);
                if (c.from < 0) return;
                json.member("from", c.from);
                json.member("to", c.to);
                json.member("t", c.t);
            });
        }
    });
}

void write(JsonText& json, const SetupRecord& r) {
    const TriangleSetup& s = r.setup;
    json.object([&] {
        json.member("order", s.order);
        json.array("edges", [&] {
            for (std::size_t i = 0; i < 3; ++i) {
                const Edge<float>& e = s.edges[i];
                json.object([&] {
                    json.member("step_x", e.step_x);
                    json.member("step_y", e.step_y);
                    json.member("origin", e.origin);
                    json.member("inclusive", bool(e.inclusive));
                    json.member("opengl", r.owned_opengl[i]);
                    json.member("direct3d", r.owned_direct3d[i]);
                });
            }
        });
        json.key("depth"), write(json, s.depth);
        json.key("oow"), write(json, r.oow);
        json.array("planes", [&] {
            for (const Plane<float>& p : r.varyings) write(json, p);
        });
        json.array("box", [&] {
            json.value(s.box.min_x), json.value(s.box.min_y), json.value(s.box.max_x), json.value(s.box.max_y);
        });
        json.member("tested", r.tested);
        json.member("covered", r.covered);
        json.member("passed", r.passed);
        json.object("coverage", [&] {
            const CoverageRecord& c = r.coverage;
            json.array("rect", [&] { json.value(c.x0), json.value(c.y0), json.value(c.width), json.value(c.height); });
            json.array("runs", [&] {
                for (std::size_t k = 0; k < 3; ++k) write_runs(json, c.edges, k);
            });
        });
    });
}

void write(JsonText& json, const PieceRecord& p) {
    json.object([&] {
        json.member("clip", p.clip);
        json.member("ndc", p.ndc);
        if (!p.varyings[0].empty()) json.member("varyings", p.varyings);
        json.array("window", [&] {
            for (const WindowVertex<float>& v : p.window)
                json.array([&] { json.value(v.x), json.value(v.y), json.value(v.z), json.value(v.oow); });
        });
        json.array("subpixel", [&] {
            for (const SubpixelVertex<float>& v : p.subpixel) json.array([&] { json.value(v.x), json.value(v.y); });
        });
        json.member("area", p.area);
        json.member("front_facing", p.front_facing);
        json.member("verdict", word_for(p.verdict));
        if (p.setup) json.key("setup"), write(json, *p.setup);
    });
}

}  // namespace

void write_triangles(JsonText& json, const Record& record) {
    json.array("triangles", [&] {
        for (const TriangleRecord& t : record.triangles) {
            json.object([&] {
                json.member("number", t.number + 1);
                json.member("order", t.order);
                json.member("draw", t.draw);
                json.member("why", t.why);
                json.member("vertices", t.vertices);
                if (t.bad_index) json.member("bad_index", true);
                json.array("corners", [&] {
                    for (const VertexRecord& v : t.corners) {
                        json.object([&] {
                            json.member("vertex", v.number);
                            json.member("attributes", v.attributes);
                            json.member("world", v.world);
                            json.member("eye", v.eye);
                            json.member("clip", v.clip);
                            json.member("varyings", v.varyings);
                            if (v.shading) json.key("shading"), write(json, *v.shading);
                        });
                    }
                });
                if (!t.clip) return;
                json.member("outcodes", t.outcodes);
                json.member("clip", word_for(*t.clip));
                json.array("planes", [&] {
                    for (const PlaneRecord& p : t.planes) {
                        json.object([&] {
                            json.member("plane", word_for(p.plane));
                            json.key("before"), write(json, p.before);
                            json.key("after"), write(json, p.after);
                        });
                    }
                });
                json.array("pieces", [&] {
                    for (const PieceRecord& p : t.pieces) write(json, p);
                });
            });
        }
    });
}

}  // namespace raster::step
