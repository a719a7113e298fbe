// SPDX-License-Identifier: MIT
// Marks the cells of large triangles: one work group a piece, its invocations take the piece's
// columns in turn. Of those that occupy_group.comp.glsl listed, or, where a scene has few, of all:
// each piece that any triangle could have.
//
// In:   work list
// Host: every_piece: of all triangles from first_triangle on, dispatched over (kMostPieces,
//       triangles); else dispatched over the list; see occupy_cells.glsl for the rest
#include "shaders/tracers/occupancy/occupy_cells.glsl"

layout(local_size_x = kGroupTriangles) in;
layout(std430, binding = 4) readonly buffer WorkList {
    WorkListHead heads[2];
    uint entries[];
};
uniform bool every_piece;
uniform uint first_triangle;

void main() {
    uint triangle = first_triangle + gl_WorkGroupID.y, piece = gl_WorkGroupID.x;
    if (!every_piece) {
        uint entry = entries[gl_WorkGroupID.x];
        triangle = entry >> kPieceBits;
        piece = entry & (kMostPieces - 1u);
    }
    CellTriangle t = load_triangle(triangle);
    uint columns = column_count(t);
    uint pieces = piece_count(columns);
    if (piece >= pieces)
        return;
    for (uint column = piece * kGroupTriangles + gl_LocalInvocationIndex; column < columns; column += pieces * kGroupTriangles)
        mark_column(t, column);
    close_word();
}
