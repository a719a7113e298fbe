// SPDX-License-Identifier: MIT
// For each block the distance to the nearest marked one of its row along x, in blocks.
//
// In:   moved_blocks: see mark_moved.comp.glsl
// Out:  row_distances, a word a block: kFarAway if none is marked
// Host: see change_grid.glsl
#include "shaders/reuse/changes/change_grid.glsl"

layout(local_size_x = 64) in;
layout(std430, binding = 0) readonly buffer MovedBlocks {
    uint all_moved;
    uint moved_blocks[];
};
layout(std430, binding = 1) writeonly buffer RowDistances { int row_distances[]; };

void main() {
    uint index = gl_GlobalInvocationID.x;
    if (index >= uint(grid_size.x * grid_size.y * grid_size.z))
        return;
    int row = int(index) / grid_size.x;
    int x = int(index) - row * grid_size.x;
    int words = row_words(grid_size);
    int nearest = kFarAway;
    for (int word = 0; word < words; ++word) {
        uint bits = moved_blocks[row * words + word];
        int at = x - 32 * word; // of this block, from the word's first
        // The last mark up to here, and the first from here on.
        uint before = at < 0 ? 0u : at >= 31 ? bits : bits & ((2u << uint(at)) - 1u);
        uint after = at < 0 ? bits : at > 31 ? 0u : bits & ~((1u << uint(at)) - 1u);
        if (before != 0u)
            nearest = min(nearest, at - findMSB(before));
        if (after != 0u)
            nearest = min(nearest, findLSB(after) - at);
    }
    row_distances[index] = nearest;
}
