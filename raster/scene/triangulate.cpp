// triangulate.cpp: ear clipping, with a tree that finds what lies in an ear.
#include <raster/scene/triangulate.h>

#include <algorithm>
#include <cmath>

namespace raster {
namespace {

constexpr std::uint32_t leaf_size = 8;

/// Twice the signed area of abc, positive if it runs counter-clockwise. The differences of floats are exact in
/// double unless their exponents lie far apart, so for sane polygons the sign is too.
double signed_area(const glm::vec2& a, const glm::vec2& b, const glm::vec2& c) {
    const glm::dvec2 p(a), q(b), r(c);
    return (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x);
}

/// Newell's method: the sum of the edges' cross products is twice the vector area, also of a bent polygon.
glm::dvec3 vector_area(std::span<const glm::vec3> corners) {
    glm::dvec3 sum(0.0);
    const glm::dvec3 origin(corners[0]);
    for (std::size_t i = 1; i + 1 < corners.size(); ++i)
        sum += glm::cross(glm::dvec3(corners[i]) - origin, glm::dvec3(corners[i + 1]) - origin);
    return sum;
}

/// A coordinate system across the polygon's normal, for polygons that are not flat.
struct Plane {
    glm::dvec3 origin, u, v;
    bool is_bent;

    glm::vec2 project(const glm::vec3& p) const {
        const glm::dvec3 d = glm::dvec3(p) - origin;
        return glm::vec2(glm::dvec2(glm::dot(d, u), glm::dot(d, v)));
    }
};

Plane make_plane(std::span<const glm::vec3> corners, const glm::dvec3& area) {
    const double length = std::sqrt(glm::dot(area, area));
    if (!(length > 0)) return {};
    const glm::dvec3 n = area / length;
    double out = 0, extent = 0;
    for (const glm::vec3& p : corners) {
        const glm::dvec3 d = glm::dvec3(p) - glm::dvec3(corners[0]);
        out = std::max(out, std::abs(glm::dot(d, n)));
        extent = std::max({extent, std::abs(d.x), std::abs(d.y), std::abs(d.z)});
    }
    // Across the axis that is farthest from the normal.
    const glm::dvec3 size = glm::abs(n);
    glm::dvec3 axis(0, 0, 1);
    if (size.x <= size.y && size.x <= size.z) {
        axis = {1, 0, 0};
    } else if (size.y <= size.z) {
        axis = {0, 1, 0};
    }
    const glm::dvec3 u = glm::cross(axis, n), v = glm::cross(n, u);
    return {glm::dvec3(corners[0]), u / std::sqrt(glm::dot(u, u)), v / std::sqrt(glm::dot(v, v)), out > 1e-4 * extent};
}

/// The bits of x at the even places.
std::uint32_t spread(std::uint32_t x) {
    x = (x | (x << 8)) & 0x00ff00ffu;
    x = (x | (x << 4)) & 0x0f0f0f0fu;
    x = (x | (x << 2)) & 0x33333333u;
    return (x | (x << 1)) & 0x55555555u;
}

std::uint32_t grid_cell(float x, float low, float high) {
    const double extent = double(high) - double(low);
    return extent > 0 ? std::uint32_t((double(x) - double(low)) / extent * 65535.0) : 0u;
}

}  // namespace

bool has_zero_area(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
    const glm::dvec3 n = glm::cross(glm::dvec3(b) - glm::dvec3(a), glm::dvec3(c) - glm::dvec3(a));
    return n.x == 0 && n.y == 0 && n.z == 0;
}

void Triangulator::operator()(std::span<const glm::vec3> corners, std::vector<std::uint32_t>& triangles) {
    if (corners.size() < 3) return;
    if (corners.size() == 3) {
        if (!has_zero_area(corners[0], corners[1], corners[2])) triangles.insert(triangles.end(), {0, 1, 2});
        return;
    }
    corners_ = corners;
    triangles_ = &triangles;
    const bool has_plane = project();
    if (ring_.size() < 3) return;
    if (!has_plane) return fan_in_space(0);
    if (fan_from(0) || (ring_.size() == 4 && fan_from(1))) return;
    clip_ears();
}

/// Fills ring_ with the corners as seen, without repetitions in a row. False if there is nowhere to see them from.
bool Triangulator::project() {
    const glm::dvec3 area = vector_area(corners_);
    const glm::dvec3 size = glm::abs(area);
    // Two of the three coordinates, in the order that makes the area positive. They are exact, unlike those along
    // the normal, so whatever is collinear stays so.
    int u = 0, v = 1;
    double chosen = area.z;
    if (size.x > size.y && size.x > size.z) {
        u = 1, v = 2, chosen = area.x;
    } else if (size.y > size.z) {
        u = 2, v = 0, chosen = area.y;
    }
    if (chosen < 0) std::swap(u, v);
    const Plane plane = make_plane(corners_, area);

    ring_.clear();
    const glm::vec3* last = &corners_.back();
    for (std::uint32_t i = 0; i < corners_.size(); ++i) {
        const glm::vec3& p = corners_[i];
        const glm::vec2 at = plane.is_bent ? plane.project(p) : glm::vec2(p[u], p[v]);
        if (p != *last) ring_.push_back({at, i, 0, 0, 0, 0, false, true});
        last = &p;
    }
    left_ = std::uint32_t(ring_.size());
    for (std::uint32_t i = 0; i < left_; ++i) {
        ring_[i].previous = i == 0 ? left_ - 1 : i - 1;
        ring_[i].next = i + 1 == left_ ? 0 : i + 1;
    }
    return chosen != 0;
}

double Triangulator::turn(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
    return signed_area(ring_[a].at, ring_[b].at, ring_[c].at);
}

/// The fan is right if the directions from the apex to the other corners turn one way and less than half a
/// circle: then the apex sees all of the polygon.
bool Triangulator::fan_from(std::uint32_t apex) {
    const auto n = std::uint32_t(ring_.size());
    const auto nth = [&](std::uint32_t i) { return apex + i < n ? apex + i : apex + i - n; };
    for (std::uint32_t i = 1; i + 1 < n; ++i)
        if (!(turn(apex, nth(i), nth(i + 1)) > 0 && turn(apex, nth(1), nth(i + 1)) > 0)) return false;
    fan_in_space(apex);
    return true;
}

/// A fan from the apex over what is left, whatever its shape. For what has no plane to be seen on, such as a bow tie
/// of equal halves, it is as good as any.
void Triangulator::fan_in_space(std::uint32_t apex) {
    for (std::uint32_t b = ring_[apex].next; left_ > 2 && ring_[b].next != apex; b = ring_[b].next)
        emit(apex, b, ring_[b].next);
}

void Triangulator::emit(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    const std::uint32_t corner[] = {ring_[a].corner, ring_[b].corner, ring_[c].corner};
    if (!has_zero_area(corners_[corner[0]], corners_[corner[1]], corners_[corner[2]]))
        triangles_->insert(triangles_->end(), std::begin(corner), std::end(corner));
}

// ------------------------------------------------------------------------------------------------ clipping

void Triangulator::clip_ears() {
    plant_tree();
    for (std::uint32_t v = 0; v < ring_.size(); ++v) classify(v);
    enqueue_all();
    // Cutting an ear changes the standing of its two neighbours only (O'Rourke, Computational Geometry in C,
    // 1.4), so each cut queues two candidates anew. A polygon that crosses itself, or whose plane is in doubt,
    // can run out of ears; then one is forced. Past a budget nothing is tested any more, which bounds the time:
    // each polygon has its share, and wild ones live on savings. A simple polygon of 30,000 corners was never
    // seen to need more than half of its budget.
    const auto n = std::int64_t(ring_.size());
    const std::int64_t share = 100 * n, when_forced = 250 * n;
    const std::int64_t budget = std::min(n * std::int64_t(300 + 4 * std::sqrt(double(n))), share + savings_ / 4);
    visits_ = budget;
    Care care = Care::full;
    std::uint32_t some = 0;  // a vertex that is still there
    while (left_ > 3) {
        if (queue_head_ == queue_.size()) {
            while (!ring_[some].alive) ++some;
            if (care == Care::none || !force_one(some)) break;
            visits_ = std::min(visits_, when_forced) - left_;
            enqueue_all();
            continue;
        }
        const Candidate candidate = queue_[queue_head_++];
        const std::uint32_t v = candidate.vertex;
        if (visits_ < 0) care = Care::none;
        // One whose neighbours changed since stands further back in the queue; taking turns avoids slivers.
        if (!ring_[v].alive || ring_[v].version != candidate.version) continue;
        if (is_spike(v) || is_ear(v, care)) clip(v);
    }
    savings_ = std::max(savings_ - std::max(budget - visits_ - share, std::int64_t(0)), std::int64_t(0));
    while (!ring_[some].alive) ++some;
    fan_in_space(some);  // the last triangle; or, of a polygon with no convex corner left, the rest as it comes
}

void Triangulator::clip(std::uint32_t v) {
    emit(ring_[v].previous, v, ring_[v].next);
    remove(v);
}

void Triangulator::remove(std::uint32_t v) {
    const std::uint32_t before = ring_[v].previous, after = ring_[v].next;
    set_blocks(v, false);
    ring_[v].alive = false;
    ring_[before].next = after;
    ring_[after].previous = before;
    --left_;
    for (const std::uint32_t w : {before, after}) {
        ++ring_[w].version;
        classify(w);
        enqueue(w);
    }
}

void Triangulator::enqueue_all() {
    queue_.clear();
    queue_head_ = 0;
    for (std::uint32_t v = 0; v < ring_.size(); ++v)
        if (ring_[v].alive) enqueue(v);
}

void Triangulator::enqueue(std::uint32_t v) { queue_.push_back({v, ring_[v].version}); }

void Triangulator::classify(std::uint32_t v) { set_blocks(v, !(turn(ring_[v].previous, v, ring_[v].next) > 0)); }

/// A way out and straight back, or two corners in one place. It holds no area, unless the polygon is bent.
bool Triangulator::is_spike(std::uint32_t v) const {
    const glm::dvec2 here(ring_[v].at);
    const glm::dvec2 to_previous = glm::dvec2(ring_[ring_[v].previous].at) - here;
    const glm::dvec2 to_next = glm::dvec2(ring_[ring_[v].next].at) - here;
    if (to_previous == glm::dvec2(0) || to_next == glm::dvec2(0)) return true;
    return to_previous.x * to_next.y == to_previous.y * to_next.x &&
           to_previous.x * to_next.x + to_previous.y * to_next.y > 0;
}

bool Triangulator::is_ear(std::uint32_t v, Care care) {
    if (ring_[v].blocks) return false;
    return care == Care::none || !is_blocked(0, v, care);
}

/// The first ear of those who block only by touching it, else the first convex corner.
bool Triangulator::force_one(std::uint32_t start) {
    for (const Care care : {Care::touching_allowed, Care::none}) {
        std::uint32_t v = start;
        do {
            if (is_ear(v, care)) {
                clip(v);
                return true;
            }
            v = ring_[v].next;
        } while (v != start);
    }
    return false;
}

// ------------------------------------------------------------------------------------------------- the tree

void Triangulator::plant_tree() {
    const auto n = std::uint32_t(ring_.size());
    glm::vec2 low = ring_[0].at, high = low;
    for (const Vertex& v : ring_) low = glm::min(low, v.at), high = glm::max(high, v.at);
    keys_.resize(n);
    for (std::uint32_t i = 0; i < n; ++i) {
        const glm::vec2 p = ring_[i].at;
        const std::uint32_t z = spread(grid_cell(p.x, low.x, high.x)) | spread(grid_cell(p.y, low.y, high.y)) << 1;
        keys_[i] = std::uint64_t(z) << 32 | i;
    }
    std::sort(keys_.begin(), keys_.end());
    places_.resize(n);
    for (std::uint32_t i = 0; i < n; ++i) {
        const auto v = std::uint32_t(keys_[i]);
        places_[i] = {ring_[v].at, v, false};
        ring_[v].place = i;
    }
    leaves_ = 1;
    while (leaves_ * leaf_size < n) leaves_ *= 2;
    tree_.assign(2 * leaves_ - 1, Node{high, low, 0});  // an empty box: low above high
    for (std::uint32_t i = 0; i < n; ++i) {
        Node& leaf = tree_[leaves_ - 1 + i / leaf_size];
        leaf.low = glm::min(leaf.low, places_[i].at);
        leaf.high = glm::max(leaf.high, places_[i].at);
    }
    for (std::uint32_t i = leaves_ - 1; i-- > 0;) {
        tree_[i].low = glm::min(tree_[2 * i + 1].low, tree_[2 * i + 2].low);
        tree_[i].high = glm::max(tree_[2 * i + 1].high, tree_[2 * i + 2].high);
    }
}

void Triangulator::set_blocks(std::uint32_t v, bool blocks) {
    if (ring_[v].blocks == blocks) return;
    ring_[v].blocks = blocks;
    places_[ring_[v].place].blocks = blocks;
    for (std::uint32_t i = leaves_ + ring_[v].place / leaf_size; i > 0; i /= 2)  // heap numbers from 1
        tree_[i - 1].blockers += blocks ? 1u : ~0u;
}

/// Whether a vertex below the node stands in the way of cutting v off.
bool Triangulator::is_blocked(std::uint32_t node, std::uint32_t v, Care care) {
    --visits_;
    const Node& box = tree_[node];
    if (box.blockers == 0) return false;
    const glm::vec2 ear[] = {ring_[ring_[v].previous].at, ring_[v].at, ring_[ring_[v].next].at};
    for (int i = 0; i < 3; ++i) {
        const glm::vec2 p = ear[i], q = ear[(i + 1) % 3];
        // The corner of the box that lies farthest to the left of the edge.
        const glm::vec2 farthest(q.y < p.y ? box.high.x : box.low.x, q.x > p.x ? box.high.y : box.low.y);
        if (signed_area(p, q, farthest) < 0) return false;
    }
    if (node < leaves_ - 1) return is_blocked(2 * node + 1, v, care) || is_blocked(2 * node + 2, v, care);
    const std::uint32_t first = (node - (leaves_ - 1)) * leaf_size;
    const std::uint32_t last = std::min(first + leaf_size, std::uint32_t(places_.size()));
    for (std::uint32_t i = first; i < last; ++i)
        if (places_[i].blocks && blocks_ear(places_[i], v, care)) return true;
    return false;
}

bool Triangulator::blocks_ear(const Place& w, std::uint32_t v, Care care) const {
    const std::uint32_t a = ring_[v].previous, c = ring_[v].next;
    const glm::vec2 at_a = ring_[a].at, at_v = ring_[v].at, at_c = ring_[c].at;
    const double left_of_av = signed_area(at_a, at_v, w.at);
    const double left_of_vc = signed_area(at_v, at_c, w.at);
    const double left_of_ca = signed_area(at_c, at_a, w.at);
    if (left_of_av < 0 || left_of_vc < 0 || left_of_ca < 0) return false;
    if (left_of_av > 0 && left_of_vc > 0 && left_of_ca > 0) return true;
    if (care == Care::touching_allowed) return false;
    // In the same place as an end of the cut: the end itself; or a bridge to a hole starts here, and if the
    // polygon went on into the ear from here, another reflex corner would lie inside.
    if (w.at == at_a || w.at == at_c) return false;
    if (w.at != at_v) return true;
    // In the same place as the tip: in the way only if the polygon comes to this place from within the ear.
    const auto is_within = [&](std::uint32_t p) { return turn(a, v, p) > 0 && turn(v, c, p) > 0; };
    return is_within(ring_[w.vertex].previous) || is_within(ring_[w.vertex].next);
}

}  // namespace raster
