// write_fragments.cpp: stages 7 to 11 at the pixels of the region as JSON.
#include <raster/step/parts.h>

namespace raster::step {
namespace {

void write(JsonText& json, const Terms<float>& terms) {
    json.object([&] {
        json.member("emission", terms.emission);
        json.member("ambient", terms.ambient);
        json.member("diffuse", terms.diffuse);
        json.member("specular", terms.specular);
    });
}

void write(JsonText& json, const LightRecord& l) {
    json.object([&] {
        json.member("light", l.light);
        json.member("l", l.l);
        json.member("strength", l.strength);
        json.member("n_l", l.n_l);
        json.member("n_v", l.n_v);
        json.member("l_v", l.l_v);
        json.member("h", l.h);
        json.member("n_h", l.n_h);
        json.member("r_v", l.r_v);
        json.member("diffuse", l.diffuse);
        json.member("specular", l.specular);
        json.member("lit_diffuse", l.lit_diffuse);
        json.member("lit_specular", l.lit_specular);
    });
}

}  // namespace

void write(JsonText& json, const ShadingRecord& s) {
    json.object([&] {
        json.member("where", s.where);
        json.member("position_eye", s.position_eye);
        json.member("n", s.n);
        json.member("v", s.v);
        json.array("lights", [&] {
            for (const LightRecord& l : s.lights) write(json, l);
        });
        json.member("sum_diffuse", s.sum_diffuse);
        json.member("sum_specular", s.sum_specular);
        json.member("ka", s.ka);
        json.member("kd", s.kd);
        json.member("ks", s.ks);
        json.member("emission", s.emission);
        json.member("ambient", s.ambient);
        json.member("alpha", s.alpha);
        json.key("terms"), write(json, s.terms);
        json.member("agrees", s.agrees);
    });
}

void write_fragments(JsonText& json, const Scene& scene, const Record& record) {
    const Display& display = scene.step.display;
    json.array("fragments", [&] {
        for (const FragmentRecord& f : record.fragments) {
            json.object([&] {
                json.member("triangle", f.triangle + 1);
                json.member("draw", f.draw);
                json.member("piece", f.piece);
                json.member("x", f.x);
                json.member("y", f.y);
                json.member("z", f.z);
                json.member("incoming", f.incoming);
                json.member("stored", f.stored);
                json.member("passed", f.passed);
                if (f.passed) json.member("after", f.after);
                if (f.passed && !display.is_plain())
                    json.array("shown", [&] {
                        for (int c = 0; c < 3; ++c) json.value(to_unorm8(shown_value(f.after[c], display)));
                    });
                if (!f.detailed) return;
                json.member("detailed", true);
                json.member("weights", f.weights);
                json.member("affine_weights", f.affine_weights);
                if (!f.passed) return;
                json.member("oow", f.oow);
                json.member("affine", f.affine);
                json.member("varyings", f.varyings);
                json.member("outputs", f.outputs);
                if (f.terms) json.key("terms"), write(json, *f.terms);
                json.member("source", f.source);
                json.array("bytes", [&] {
                    for (int c = 0; c < 4; ++c) json.value(to_unorm8(f.source[c]));
                });
                json.member("before", f.before);
                if (f.shading) json.key("shading"), write(json, *f.shading);
            });
        }
    });
    json.array("painted", [&] {
        for (const PaintedRecord& p : record.painted) {
            json.array([&] {
                json.value(p.x), json.value(p.y), json.value(p.triangle + 1), json.value(p.z);
                for (int c = 0; c < 4; ++c) json.value(p.after[c]);
            });
        }
    });
}

}  // namespace raster::step
