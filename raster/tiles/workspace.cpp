// workspace.cpp: the workspaces that a target keeps between tiles and frames.
#include <raster/tiles/workspace.h>

namespace raster::tiles {

WorkspacePool::WorkspacePool() = default;
WorkspacePool::~WorkspacePool() = default;

std::unique_ptr<Workspace> WorkspacePool::take() {
    const std::lock_guard lock(mutex_);
    if (free_.empty()) {
        auto made = std::make_unique<Workspace>();
        // Room for it when it comes back, which must not fail.
        free_.reserve(++made_);
        return made;
    }
    std::unique_ptr<Workspace> taken = std::move(free_.back());
    free_.pop_back();
    return taken;
}

void WorkspacePool::give_back(std::unique_ptr<Workspace> workspace) {
    const std::lock_guard lock(mutex_);
    free_.push_back(std::move(workspace));
}

std::size_t WorkspacePool::bytes() const {
    const std::lock_guard lock(mutex_);
    std::size_t sum = 0;
    for (const auto& w : free_)
        sum += sizeof(Workspace) + w->planes.bytes() + w->tile.slots.capacity() * sizeof(Slot) +
               w->tile.entries.capacity() * sizeof(TileEntry) +
               (w->visible.capacity() + w->place.capacity()) * sizeof(std::int32_t);
    return sum;
}

}  // namespace raster::tiles
