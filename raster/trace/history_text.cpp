// history_text.cpp: a pixel's history in words.
#include <raster/trace/history_text.h>

#include <cstdio>

#include <raster/stages/coverage.h>
#include <raster/trace/event_json.h>

namespace raster {
namespace {

constexpr int most_lines_of_a_fate = 24;

template <class... T>
std::string format(const char* pattern, T... values) {
    char text[256];
    std::snprintf(text, sizeof text, pattern, values...);
    return text;
}

std::string hex(const glm::vec4& color) {
    const auto c = std::uint32_t(pack_rgba8(color));
    std::string text = format("#%02X%02X%02X", c & 255, c >> 8 & 255, c >> 16 & 255);
    if (c >> 24 != 255) text += format("%02X", c >> 24);
    return text;
}

std::string numbers(const glm::vec3& v) { return format("(%.4g, %.4g, %.4g)", double(v.x), double(v.y), double(v.z)); }

const char* symbol(Compare compare) {
    switch (compare) {
        case Compare::never: return "never";
        case Compare::less: return "<";
        case Compare::equal: return "==";
        case Compare::less_equal: return "<=";
        case Compare::greater: return ">";
        case Compare::not_equal: return "!=";
        case Compare::greater_equal: return ">=";
        case Compare::always: break;
    }
    return "always";
}

const char* rule_name(FillRule rule) { return rule == FillRule::bottom_left ? "bottom-left rule" : "top-left rule"; }

/// Both depths with as many decimals as it takes to tell them apart.
std::string depths(const DepthEvent& d, DepthFormat format_of_depth, Compare compare) {
    const double in = double(decode_depth(format_of_depth, d.incoming));
    const double stored = double(decode_depth(format_of_depth, d.stored));
    for (int decimals = 4; decimals <= 9; ++decimals) {
        const std::string a = format("%.*f", decimals, in), b = format("%.*f", decimals, stored);
        if (a == b && d.incoming != d.stored && decimals < 9) continue;
        const std::string result = compare == Compare::always ? "not compared" : d.passed ? "pass" : "fail";
        std::string text = "z=" + a + " " + symbol(compare) + " " + b + "  " + result;
        if (d.incoming == d.stored && compare != Compare::always) text += "  (equal depths)";
        return text;
    }
    return "";
}

class Text {
public:
    explicit Text(const PixelHistory& history) : h_(history) {}

    std::string all() {
        std::string text = format("pixel (%d,%d) = ", h_.x, h_.y) + hex(h_.color) + "   VERDICT: " + verdict() + "\n";
        std::array<int, 6> shown{}, left_out{};
        for (const HistoryEntry& e : h_.entries) {
            const auto fate = std::size_t(e.fate);
            const bool matters = &e == decisive() || e.visible;
            if (shown[fate] >= most_lines_of_a_fate && !matters) {
                ++left_out[fate];
                continue;
            }
            ++shown[fate];
            text += line(e);
        }
        for (std::size_t i = 0; i < left_out.size(); ++i)
            if (left_out[i] > 0)
                text += format(" and %d more: ", left_out[i]) + word(PixelFate(i)) + " (--json lists all)\n";
        if (h_.counts.not_finite > 0)
            text += format(" somewhere: %lld dropped, since a corner is no finite number\n",
                           static_cast<long long>(h_.counts.not_finite));
        return text;
    }

