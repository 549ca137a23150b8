// survey.cpp: the interesting pixel, and the triangles to show.
#include <raster/step/survey.h>

#include <algorithm>

#include <raster/stages/coverage.h>

namespace raster::step {
namespace {

constexpr std::size_t max_ties = 100000;

std::int64_t squared(std::int64_t x) { return x * x; }

}  // namespace

bool Survey::Piece::covers(int x, int y) const {
    if (x < box.min_x || x > box.max_x || y < box.min_y || y > box.max_y) return false;
    return std::ranges::all_of(edges, [&](const Edge<float>& e) { return is_inside(e, edge_at(e, x, y)); });
}

int Survey::Piece::distance_to(glm::ivec2 pixel) const {
    const int dx = std::max({box.min_x - pixel.x, pixel.x - box.max_x, 0});
    const int dy = std::max({box.min_y - pixel.y, pixel.y - box.max_y, 0});
    return std::max(dx, dy);
}

void Survey::on(const DrawEvent& event) { draw_ = &event.planned; }

void Survey::on(const AssembleEvent& event) {
    triangles_.push_back(
        {number_in_model(*draw_, event.triangle), event.bad_index ? Fate::bad_index : Fate::drawn, false});
}

void Survey::on(const ClipEvent& event) {
    Surveyed& t = triangles_.back();
    t.clipped = event.verdict == ClipEvent::Verdict::clipped;
    if (event.verdict == ClipEvent::Verdict::not_finite) t.fate = Fate::not_finite;
    else if (event.pieces == 0) t.fate = Fate::outside;
}

void Survey::on(const CullEvent& event) {
    if (event.verdict == CullEvent::Verdict::culled) triangles_.back().fate = Fate::culled;
    if (event.verdict == CullEvent::Verdict::zero_area && triangles_.back().fate == Fate::drawn)
        triangles_.back().fate = Fate::zero_area;
}

void Survey::on(const SetupEvent& event) {
    triangles_.back().fate = Fate::drawn;
    pieces_.push_back({triangles_.size() - 1, event.setup.box, event.setup.edges});
}

void Survey::on(const CoverageEvent& event) {
    if (event.covered) ++covered_[std::size_t(event.y) * std::size_t(width_) + std::size_t(event.x)];
    const bool on_an_edge = std::ranges::any_of(event.edges, [](std::int64_t e) { return e == 0; });
    const bool outside = std::ranges::any_of(event.edges, [](std::int64_t e) { return e < 0; });
    if (on_an_edge && !outside && ties_.size() < max_ties) ties_.push_back({triangles_.size() - 1, event.x, event.y});
}

glm::ivec2 Survey::busy_pixel() const {
    // Two or three surfaces show the depth test; more of them only make the page long.
    const auto worth = [](int count) { return std::min(count, 3); };
    int best = 0;
    for (const std::uint16_t count : covered_) best = std::max(best, worth(count));
    std::int64_t sum_x = 0, sum_y = 0, sum = 0;
    const auto for_each_best = [&](const auto& visit) {
        for (int y = 0; y < height_; ++y)
            for (int x = 0; x < width_; ++x)
                if (worth(covered_[std::size_t(y) * std::size_t(width_) + std::size_t(x)]) == best) visit(x, y);
    };
    for_each_best([&](int x, int y) { sum_x += x, sum_y += y, ++sum; });
    const glm::ivec2 middle(int(sum_x / sum), int(sum_y / sum));
    glm::ivec2 nearest = middle;
    std::int64_t distance = INT64_MAX;
    for_each_best([&](int x, int y) {
        const std::int64_t d = squared(x - middle.x) + squared(y - middle.y);
        if (d < distance) distance = d, nearest = {x, y};
    });
    return nearest;
}

std::optional<glm::ivec2> Survey::pixel_of(std::int64_t triangle) const {
    for (const Piece& piece : pieces_) {
        if (triangles_[piece.triangle].number != triangle || piece.box.empty()) continue;
        const glm::ivec2 middle((piece.box.min_x + piece.box.max_x) / 2, (piece.box.min_y + piece.box.max_y) / 2);
        glm::ivec2 nearest = middle;
        std::int64_t distance = INT64_MAX;
        for (int y = piece.box.min_y; y <= piece.box.max_y; ++y) {
            for (int x = piece.box.min_x; x <= piece.box.max_x; ++x) {
                const std::int64_t d = squared(x - middle.x) + squared(y - middle.y);
                if (d < distance && piece.covers(x, y)) distance = d, nearest = {x, y};
            }
        }
        return nearest;
    }
    return std::nullopt;
}

std::map<std::int64_t, std::string> Survey::choose(int max_triangles, const std::optional<std::int64_t>& first,
                                                   glm::ivec2 pixel, const Region& region) const {
    std::map<std::int64_t, std::string> chosen;
    const auto room = [&] { return int(chosen.size()) < max_triangles; };
    const auto take = [&](std::int64_t number, const char* why) {
        if (room()) chosen.emplace(number, why);
    };
    if (first) take(*first, "is shown first");
    for (const Piece& piece : pieces_)
        if (piece.covers(pixel.x, pixel.y)) take(triangles_[piece.triangle].number, "covers the pixel");

    const Tie* tie = nullptr;
    const auto distance = [&](const Tie& t) { return squared(t.x - pixel.x) + squared(t.y - pixel.y); };
    for (const Tie& t : ties_)
        if (region.holds(t.x, t.y) && (!tie || distance(t) < distance(*tie))) tie = &t;
    if (tie)
        for (const Tie& t : ties_)
            if (t.x == tie->x && t.y == tie->y) take(triangles_[t.triangle].number, "has a pixel centre on its edge");

    // One of each fate, so that every stage has something to show.
    const auto specimen = [&](const auto& is_one, const char* why) {
        const auto found = std::ranges::find_if(triangles_, is_one);
        if (found != triangles_.end()) take(found->number, why);
    };
    specimen([](const Surveyed& t) { return t.clipped && t.fate == Fate::drawn; }, "is cut by the view volume");
    specimen([](const Surveyed& t) { return t.fate == Fate::outside; }, "lies outside the view volume");
    specimen([](const Surveyed& t) { return t.fate == Fate::culled; }, "faces the wrong way");
    specimen([](const Surveyed& t) { return t.fate == Fate::zero_area; }, "has no area after snapping");
    specimen([](const Surveyed& t) { return t.fate == Fate::not_finite; }, "has a corner that is no number");
    specimen([](const Surveyed& t) { return t.fate == Fate::bad_index; }, "names a vertex that is not there");

    std::vector<std::pair<int, std::size_t>> near;
    for (const Piece& piece : pieces_)
        if (!piece.box.empty()) near.emplace_back(piece.distance_to(pixel), piece.triangle);
    std::ranges::sort(near);
    for (const auto& [d, triangle] : near)
        take(triangles_[triangle].number, d == 0 ? "nearly covers the pixel" : "lies near the pixel");
    for (const Surveyed& t : triangles_) take(t.number, "fills the page's room");
    return chosen;
}

std::int64_t Survey::count_in(const Region& region) const {
    return std::ranges::count_if(pieces_, [&](const Piece& p) {
        return !p.box.empty() && p.box.min_x <= region.x1 && p.box.max_x >= region.x0 && p.box.min_y <= region.y1 &&
               p.box.max_y >= region.y0;
    });
}

}  // namespace raster::step
