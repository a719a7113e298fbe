// SPDX-License-Identifier: MIT
// Marks the cells of the large triangles that occupy_group.comp.glsl listed: one work group a piece,
// its invocations take the piece's columns in turn.
//
// In:   work list
// Host: see occupy_cells.glsl
#include "shaders/tracers/occupancy/occupy_cells.glsl"

layout(local_size_x = kGroupTriangles) in;
layout(std430, binding = 4) readonly buffer WorkList {
    WorkListHead heads[2];
    uint entries[];
};

void main() {
    uint entry = entries[gl_WorkGroupID.x];
    CellTriangle t = load_triangle(entry >> kPieceBits);
    uint piece = entry & ((1u << kPieceBits) - 1u);
    uint columns = column_count(t);
    uint step = piece_count(columns) * kGroupTriangles;
    for (uint column = piece * kGroupTriangles + gl_LocalInvocationIndex; column < columns; column += step)
        mark_column(t, column);
    close_texel();
}