    std::string verdict() const {
        const HistoryEntry* e = decisive();
        const int lost = h_.count(PixelFate::lost), wrote = h_.count(PixelFate::wrote);
        std::string text = to_string(h_.verdict);
        switch (h_.verdict) {
            case PixelVerdict::won: return text + ", " + e->name() + " " + how_won(*e, lost, wrote);
            case PixelVerdict::all_rejected:
                return text + "(depth), " + std::to_string(lost) + " covered it and failed the depth test";
            case PixelVerdict::clipped:
                return text + "(" + word_for(e->cut_by[0]) + "), " + e->name() + " would be here";
            case PixelVerdict::culled: return text + ", " + e->name() + " would be here and faces the wrong way";
            case PixelVerdict::never_covered:
                return text + ", " + e->name() + format(" comes nearest, %.2g pixels away; ", e->distance) +
                       rejection(*e);
            case PixelVerdict::nan: return text + ", " + e->name() + " gave something that is not a number";
            case PixelVerdict::background: break;
        }
        text += ", nothing is here";
        if (h_.nearest)
            text += "; the nearest is " + h_.nearest->name() + format(", %.4g pixels away", h_.nearest->distance);
        return text;
    }

private:
    const HistoryEntry* decisive() const { return h_.decisive ? &h_.entries[*h_.decisive] : nullptr; }
    const State& state(const HistoryEntry& e) const { return h_.draw_of(e).state; }

    std::string how_won(const HistoryEntry& e, int lost, int wrote) const {
        const int below = wrote - 1;
        std::string text;
        if (state(e).blend != Blend::off) {
            int seen = 0;
            for (const HistoryEntry& other : h_.entries) seen += other.visible;
            text = seen > 1 ? format("on top, with %d seen through it", seen - 1) : "over the background";
        } else if (state(e).depth_compare == Compare::always) {
            text = below > 0 ? "by being drawn last" : "alone";
        } else {
            text = lost + below > 0 ? "by depth" : "alone";
        }
        const int others = lost + (state(e).blend == Blend::off ? below : 0);
        if (others > 0) text += format("; %d other%s lost", others, others == 1 ? "" : "s");
        return text;
    }

    static const char* word(PixelFate fate) {
        switch (fate) {
            case PixelFate::wrote:
            case PixelFate::lost: return "covered";
            case PixelFate::near: return "rejected";
            case PixelFate::clipped: return "clipped";
            case PixelFate::culled: return "culled";
            case PixelFate::zero_area: break;
        }
        return "no area";
    }

    /// e=(5120,0*,12): exact, in square subpixels; a star where the centre is on the edge.
    static std::string edges(const HistoryEntry& e) {
        std::string text = "e=(";
        for (int i = 0; i < 3; ++i) {
            text += std::to_string(e.pixel()->coverage.edges[std::size_t(i)]);
            if (e.is_tie(i)) text += '*';
            text += i < 2 ? "," : ")";
        }
        return text;
    }

    /// Which edge keeps the pixel out.
    std::string rejection(const HistoryEntry& e) const {
        const int i = e.rejecting_edge();
        if (i < 0) return "";
        const Edge<float>& edge = e.setup()->setup.edges[std::size_t(i)];
        const std::string name = format("e%d is a %s edge", i, to_string(side_of(edge)));
        const std::int64_t value = e.pixel()->coverage.edges[std::size_t(i)];
        if (value == 0) return name + ", not owned (" + rule_name(state(e).fill_rule) + ")" + owner(e);
        return name + format(" and %lld < 0", static_cast<long long>(value));
    }

    /// Who has the centre that lies on an edge of e.
    std::string owner(const HistoryEntry& e) const {
        for (const HistoryEntry& other : h_.entries)
            if (&other != &e && other.pixel() && other.pixel()->coverage.covered &&
                (other.is_tie(0) || other.is_tie(1) || other.is_tie(2)))
                return "; #" + std::to_string(other.triangle.number + 1) + " owns it";
        return "";
    }

    std::string ties(const HistoryEntry& e) const {
        std::string text;
        for (int i = 0; i < 3; ++i)
            if (e.is_tie(i))
                text +=
                    format("   * tie: e%d == 0, %s edge, owned (%s)", i,
                           to_string(side_of(e.setup()->setup.edges[std::size_t(i)])), rule_name(state(e).fill_rule));
        return text;
    }

