// workspace.h: what a thread needs while it draws one tile. The target lends it out, so that a thread owns nothing.
#pragma once

#include <raster/tiles/tile.h>

namespace raster::tiles {

struct Workspace {
    TileBuffer tile;
    std::vector<std::int32_t> visible;  ///< the slots that some pixel shows, in the order in which they are met; first 0
    std::vector<std::int32_t> place;    ///< a slot: where it stands in `visible`, -1 where it does not
    ScratchBuffer planes;               ///< shading planes of `visible`
};

/// A workspace from a pool, which gets it back at the end. Any number of threads may hold one each.
class WorkspaceLoan {
public:
    explicit WorkspaceLoan(WorkspacePool& pool) : pool_(pool), workspace_(pool.take()) {}
    ~WorkspaceLoan() { pool_.give_back(std::move(workspace_)); }
    WorkspaceLoan(const WorkspaceLoan&) = delete;
    WorkspaceLoan& operator=(const WorkspaceLoan&) = delete;

    Workspace& operator*() { return *workspace_; }

private:
    WorkspacePool& pool_;
    std::unique_ptr<Workspace> workspace_;
};

}  // namespace raster::tiles
