// SPDX-License-Identifier: MIT
// For each block the distance from its centre to the nearest marked box. What it had so far, the
// distances of the change before, becomes a frame number: that of all blocks of which some point may
// lie within reach of that change, for each of the reaches.
//
// In:   plane_squares: see plane_distance.comp.glsl; moved_boxes
// Out:  changes: a squared distance a block, in boxes, no more than farthest * farthest; then
//       kReaches grids, one after another, a frame a block; then the frame in which anything moved
//       last
// Host: see change_grid.glsl; farthest: boxes; block_squares[kReaches]: squares of the reaches from
//       the centre of a block, in boxes; frame; frame_before: of the change before
#include "shaders/reuse/changes/change_grid.glsl"

layout(local_size_x = 64) in;
layout(std430, binding = 0) readonly buffer PlaneSquares { int plane_squares[]; };
layout(std430, binding = 1) buffer Changes { uint changes[]; };
layout(std430, binding = 2) readonly buffer MovedBoxes {
    uint all_moved;
    uint any_moved;
    uint moved_boxes[];
};
uniform int farthest;
uniform int block_squares[kReaches];
uniform uint frame;
uniform uint frame_before;

void main() {
    uint index = gl_GlobalInvocationID.x;
    uint blocks = uint(grid_size.x * grid_size.y * grid_size.z);
    if (index >= blocks)
        return;
    uint square_before = changes[index];
    for (int i = 0; i < kReaches; ++i)
        if (square_before <= uint(block_squares[i]))
            changes[uint(1 + i) * blocks + index] = frame_before;

    int z = block_at(index, grid_size).z;
    int plane = grid_size.x * grid_size.y;
    int in_plane = int(index) - z * plane;
    int nearest = square(farthest);
    for (int across = 0; across < grid_size.z && square_to_block(across) < nearest; ++across) {
        for (int side = 0; side < 2; ++side) {
            int other = side == 0 ? z + across : z - across;
            if (other < 0 || other >= grid_size.z)
                continue;
            for (int i = 0; i < kMarks; ++i)
                nearest = min(nearest, plane_squares[(kMarks * other + i) * plane + in_plane] +
                                           square_to_box(other - z, i));
        }
    }
    if (index == 0u && any_moved != 0u)
        changes[uint(1 + kReaches) * blocks] = frame;
    changes[index] = all_moved != 0u ? 0u : uint(nearest);
}
