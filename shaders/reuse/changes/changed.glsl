// SPDX-License-Identifier: MIT
// Whether something moved within reach of a point since a frame.
//
// Host: change_grid.glsl; storage block 4: changes (block_distance.comp.glsl); last_change: the frame
//       in which anything moved last
#include "shaders/reuse/changes/change_grid.glsl"

layout(std430, binding = 4) readonly buffer Changes { uint changes[]; };
uniform uint last_change;

/// From the centre of a block to what moved last, metres; may be up to a box shorter.
float change_distance(ivec3 block) {
    return sqrt(float(changes[block_index(block, grid_size)])) / (float(kMarks) * blocks_per_metre);
}

/// Whether what moved last may lie within `reach` metres of a point. Distances from two points
/// differ by no more than those lie apart: so the blocks around tell how near it can be at most.
bool moved_last_within(vec3 position, float reach) {
    ivec3 middle = block_of(position, change_grid());
    float apart = distance(position, centre_of_block(middle, change_grid()));
    float from_middle = change_distance(middle);
    if (from_middle - apart > reach)
        return false;
    if (from_middle + apart < reach)
        return true;
    for (int i = 0; i < 27; ++i) {
        ivec3 block = middle + ivec3(i % 3, i / 3 % 3, i / 9) - 1;
        if (any(lessThan(block, ivec3(0))) || any(greaterThanEqual(block, grid_size)))
            continue;
        if (change_distance(block) - distance(position, centre_of_block(block, change_grid())) > reach)
            return false;
    }
    return true;
}

/// As moved_last_within, in the change before the last or earlier ones, since a use so many frames
/// ago; for any point of its block. `reach`: the number of one of the reaches.
bool moved_before(vec3 position, int reach, uint frame, uint use_age) {
    ivec3 block = block_of(position, change_grid());
    uint blocks = uint(grid_size.x * grid_size.y * grid_size.z);
    return changed_since(frame - changes[uint(1 + reach) * blocks + block_index(block, grid_size)], use_age);
}
