// SPDX-License-Identifier: MIT
// For each plane of boxes at one z, and the centre of each block across it, the square of the
// distance to the nearest marked box of the plane, in boxes.
//
// In:   row_distances, row_minima: see row_distance.comp.glsl
// Out:  plane_squares, a word for each block along x and y and box along z, no more than farthest *
//       farthest
// Host: see change_grid.glsl; farthest: boxes
#include "shaders/reuse/changes/change_grid.glsl"

layout(local_size_x = 64) in;
layout(std430, binding = 0) readonly buffer RowDistances { int row_distances[]; };
layout(std430, binding = 1) readonly buffer RowMinima { int row_minima[]; };
layout(std430, binding = 2) writeonly buffer PlaneSquares { int plane_squares[]; };
uniform int farthest;

void main() {
    uint index = gl_GlobalInvocationID.x;
    if (index >= uint(grid_size.x * grid_size.y * kMarks * grid_size.z))
        return;
    int y = block_at(index, grid_size).y;
    int nearest = square(farthest);
    // From block to block outwards, until what is farther cannot be nearer.
    for (int across = 0; across < grid_size.y && square_to_block(across) < nearest; ++across) {
        for (int side = 0; side < 2; ++side) {
            int other = side == 0 ? y + across : y - across;
            int at = int(index) + (other - y) * grid_size.x;
            if (other < 0 || other >= grid_size.y || square(row_minima[at]) + square_to_block(across) >= nearest)
                continue;
            for (int i = 0; i < kMarks; ++i)
                nearest = min(nearest, square(row_distances[kMarks * at + i]) + square_to_box(other - y, i));
        }
    }
    plane_squares[index] = nearest;
}