    std::string line(const HistoryEntry& e) const {
        std::string text = format(" %-7s %-8s ", ("#" + std::to_string(e.triangle.number + 1)).c_str(), word(e.fate));
        if (e.triangle.clip && e.triangle.clip->verdict == ClipEvent::Verdict::clipped && !e.triangle.pieces.empty())
            text += format("[piece %d] ", e.piece());
        switch (e.fate) {
            case PixelFate::wrote:
            case PixelFate::lost: return text + covered(e);
            case PixelFate::near: return text + edges(e) + "  " + rejection(e) + format("; %.2g px away\n", e.distance);
            case PixelFate::clipped: return text + clipped(e) + "\n";
            case PixelFate::culled:
                return text + format("area=%lld, a %s face; coverage was not reached\n",
                                     static_cast<long long>(e.triangle.pieces[0].cull->area),
                                     e.triangle.pieces[0].cull->front_facing ? "front" : "back");
            case PixelFate::zero_area: break;
        }
        return text + format("area=0 on the subpixel grid; %.2g px away; coverage was not reached\n", e.distance);
    }

    std::string covered(const HistoryEntry& e) const {
        const RecordedPixel& pixel = *e.pixel();
        std::string text = edges(e);
        if (pixel.depth) text += "  " + depths(*pixel.depth, h_.depth_format, state(e).depth_compare);
        if (pixel.blend) {
            text += "  -> " + hex(pixel.blend->after);
            if (state(e).blend != Blend::off)
                text += " = " + hex(pixel.blend->source) +
                        (state(e).blend == Blend::source_over ? " over " : " plus ") + hex(pixel.blend->before);
            if (!e.visible) text += "  hidden later";
        }
        text += ties(e) + "\n";
        if (e.visible && pixel.blend) {
            text += "         colour " + numbers(pixel.blend->source);
            if (e.terms) {
                text += " = ambient " + numbers(e.terms->ambient) + " + diffuse " + numbers(e.terms->diffuse) +
                        " + specular " + numbers(e.terms->specular);
                if (e.terms->emission != glm::vec3(0.0f)) text += " + emission " + numbers(e.terms->emission);
                text += "\n         normal " + numbers(e.terms->normal_world) + " in the world";
            }
            if (state(e).blend != Blend::off) text += format(", alpha %.4g", double(pixel.blend->source.a));
            text += "\n";
            if (!e.corners.empty()) text += "         Gouraud shading lights the corners, and the pixel gets of\n";
            for (std::size_t i = 0; i < e.corners.size(); ++i) {
                const CornerLight& c = e.corners[i];
                text += format("           v%d %7.4f x light, diffuse ", int(i), double(c.weight)) +
                        numbers(c.diffuse) + " specular " + numbers(c.specular) + "\n";
            }
        }
        return text;
    }

    /// The plane, and how far outside the corner is that is farthest out.
    static std::string clipped(const HistoryEntry& e) {
        std::string text = "away by the " + std::string(word_for(e.cut_by[0])) + " plane; ";
        const ClipEvent& clip = *e.triangle.clip;
        const int plane = int(e.cut_by[0]);
        int outside = 0;
        for (const std::int32_t code : clip.outcodes) outside += code >> plane & 1;
        text += format("%d of 3 corners %s outside", outside, outside == 1 ? "is" : "are");
        if (plane >= clip_plane_count) return text;
        const int worst = std::min({0, 1, 2}, [&](int a, int b) {
            return clip_distance(e.cut_by[0], clip.clip[a]) < clip_distance(e.cut_by[0], clip.clip[b]);
        });
        const glm::vec4& c = clip.clip[std::size_t(worst)];
        text += format(plane == int(ClipPlane::far) ? " (z = %.4g > w = %.4g)" : " (z = %.4g < -w = %.4g)", double(c.z),
                       double(plane == int(ClipPlane::far) ? c.w : -c.w));
        return text;
    }

    const PixelHistory& h_;
};

}  // namespace

std::string history_text(const PixelHistory& history) { return Text(history).all(); }

std::string verdict_text(const PixelHistory& history) { return Text(history).verdict(); }

}  // namespace raster
