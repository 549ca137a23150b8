// triangulate.h: polygons of any shape into triangles, by clipping ears.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/glm.hpp>

namespace raster {

/// Whether the triangle has no area at all: collinear or coinciding corners. Evaluated in double.
bool has_zero_area(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c);

/// Splits polygons into triangles. One object serves many polygons and keeps its memory between them.
///
/// Ear clipping (Meisters 1975; Eberly, "Triangulation by Ear Clipping"), with the corners that can block an ear
/// held in a tree over their z-order, so that the time stays near n log n (30,000 corners of a wild star: a quarter
/// of a second). The polygon is seen along the axis in which it is widest open, or along its normal (Newell's) if it
/// is bent. The triangles
///
/// - cover a simple polygon exactly once; collinear, repeated and touching corners and bridges to holes included;
/// - use every corner that is not a repetition, so that an edge shared with a neighbour is an edge of both;
/// - keep the polygon's winding and are never of zero area.
///
/// A polygon that crosses itself, or is bent so much that it does so as seen, gets some triangles, without a promise
/// of which.
class Triangulator {
public:
    /// Appends corner numbers to `triangles`, three a triangle. All corners are finite. A polygon without area
    /// appends nothing. The same sequence of polygons gives the same triangles on every machine.
    void operator()(std::span<const glm::vec3> corners, std::vector<std::uint32_t>& triangles);

private:
    struct Vertex {
        glm::vec2 at;            ///< on the plane of projection, where the polygon runs counter-clockwise
        std::uint32_t corner;    ///< its number in the input
        std::uint32_t previous;  ///< neighbours in what is left of the polygon
        std::uint32_t next;
        std::uint32_t version;  ///< counts the changes of neighbours
        std::uint32_t place;    ///< in places_
        bool blocks;            ///< reflex or straight: the only ones that can lie in another vertex's ear
        bool alive;
    };
    struct Place {  ///< what the search needs of a vertex, side by side in memory
        glm::vec2 at;
        std::uint32_t vertex;
        bool blocks;
    };
    struct Node {
        glm::vec2 low, high;
        std::uint32_t blockers = 0;
    };
    struct Candidate {
        std::uint32_t vertex, version;
    };
    enum class Care { full, touching_allowed, none };

    bool project();
    bool fan_from(std::uint32_t apex);
    void fan_in_space(std::uint32_t apex);
    void clip_ears();
    void plant_tree();
    void classify(std::uint32_t v);
    void set_blocks(std::uint32_t v, bool blocks);
    void enqueue(std::uint32_t v);
    void enqueue_all();
    void remove(std::uint32_t v);
    bool is_spike(std::uint32_t v) const;
    bool is_ear(std::uint32_t v, Care care);
    bool is_blocked(std::uint32_t node, std::uint32_t v, Care care);
    bool blocks_ear(const Place& w, std::uint32_t v, Care care) const;
    bool force_one(std::uint32_t start);
    void clip(std::uint32_t v);
    void emit(std::uint32_t a, std::uint32_t b, std::uint32_t c);
    static double signed_area(const glm::vec2& a, const glm::vec2& b, const glm::vec2& c);
    double turn(std::uint32_t a, std::uint32_t b, std::uint32_t c) const;

    std::span<const glm::vec3> corners_;               ///< of the polygon at work
    std::vector<std::uint32_t>* triangles_ = nullptr;  ///< where its triangles go
    std::vector<Vertex> ring_;
    std::vector<Node> tree_;     ///< a heap: the children of i are 2i + 1 and 2i + 2
    std::vector<Place> places_;  ///< in z-order
    std::vector<std::uint64_t> keys_;
    std::vector<Candidate> queue_;
    std::size_t queue_head_ = 0;
    std::uint32_t leaves_ = 0;
    std::uint32_t left_ = 0;               ///< vertices not cut off yet
    std::int64_t visits_ = 0;              ///< tree nodes that this polygon may still look at
    std::int64_t patience_ = 128'000'000;  ///< visits left for polygons that cross themselves
};

}  // namespace raster
