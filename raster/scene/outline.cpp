// outline.cpp: finding equal edges by sorting.
#include <raster/scene/outline.h>

#include <algorithm>
#include <compare>

namespace raster {
namespace {

struct Named {
    std::uint64_t key;    ///< equal for equal edges or corners
    std::uint32_t place;  ///< 3 t + c: corner c of triangle t, or the edge from there to the next corner

    friend auto operator<=>(const Named&, const Named&) = default;
};

/// The corner after this one in its triangle.
std::uint32_t next(std::uint32_t place) { return place % 3 == 2 ? place - 2 : place + 1; }

/// The first place of each key, in the order of the index list.
template <class KeyAt>
std::vector<std::uint32_t> first_places(std::size_t triangles, const KeepTriangle& keep, const KeyAt& key_at) {
    std::vector<Named> all;
    for (std::uint32_t t = 0; t < triangles; ++t) {
        if (keep && !keep(t)) continue;
        for (std::uint32_t place = 3 * t; place < 3 * t + 3; ++place) all.push_back({key_at(place), place});
    }
    std::sort(all.begin(), all.end());
    const auto same = [](const Named& a, const Named& b) { return a.key == b.key; };
    all.erase(std::unique(all.begin(), all.end(), same), all.end());
    std::vector<std::uint32_t> places;
    for (const Named& named : all) places.push_back(named.place);
    std::sort(places.begin(), places.end());
    return places;
}

}  // namespace

Outline edges_of(std::span<const std::uint32_t> indices, const KeepTriangle& keep) {
    const auto key_at = [&](std::uint32_t place) {
        const std::uint64_t a = indices[place], b = indices[next(place)];
        return std::min(a, b) << 32 | std::max(a, b);
    };
    Outline outline;
    for (const std::uint32_t place : first_places(indices.size() / 3, keep, key_at)) {
        outline.indices.insert(outline.indices.end(), {indices[place], indices[next(place)]});
        outline.triangles.push_back(place / 3);
    }
    return outline;
}

Outline corners_of(std::span<const std::uint32_t> indices, const KeepTriangle& keep) {
    const auto key_at = [&](std::uint32_t place) { return std::uint64_t(indices[place]); };
    Outline outline;
    for (const std::uint32_t place : first_places(indices.size() / 3, keep, key_at)) {
        outline.indices.push_back(indices[place]);
        outline.triangles.push_back(place / 3);
    }
    return outline;
}

}  // namespace raster
