// SPDX-License-Identifier: MIT
// Marks the cells of small triangles and lists large ones, as occupy_small.comp.glsl does, but a
// work group has as many triangles as invocations and shares their columns evenly.
//
// Out:  work list: pieces of large triangles, in any order
// Host: head: which of the two is used, the other is emptied; first_triangle, triangle_count; columns_in_place: how many columns a small triangle spans at
//       most; see occupy_cells.glsl for the rest
#include "shaders/tracers/occupancy/occupy_cells.glsl"

layout(local_size_x = kGroupTriangles) in;
layout(std430, binding = 4) buffer WorkList {
    WorkListHead heads[2];
    uint entries[];
};
uniform uint head;
uniform uint first_triangle;
uniform uint triangle_count;
uniform int columns_in_place;

shared uint columns_up_to[kGroupTriangles]; // of the group's triangles up to this, itself included
shared uint group_pieces;
shared uint group_entry;

/// Which of the group's triangles has this of all their columns.
uint owner_of(uint column) {
    uint owner = 0u;
    for (uint span = kGroupTriangles / 2u; span > 0u; span /= 2u)
        if (columns_up_to[owner + span - 1u] <= column)
            owner += span;
    return owner;
}

void main() {
    if (gl_GlobalInvocationID == uvec3(0))
        heads[1u - head] = WorkListHead(0u, 1u, 1u, 0u);
    uint lane = gl_LocalInvocationIndex;
    uint index = gl_GlobalInvocationID.y * kTriangleRow + gl_GlobalInvocationID.x;
    uint group_first = first_triangle + index - lane;
    uint columns = 0u, pieces = 0u;
    if (index < triangle_count) {
        columns = column_count(load_triangle(group_first + lane));
        if (columns > uint(columns_in_place))
            pieces = piece_count(columns);
    }

    if (lane == 0u)
        group_pieces = 0u;
    barrier();
    uint place = 0u;
    if (pieces > 0u)
        place = atomicAdd(group_pieces, pieces);
    barrier();
    if (lane == 0u && group_pieces > 0u) {
        group_entry = atomicAdd(heads[head].wanted, group_pieces);
        atomicMax(heads[head].groups_x, min(group_entry + group_pieces, kWorkListLength));
    }
    barrier();
    if (pieces > 0u) {
        uint entry = min(group_entry + place, kWorkListLength);
        uint listed = min(pieces, kWorkListLength - entry);
        for (uint i = 0u; i < listed; ++i)
            entries[entry + i] = ((group_first + lane) << kPieceBits) | i;
        // What the list has no room for is done here; cells may be marked twice.
        columns = listed < pieces ? columns : 0u;
    }

    columns_up_to[lane] = columns;
    barrier();
    for (uint step = 1u; step < kGroupTriangles; step *= 2u) {
        uint before = lane >= step ? columns_up_to[lane - step] : 0u;
        barrier();
        columns_up_to[lane] += before;
        barrier();
    }
    uint share = (columns_up_to[kGroupTriangles - 1u] + kGroupTriangles - 1u) / kGroupTriangles;
    uint column = min(lane * share, columns_up_to[kGroupTriangles - 1u]);
    uint end = min(column + share, columns_up_to[kGroupTriangles - 1u]);
    uint first = 0u, owner_end = 0u;
    CellTriangle t;
    for (; column < end; ++column) {
        if (column >= owner_end) {
            uint owner = owner_of(column);
            owner_end = columns_up_to[owner];
            first = owner == 0u ? 0u : columns_up_to[owner - 1u];
            t = load_triangle(group_first + owner);
        }
        mark_column(t, column - first);
    }
    close_word();
}
