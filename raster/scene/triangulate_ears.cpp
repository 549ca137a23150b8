// triangulate_ears.cpp: ear clipping, with a tree that finds what lies in an ear.
#include <algorithm>
#include <cmath>

#include <raster/scene/triangulate.h>

namespace raster {
namespace {

constexpr std::uint32_t leaf_size = 8;

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

// ------------------------------------------------------------------------------------------------ clipping

void Triangulator::clip_ears() {
    plant_tree();
    for (std::uint32_t v = 0; v < ring_.size(); ++v) classify(v);
    enqueue_all();
    // Cutting an ear changes the standing of its two neighbours only (O'Rourke, Computational Geometry in C,
    // 1.4), so each cut queues two candidates anew. A polygon that crosses itself, or whose plane is in doubt,
    // can run out of ears; then one is forced. Past a budget nothing is tested any more, which bounds the time. A
    // simple polygon never ran out of ears, and of its budget used two thirds at most (a star of 30,000 corners);
    // one that does either is suspect, and all suspects together have patience_ to live on.
    const auto n = std::int64_t(ring_.size());
    const std::int64_t most_visits = 64'000'000, when_forced = 64 * n, when_impatient = 16 * n;
    const std::int64_t budget =
        patience_ > 0 ? std::min(n * std::int64_t(50 + 4 * std::sqrt(double(n))), most_visits) : when_impatient;
    visits_ = budget;
    bool is_suspect = false;
    Care care = Care::full;
    std::uint32_t some = 0;  // a vertex that is still there
    while (left_ > 3) {
        if (queue_head_ == queue_.size()) {
            while (!ring_[some].alive) ++some;
            if (care == Care::none || !force_one(some)) break;
            is_suspect = true;
            visits_ = std::min(visits_, when_forced) - left_;
            enqueue_all();
            continue;
        }
        const Candidate candidate = queue_[queue_head_++];
        const std::uint32_t v = candidate.vertex;
        if (visits_ < 0) {
            is_suspect = true;
            care = Care::none;
        }
        // One whose neighbours changed since stands further back in the queue; taking turns avoids slivers.
        if (!ring_[v].alive || ring_[v].version != candidate.version) continue;
        if (is_spike(v) || is_ear(v, care)) clip(v);
    }
    if (is_suspect) patience_ = std::max(patience_ - (budget - visits_), std::int64_t(0));
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
