// SPDX-License-Identifier: MIT
// For each block the square of the distance to the nearest marked one of its plane z, in blocks,
// from box to box.
//
// In:   row_distances: see row_distance.comp.glsl
// Out:  plane_squares, a word a block: more than farthest * farthest if there is none that near
// Host: see change_grid.glsl; farthest: blocks
#include "shaders/reuse/changes/change_grid.glsl"

layout(local_size_x = 64) in;
layout(std430, binding = 0) readonly buffer RowDistances { int row_distances[]; };
layout(std430, binding = 1) writeonly buffer PlaneSquares { int plane_squares[]; };
uniform int farthest;

void main() {
    uint index = gl_GlobalInvocationID.x;
    if (index >= uint(grid_size.x * grid_size.y * grid_size.z))
        return;
    ivec3 block = block_at(index, grid_size);
    int nearest = kFarAway * kFarAway;
    // From the block outwards, until what is farther cannot be nearer.
    for (int across = 0; across <= farthest && square(gap(across)) < nearest; ++across) {
        for (int side = -1; side <= 1; side += 2) {
            int y = block.y + side * across;
            if (y >= 0 && y < grid_size.y) {
                int along = row_distances[int(index) + side * across * grid_size.x];
                nearest = min(nearest, square(gap(along)) + square(gap(across)));
            }
        }
    }
    plane_squares[index] = nearest;
}
