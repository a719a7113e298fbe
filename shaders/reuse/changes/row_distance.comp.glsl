// SPDX-License-Identifier: MIT
// For each row of boxes along x, and the centre of each block along it, the distance to the nearest
// marked box of the row, in boxes. One invocation for the kMarks rows of a block at one z.
//
// In:   moved_boxes: see mark_moved.comp.glsl
// Out:  row_distances, kMarks words for each block along x and y and box along z: kFarAway if none
//       is marked; row_minima, the least of them
// Host: see change_grid.glsl
#include "shaders/reuse/changes/change_grid.glsl"

layout(local_size_x = 64) in;
layout(std430, binding = 0) readonly buffer MovedBoxes {
    uint all_moved;
    uint any_moved;
    uint moved_boxes[];
};
layout(std430, binding = 1) writeonly buffer RowDistances { int row_distances[]; };
layout(std430, binding = 2) writeonly buffer RowMinima { int row_minima[]; };

int row_distance(int row, int centre) {
    int words = row_words(grid_size);
    int nearest = kFarAway;
    for (int word = 0; word < words; ++word) {
        uint bits = moved_boxes[row * words + word];
        int at = centre - 32 * word; // from the word's first
        // The last mark before the centre, and the first behind it.
        uint before = at <= 0 ? 0u : at >= 32 ? bits : bits & ((1u << uint(at)) - 1u);
        uint behind = bits ^ before;
        if (before != 0u)
            nearest = min(nearest, at - 1 - findMSB(before));
        if (behind != 0u)
            nearest = min(nearest, findLSB(behind) - at);
    }
    return nearest;
}

void main() {
    uint index = gl_GlobalInvocationID.x;
    if (index >= uint(grid_size.x * grid_size.y * kMarks * grid_size.z))
        return;
    ivec3 place = block_at(index, grid_size); // along z a box
    int first = kMarks * (place.z * grid_size.y + place.y);
    int least = kFarAway;
    for (int i = 0; i < kMarks; ++i) {
        int nearest = row_distance(first + i, box_behind_centre(place.x));
        row_distances[kMarks * int(index) + i] = nearest;
        least = min(least, nearest);
    }
    row_minima[index] = least;
}
