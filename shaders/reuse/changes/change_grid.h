// SPDX-License-Identifier: MIT
// Blocks of space, each with its distance from what moved last, and with the frame in which
// something within reach of it moved before: what the shaders and their CPU twin decide alike.
//
// What moves is marked in finer boxes, kMarks to a block along each axis. Lengths between blocks
// are told in boxes, from the centre of a block to the nearest point of the nearest marked box:
// never longer than to what moved, shorter by less than the diagonal of a box; beyond all reaches
// they are not told apart.
#pragma once
#include "shaders/common/cross.h"
#ifdef __cplusplus
namespace romascope::gpu {
#endif

/// So many reaches have a frame of their own in each block.
const int kReaches = 3;
/// Boxes that a block is long. Even, so that its centre lies between two.
const int kMarks = 4;
/// Boxes: more than any grid has along a side.
const int kFarAway = 1 << 14;
/// Frames that are told apart: what was not used for longer is taken for older than any change.
const uint kOldestUse = 0x8000u;

struct ChangeGrid {
    vec3 origin; ///< metres
    float blocks_per_metre;
    ivec3 size; ///< blocks, at most 256 / kMarks along a side
};

/// The block that a point lies in, or beyond the grid the nearest: points only come closer by that.
/// Any float, NaN included, gives a block.
SHARED_FN int block_along(float place, int count) {
    return place > 0.0f ? int(min(place, float(count - 1))) : 0;
}
SHARED_FN ivec3 block_of(vec3 position, ChangeGrid grid) {
    EXACT vec3 place = (position - grid.origin) * grid.blocks_per_metre;
    return ivec3(block_along(place.x, grid.size.x), block_along(place.y, grid.size.y),
                 block_along(place.z, grid.size.z));
}

/// Row by row along x, then y, then z.
SHARED_FN uint block_index(ivec3 block, ivec3 size) {
    return uint((block.z * size.y + block.y) * size.x + block.x);
}
SHARED_FN ivec3 block_at(uint index, ivec3 size) {
    int row = int(index) / size.x;
    return ivec3(int(index) - row * size.x, row % size.y, row / size.y);
}

SHARED_FN vec3 centre_of_block(ivec3 block, ChangeGrid grid) {
    EXACT vec3 centre = grid.origin + (vec3(block) + 0.5f) / grid.blocks_per_metre;
    return centre;
}

/// The first box behind the centre of a block along an axis: the one before is as near.
SHARED_FN int box_behind_centre(int block) { return kMarks * block + kMarks / 2; }
SHARED_FN int square(int x) { return x * x; }
/// Along an axis, from the centre of a block to box `box` of the block so many further on.
SHARED_FN int square_to_box(int further, int box) {
    int behind = kMarks * further + box - kMarks / 2; // the centre
    return square(behind >= 0 ? behind : behind + 1);
}
/// Likewise to the nearest box of a block on either side.
SHARED_FN int square_to_block(int apart) { return square(max(kMarks * apart - kMarks / 2, 0)); }

/// Words of a row's bits, one for each box. `size`: blocks.
SHARED_FN int row_words(ivec3 size) { return (kMarks * size.x + 31) >> 5; }

/// Whether a vertex has moved, along any axis, by more than `tolerance` metres.
SHARED_FN bool has_moved(vec3 before, vec3 now, float tolerance) {
    vec3 way = abs(now - before);
    return way.x > tolerance || way.y > tolerance || way.z > tolerance;
}

/// Whether something changed after the last use: both ages in frames before this one, where 0 is
/// this frame. What changed in a frame was so when that frame used it.
SHARED_FN bool changed_since(uint change_age, uint use_age) {
    return use_age > min(change_age, kOldestUse - 1u);
}

#ifdef __cplusplus
} // namespace romascope::gpu
#endif
