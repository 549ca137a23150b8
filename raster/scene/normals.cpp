// normals.cpp: sums of face normals around each position, with the crease rule.
#include <raster/scene/normals.h>

#include <algorithm>
#include <array>
#include <bitset>
#include <cmath>

#include <raster/math.h>
#include <raster/scene/obj_dedup.h>
#include <raster/tiles/parallel.h>

namespace raster {
namespace {

constexpr std::size_t most_compared = 128;

/// Calls body(first, end) for parts of 0 to `count`, on all threads.
template <class Body>
void in_chunks(std::size_t count, const Body& body) {
    constexpr std::size_t chunk = 2048;
    tiles::parallel_for((count + chunk - 1) / chunk,
                        [&](std::size_t i) { body(i * chunk, std::min((i + 1) * chunk, count)); });
}

/// A face's unit normal and twice its area; zero for one without area.
struct Facet {
    glm::vec3 normal{0.0f};
    double weight = 0;
};

/// Newell's method, in double, which neither overflows nor loses the small ones for any float positions.
Facet make_facet(std::span<const glm::vec3> positions, std::span<const std::uint32_t> corners) {
    glm::dvec3 area(0.0);
    for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
        const glm::dvec3 a(positions[corners[0]]), b(positions[corners[i]]), c(positions[corners[i + 1]]);
        area += glm::cross(b - a, c - a);
    }
    const double length = std::sqrt(glm::dot(area, area));
    return length > 0 ? Facet{glm::vec3(area / length), length} : Facet{};
}

/// For each corner, its face.
std::vector<std::uint32_t> find_faces(const Faces& faces) {
    std::vector<std::uint32_t> face_of(faces.corners.size());
    if (faces.ends.empty()) {
        for (std::size_t c = 0; c < face_of.size(); ++c) face_of[c] = std::uint32_t(c / 3);
    } else {
        for (std::uint32_t f = 0, c = 0; f < faces.ends.size(); ++f)
            while (c < faces.ends[f]) face_of[c++] = f;
    }
    return face_of;
}

/// For each distinct position, the corners that stand there, in order.
struct Meetings {
    std::vector<std::uint32_t> first;  ///< into corners; one more entry than positions
    std::vector<std::uint32_t> corners;
};

Meetings find_meetings(std::span<const glm::vec3> positions, std::span<const std::uint32_t> corners) {
    std::vector<std::uint32_t> place(positions.size());
    std::uint32_t places = 0;
    {
        std::vector<glm::vec3> distinct;
        obj::Dedup<glm::vec3> number(distinct, positions.size());
        distinct.reserve(positions.size());
        constexpr std::size_t ahead = 8;
        for (std::size_t i = 0; i < positions.size(); ++i) {
            if (i + ahead < positions.size()) number.ask_ahead(positions[i + ahead] + 0.0f);
            place[i] = number(positions[i] + 0.0f);  // -0 becomes 0
        }
        places = std::uint32_t(distinct.size());
    }
    Meetings m;
    m.first.assign(places + 1, 0);
    for (const std::uint32_t i : corners) ++m.first[place[i] + 1];
    for (std::uint32_t p = 0; p < places; ++p) m.first[p + 1] += m.first[p];
    m.corners.resize(corners.size());
    // Filling from the back, each start moves from the end of its list to the front.
    std::vector<std::uint32_t> end(m.first.begin() + 1, m.first.end());
    for (std::size_t c = corners.size(); c-- > 0;) m.corners[--end[place[corners[c]]]] = std::uint32_t(c);
    return m;
}

class Smoother {
public:
    Smoother(std::span<const glm::vec3> positions, const Faces& faces, const Creases& creases)
        : groups_(faces.groups),
          face_of_(find_faces(faces)),
          within_groups_(creases.within_groups),
          // A hair of tolerance, so that 90 degrees includes the cube's.
          least_cosine_(float(sin_cos_degrees(double(creases.angle)).cos) - 1e-6f),
          half_angle_cosine_(float(sin_cos_degrees(double(creases.angle) / 2).cos) + 1e-3f) {
        const std::size_t count = faces.ends.empty() ? faces.corners.size() / 3 : faces.ends.size();
        facets_.resize(count);
        in_chunks(count, [&](std::size_t first_face, std::size_t end_face) {
            for (std::size_t f = first_face; f < end_face; ++f) {
                const std::size_t first = faces.ends.empty() ? 3 * f : f == 0 ? 0 : faces.ends[f - 1];
                const std::size_t end = faces.ends.empty() ? first + 3 : faces.ends[f];
                facets_[f] = make_facet(positions, faces.corners.subspan(first, end - first));
            }
        });
    }

