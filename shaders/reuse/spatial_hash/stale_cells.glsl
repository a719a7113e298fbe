// SPDX-License-Identifier: MIT
// Using cells in frames where something may have moved within their reach since their last use.
//
// Host: pixel_key.glsl, table.glsl, which come first; changed.glsl; cell_reach: metres from where a
//       ray starts to what it can find; first_level: of the cells that the first of the reaches is for
#include "shaders/reuse/changes/changed.glsl"
#include "shaders/reuse/spatial_hash/stale_cells.h"

uniform float cell_reach;
uniform int first_level;

/// `use_age`: frames since the cell's last use. By its key alone where the cell is concerned, so
/// that all its pixels agree.
bool is_stale(CellKey key, uint use_age) {
    if (!changed_since(frame - last_change, use_age))
        return false;
    int reach = max(key.level - first_level, 0);
    if (reach >= kReaches)
        return moved_anywhere(frame, use_age);
    vec3 centre = cell_centre(key, inverse_smallest);
    if (moved_before(centre, reach, frame, use_age))
        return true;
    EXACT float size = power_of_two(key.level) / inverse_smallest;
    EXACT float extent = size * cell_radius(jitter_scale);
    EXACT float all = cell_reach + extent;
    return moved_last_within(centre, all);
}

/// As use_cell, but leaves a cell that is stale as it is, so that all its pixels see it: its sums
/// are 0 then. A cell is flagged before its time is taken away, and looked at the other way round:
/// who finds no time finds the flag.
uvec2 use_unless_stale(uint slot, CellKey key, out bool stale) {
    uint hits = atomicOr(hash_sums[slot].x, 0u);
    memoryBarrierBuffer();
    uint samples = atomicOr(hash_sums[slot].y, 0u);
    stale = (samples & kSamplesMask) != 0u && is_stale(key, cell_age(Cell(1u, hits, samples), frame));
    if (stale)
        return uvec2(0u);
    if ((samples & kInUse) == 0u) {
        atomicOr(hash_sums[slot].y, kInUse);
        memoryBarrierBuffer();
        atomicAnd(hash_sums[slot].x, kHitsMask);
    }
    return uvec2(hits & kHitsMask, samples & kSamplesMask);
}
