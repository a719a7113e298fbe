// SPDX-License-Identifier: MIT
// Writes the frame to all blocks that lie within reach of a marked one, for each of the reaches.
//
// In:   plane_squares: see plane_distance.comp.glsl; moved_blocks
// Out:  last_changes: kReaches grids, one after another, a frame a block
// Host: see change_grid.glsl; farthest: blocks; squares[kReaches]: squared reaches, in blocks; frame
#include "shaders/reuse/changes/change_grid.glsl"

layout(local_size_x = 64) in;
layout(std430, binding = 0) readonly buffer PlaneSquares { int plane_squares[]; };
layout(std430, binding = 1) writeonly buffer LastChanges { uint last_changes[]; };
layout(std430, binding = 2) readonly buffer MovedBlocks {
    uint all_moved;
    uint moved_blocks[];
};
uniform int farthest;
uniform int squares[kReaches];
uniform uint frame;

void main() {
    uint index = gl_GlobalInvocationID.x;
    uint blocks = uint(grid_size.x * grid_size.y * grid_size.z);
    if (index >= blocks)
        return;
    ivec3 block = block_at(index, grid_size);
    int plane = grid_size.x * grid_size.y;
    int nearest = kFarAway * kFarAway;
    for (int across = 0; across <= farthest && square(gap(across)) < nearest; ++across) {
        for (int side = -1; side <= 1; side += 2) {
            int z = block.z + side * across;
            if (z >= 0 && z < grid_size.z)
                nearest = min(nearest, plane_squares[int(index) + side * across * plane] + square(gap(across)));
        }
    }
    for (int i = 0; i < kReaches; ++i)
        if (all_moved != 0u || nearest <= squares[i])
            last_changes[uint(i) * blocks + index] = frame;
}