    /// The normals of all corners that meet in one position, at most `most_compared`. Each is a sum over those it
    /// shares its normal with, in their order; corners that share with the same ones have one sum.
    void smooth(std::span<const std::uint32_t> corners, std::vector<glm::vec3>& normals) const {
        const std::size_t count = corners.size();
        struct Around {
            glm::vec3 normal;
            std::uint32_t face, group;
        };
        std::array<Around, most_compared> around;
        for (std::size_t i = 0; i < count; ++i) {
            const std::uint32_t face = face_of_[corners[i]];
            around[i] = {facets_[face].normal, face, group(face)};
        }
        const auto share = [&](const Around& a, const Around& b) {
            if (a.face == b.face) return true;
            if (a.group != b.group || a.group == smoothing_off) return false;
            if (a.group != smoothing_by_angle && !within_groups_) return true;
            return glm::dot(a.normal, b.normal) >= least_cosine_;
        };
        // Mostly all share with all, and surely where all of a group are within half of the angle from the first.
        bool all_share = true;
        for (std::size_t i = 1; i < count; ++i)
            all_share = all_share && around[i].group == around[0].group && around[0].group != smoothing_off &&
                        glm::dot(around[i].normal, around[0].normal) >= half_angle_cosine_;
        if (!all_share) {
            all_share = true;
            for (std::size_t i = 1; i < count && all_share; ++i)
                for (std::size_t k = 0; k < i; ++k) all_share = all_share && share(around[i], around[k]);
        }
        if (all_share) {
            glm::dvec3 sum(0.0);
            for (const std::uint32_t corner : corners) sum += weighted(corner);
            const glm::vec3 shared = unit(sum);
            for (const std::uint32_t corner : corners) normals[corner] = unit_or_own(shared, corner);
            return;
        }
        std::bitset<most_compared> sharing, last_sharing;
        glm::vec3 shared(0.0f);
        for (std::size_t c = 0; c < count; ++c) {
            for (std::size_t i = 0; i < count; ++i) sharing.set(i, share(around[c], around[i]));
            if (sharing != last_sharing) {
                glm::dvec3 sum(0.0);
                for (std::size_t i = 0; i < count; ++i)
                    if (sharing.test(i)) sum += weighted(corners[i]);
                last_sharing = sharing;
                shared = unit(sum);
            }
            normals[corners[c]] = unit_or_own(shared, corners[c]);
        }
    }

    /// The same for many corners: one sum a group.
    void smooth_many(std::span<const std::uint32_t> corners, std::vector<glm::vec3>& normals) const {
        const auto group_at = [&](std::uint32_t corner) { return group(face_of_[corner]); };
        std::vector<std::uint32_t> sorted(corners.begin(), corners.end());
        std::stable_sort(sorted.begin(), sorted.end(),
                         [&](std::uint32_t a, std::uint32_t b) { return group_at(a) < group_at(b); });
        for (std::size_t first = 0, last = 0; first < sorted.size(); first = last) {
            glm::dvec3 sum(0.0);
            const std::uint32_t g = group_at(sorted[first]);
            for (last = first; last < sorted.size() && group_at(sorted[last]) == g; ++last)
                sum += weighted(sorted[last]);
            const glm::vec3 shared = unit(sum);
            for (std::size_t i = first; i < last; ++i)
                normals[sorted[i]] = unit_or_own(g == smoothing_off ? unit(weighted(sorted[i])) : shared, sorted[i]);
        }
    }

private:
    std::uint32_t group(std::uint32_t face) const { return groups_.empty() ? smoothing_by_angle : groups_[face]; }

    glm::dvec3 weighted(std::uint32_t corner) const {
        const Facet& facet = facets_[face_of_[corner]];
        return glm::dvec3(facet.normal) * facet.weight;
    }

    /// Zero where opposite sides of a sheet cancel out.
    static glm::vec3 unit(const glm::dvec3& sum) {
        const double length = std::sqrt(glm::dot(sum, sum));
        return length > 0 ? glm::vec3(sum / length) : glm::vec3(0.0f);
    }

    glm::vec3 unit_or_own(const glm::vec3& unit, std::uint32_t corner) const {
        if (unit != glm::vec3(0.0f)) return unit;
        const Facet& own = facets_[face_of_[corner]];
        return own.weight > 0 ? own.normal : glm::vec3(0, 0, 1);
    }

    std::span<const std::uint32_t> groups_;
    std::vector<std::uint32_t> face_of_;  ///< a corner
    std::vector<Facet> facets_;           ///< a face
    bool within_groups_;
    float least_cosine_;
    float half_angle_cosine_;  ///< of a little less than half: rounding does not matter
};

}  // namespace

std::vector<glm::vec3> make_normals(std::span<const glm::vec3> positions, const Faces& faces, const Creases& creases) {
    const Meetings meetings = find_meetings(positions, faces.corners);
    const Smoother smoother(positions, faces, creases);
    std::vector<glm::vec3> normals(faces.corners.size());
    in_chunks(meetings.first.size() - 1, [&](std::size_t first, std::size_t end) {
        for (std::size_t p = first; p < end; ++p) {
            const std::span<const std::uint32_t> corners(meetings.corners.data() + meetings.first[p],
                                                         meetings.first[p + 1] - meetings.first[p]);
            if (corners.size() <= most_compared) {
                smoother.smooth(corners, normals);
            } else {
                smoother.smooth_many(corners, normals);
            }
        }
    });
    return normals;
}

}  // namespace raster
