// event_lines.h: events as the lines of a trace, one by one, for whoever wants to compare or keep them.
#pragma once

#include <string>
#include <vector>

#include <raster/trace/event_json.h>

namespace raster {

/// An observer that gives use(event number from 0, write) for every event but DrawEvent. write() gives the line without
/// its end; events whose line nobody asks for cost little.
template <class Use>
class EventLines {
public:
    explicit EventLines(Use use) : use_(std::move(use)) {}

    void on(const DrawEvent& e) {
        draw_ = e.draw;
        first_triangle_ = e.planned.uniforms.first_triangle;
        numbers_.assign(e.planned.uniforms.triangle_numbers.begin(), e.planned.uniforms.triangle_numbers.end());
    }
    void on(const VertexEvent& e) { tell(e); }
    void on(const AssembleEvent& e) {
        number_ = numbers_.empty() ? first_triangle_ + e.triangle : numbers_[std::size_t(e.triangle)];
        tell(e);
    }
    void on(const ClipEvent& e) { tell(e); }
    void on(const ClipPlaneEvent& e) { tell(e); }
    void on(const ProjectEvent& e) { tell(e); }
    void on(const CullEvent& e) { tell(e); }
    void on(const SetupEvent& e) { tell(e); }
    void on(const CoverageEvent& e) { tell(e); }
    void on(const DepthEvent& e) { tell(e); }
    void on(const InterpolateEvent& e) { tell(e); }
    void on(const FragmentEvent& e) { tell(e); }
    void on(const BlendEvent& e) { tell(e); }

private:
    template <class Event>
    void tell(const Event& e) {
        use_(count_++, [&] {
            line_.clear();
            JsonWriter json(line_);
            json.open('{');
            json.member("stage", stage_of<Event>());
            json.member("draw", draw_);
            if constexpr (requires { e.triangle; }) json.member("triangle", number_ + 1);
            write_members(json, e);
            json.close('}');
            return std::string_view(line_);
        });
    }

    Use use_;
    std::int64_t count_ = 0, number_ = 0;
    int draw_ = 0;
    std::int32_t first_triangle_ = 0;
    std::vector<std::int32_t> numbers_;
    std::string line_;
};

}  // namespace raster
