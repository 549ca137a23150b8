// survey.h: a first observed run, which only looks where things are; and the choice of what the page will hold.
#pragma once

#include <map>

#include <raster/step/record.h>
#include <raster/trace/events.h>

namespace raster::step {

/// What becomes of the triangles, in few bytes each.
class Survey {
public:
    Survey(int width, int height)
        : width_(width), height_(height), covered_(std::size_t(width) * std::size_t(height)) {}

    void on(const DrawEvent& event);
    void on(const AssembleEvent& event);
    void on(const ClipEvent& event);
    void on(const CullEvent& event);
    void on(const SetupEvent& event);
    void on(const CoverageEvent& event);

    /// A pixel that several triangles cover, near the middle of those.
    glm::ivec2 busy_pixel() const;
    /// A pixel near the middle of those that a triangle covers; or of its box; nothing when it was not set up.
    std::optional<glm::ivec2> pixel_of(std::int64_t triangle) const;
    /// The triangles that the page will show, by number in the model, and why.
    std::map<std::int64_t, std::string> choose(int max_triangles, const std::optional<std::int64_t>& first,
                                               glm::ivec2 pixel, const Region& region) const;
    /// How many triangles cover something of the region.
    std::int64_t count_in(const Region& region) const;

private:
    enum class Fate { drawn, bad_index, not_finite, outside, culled, zero_area };
    struct Surveyed {
        std::int64_t number;
        Fate fate = Fate::drawn;
        bool clipped = false;
    };
    struct Piece {
        std::size_t triangle;  ///< into triangles_
        PixelBox box;
        std::array<Edge<float>, 3> edges;
        bool covers(int x, int y) const;
        int distance_to(glm::ivec2 pixel) const;
    };
    struct Tie {
        std::size_t triangle;
        int x, y;
    };

    int width_, height_;
    const PlannedDraw* draw_ = nullptr;
    std::vector<Surveyed> triangles_;
    std::vector<Piece> pieces_;
    std::vector<Tie> ties_;
    std::vector<std::uint16_t> covered_;  ///< how often, a pixel
};

}  // namespace raster::step
