// event_lines.h: events as the lines of a trace, one by one, for whoever wants to compare or keep them.
#pragma once

#include <optional>
#include <string>

#include <raster/trace/event_json.h>

namespace raster {

/// Where an event belongs, as far as it does.
struct EventPlace {
    std::string_view stage;
    std::optional<std::int64_t> triangle;  ///< in the model, from 0
    std::optional<glm::ivec2> pixel;
};

/// An observer that gives use(event number from 0, place, write) for every event but DrawEvent. write() gives the line
/// without its end; events whose line nobody asks for cost little.
template <class Use>
class EventLines {
public:
    explicit EventLines(Use use) : use_(std::move(use)) {}

    void on(const DrawEvent& e) {
        draw_ = e.draw;
        planned_ = &e.planned;
    }
    void on(const VertexEvent& e) { tell(e); }
    void on(const AssembleEvent& e) {
        number_ = number_in_model(*planned_, e.triangle);
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
        EventPlace place{stage_of<Event>(), {}, {}};
        if constexpr (requires { e.triangle; }) place.triangle = number_;
        if constexpr (requires { e.x; }) place.pixel = {e.x, e.y};
        use_(count_++, place, [&] {
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
    const PlannedDraw* planned_ = nullptr;
    std::string line_;
};

}  // namespace raster
