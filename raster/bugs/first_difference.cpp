// first_difference.cpp: compares two runs event by event.
#include <raster/bugs/render_bug.h>

#include <vector>

namespace raster {
namespace {

std::uint64_t hash_of(std::string_view line) {
    std::uint64_t state = 0xcbf29ce484222325u;
    for (const char c : line) state = (state ^ static_cast<unsigned char>(c)) * 0x100000001b3u;
    return state;
}

/// Runs the right picture and keeps a hash of each of the first `most` events.
std::vector<std::uint64_t> hashes_of_right(std::int64_t most, int width, int height, const Model& model,
                                           const CameraMatrices& camera, const RenderOptions& options) {
    std::vector<std::uint64_t> hashes;
    EventLines lines([&](std::int64_t event, const EventPlace&, const auto& write) {
        if (event < most) hashes.push_back(hash_of(write()));
    });
    Target target(width, height);
    render_observed(target, model, camera, options, lines);
    return hashes;
}

}  // namespace

std::optional<FirstDifference> first_difference(Bug bug, int width, int height, const Model& model,
                                                const CameraMatrices& camera, const RenderOptions& options) {
    // Most bugs show early, and lines are costly: a few events first, then more and more.
    for (std::int64_t most = 4096;; most *= 64) {
        const std::vector<std::uint64_t> right = hashes_of_right(most, width, height, model, camera, options);
        std::optional<FirstDifference> found;
        std::int64_t count = 0;
        EventLines wrong([&](std::int64_t event, const EventPlace& place, const auto& write) {
            count = event + 1;
            if (found || event >= most) return;
            const bool is_more = event >= std::int64_t(right.size());
            const std::string_view line = write();
            if (is_more || hash_of(line) != right[std::size_t(event)]) found = {event, "", std::string(line), place};
        });
        SceneObserverFor observer(wrong);
        Target target(width, height);
        render_bug(bug, observer, target, model, camera, options);
        const bool has_ended = std::int64_t(right.size()) < most;
        if (!found && has_ended && count < std::int64_t(right.size())) found = {count, "", "", {}};
        if (found) {
            EventLines again([&](std::int64_t event, const EventPlace& place, const auto& write) {
                if (event != found->event) return;
                found->right = write();
                if (found->wrong.empty()) found->place = place;
            });
            Target same(width, height);
            render_observed(same, model, camera, options, again);
            return found;
        }
        if (has_ended) return {};
    }
}

}  // namespace raster
