// SPDX-License-Identifier: MIT
// Marks the cells of small triangles and lists large ones. One invocation a triangle.
//
// Out:  work list: pieces of large triangles, in any order
// Host: head: which of the two is used, the other is emptied; first_triangle, triangle_count; columns_in_place: how many columns a small triangle spans at
//       most; see occupy_cells.glsl for the rest
#include "shaders/tracers/occupancy/occupy_cells.glsl"

layout(local_size_x = 64) in;
layout(std430, binding = 4) buffer WorkList {
    WorkListHead heads[2];
    uint entries[];
};
uniform uint head;
uniform uint first_triangle;
uniform uint triangle_count;
uniform int columns_in_place;

void main() {
    if (gl_GlobalInvocationID == uvec3(0))
        heads[1u - head] = WorkListHead(0u, 1u, 1u, 0u);
    uint index = gl_GlobalInvocationID.y * kTriangleRow + gl_GlobalInvocationID.x;
    if (index >= triangle_count)
        return;
    uint triangle = first_triangle + index;
    CellTriangle t = load_triangle(triangle);
    if (t.kind == kCellsNone)
        return;
    ivec3 spans = t.last - t.first + 1;
    uint strips = 0u;
    uint strip = 0u;
    if (spans.x * spans.y > columns_in_place) {
        strips = strip_count(t);
        uint pieces = (strips + kStripsPerPiece - 1u) / kStripsPerPiece;
        uint first = atomicAdd(heads[head].wanted, pieces);
        uint listed = min(pieces, kWorkListLength - min(first, kWorkListLength));
        atomicMax(heads[head].groups_x, min(first + listed, kWorkListLength));
        for (uint i = 0u; i < listed; ++i)
            entries[first + i] = (triangle << kPieceBits) | i;
        strip = listed * kStripsPerPiece; // what the list has no room for
    } else {
        for (int u = t.first.x; u <= t.last.x; ++u)
            mark_row(t, u, cells_of_row(t, u, t.first.y, t.last.y));
    }
    for (; strip < strips; ++strip)
        mark_strip(t, strip);
    close_word();
}
