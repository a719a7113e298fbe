// SPDX-License-Identifier: MIT
// Using cells in frames where something may have moved within their reach since their last use.
//
// Host: pixel_key.glsl, table.glsl, which come first; storage block 4: last_changes (stamp_blocks.comp.glsl); change_grid.glsl;
//       first_level: of the cells that the first reach is for; last_change: the frame in which
//       anything moved last
#include "shaders/reuse/changes/change_grid.glsl"
#include "shaders/reuse/spatial_hash/stale_cells.h"

layout(std430, binding = 4) readonly buffer LastChanges { uint last_changes[]; };
uniform int first_level;
uniform uint last_change;

/// `use_age`: frames since the cell's last use. By its key alone where the cell is concerned, so
/// that all its pixels agree.
bool is_stale(CellKey key, uint use_age) {
    uint changed = last_change;
    int reach = max(key.level - first_level, 0);
    if (reach < kReaches) {
        ivec3 block = block_of(cell_centre(key, inverse_smallest), change_grid());
        int blocks = grid_size.x * grid_size.y * grid_size.z;
        changed = last_changes[uint(reach * blocks) + block_index(block, grid_size)];
    }
    return changed_since(frame - changed, use_age);
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
