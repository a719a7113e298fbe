// SPDX-License-Identifier: MIT
// Whether something moved within reach of a point since a frame.
//
// Host: change_grid.glsl; storage block 4: changes (block_distance.comp.glsl); last_change: the frame
//       whose distances they are
#include "shaders/reuse/changes/change_grid.glsl"

layout(std430, binding = 4) readonly buffer Changes { uint changes[]; };
uniform uint last_change;

// EXACT: wherever it stands in a shader, and however often, it decides the same.

/// From the centre of a block to what moved last, metres; may be up to a box shorter.
float change_distance(ivec3 block) {
    EXACT float boxes = sqrt(float(changes[block_index(block, grid_size)]));
    EXACT float metres = boxes / (float(kMarks) * blocks_per_metre);
    return metres;
}

float distance_to_centre(vec3 position, ivec3 block) {
    EXACT vec3 way = position - centre_of_block(block, change_grid());
    EXACT float squared = way.x * way.x + way.y * way.y + way.z * way.z;
    EXACT float apart = sqrt(squared);
    return apart;
}

/// Whether what moved last may lie within `reach` metres of a point. Distances from two points
/// differ by no more than those lie apart: so the blocks around tell how near it can be at most.
bool moved_last_within(vec3 position, float reach) {
    // Beyond the grid the nearest point of it: what lies in it only comes closer by that.
    EXACT vec3 end = grid_origin + vec3(grid_size) / blocks_per_metre;
    EXACT vec3 inside = clamp(position, grid_origin, end);
    ivec3 middle = block_of(inside, change_grid());
    EXACT float most = change_distance(middle) + distance_to_centre(inside, middle);
    if (most < reach)
        return true;
    for (int i = 0; i < 27; ++i) {
        ivec3 block = middle + ivec3(i % 3, i / 3 % 3, i / 9) - 1;
        if (any(lessThan(block, ivec3(0))) || any(greaterThanEqual(block, grid_size)))
            continue;
        EXACT float least = change_distance(block) - distance_to_centre(inside, block);
        if (least > reach)
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

/// Whether anything moved anywhere.
bool moved_anywhere(uint frame, uint use_age) {
    uint blocks = uint(grid_size.x * grid_size.y * grid_size.z);
    return changed_since(frame - changes[uint(1 + kReaches) * blocks], use_age);
}
