// SPDX-License-Identifier: MIT
#pragma once

#include "renderer/reuse/changes/change_volume.h"
#include "renderer/reuse/spatial_hash/hash_knobs.h"

#include <optional>

namespace romascope {

/// Knows which cells of the spatial hash something has moved within reach of since their last use,
/// in scenes that move and with a finite radius.
class CellRenewal {
public:
    /// `first_moving_vertex`: none if nothing in the scene moves.
    explicit CellRenewal(std::optional<uint32_t> first_moving_vertex)
        : first_vertex_(first_moving_vertex) {}

    /// Vertices may stand elsewhere than in the last frame.
    void vertices_moved() { moved_ = true; }
    /// A frame in which cells may be so many frames old. Finds out what moved since the last one.
    /// False if it cannot, or has not begun: then all cells are to be forgotten, and begin()
    /// follows.
    bool follow(const FrameContext& frame, uint32_t max_age);
    /// From this frame on, whose table is empty.
    void begin(const FrameContext& frame);
    /// Gives back all memory and forgets what it knows.
    void release();

    /// Whether a cell may be older than what moved within its reach.
    bool is_needed() const { return needed_; }
    /// For what includes stale_cells.glsl; `program` is in use.
    void bind(const Program& program) const;

    size_t bytes() const { return changes_.bytes(); }
    const ChangeVolume& changes() const { return changes_; }

private:
    ChangeVolume::Reaches reaches(const Settings& settings) const;

    std::optional<uint32_t> first_vertex_;
    ChangeVolume changes_;
    float tolerance_ = 0;  ///< metres
    float cell_reach_ = 0; ///< metres from where a ray starts to what it can find
    int first_level_ = 0;  ///< of the cells that the first reach is for
    bool begun_ = false;
    bool moved_ = false; ///< since the last frame
    bool needed_ = false;
    uint32_t max_age_ = 0; ///< of the last frame
};

} // namespace romascope
