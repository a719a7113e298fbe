// SPDX-License-Identifier: MIT
// Marks the cells of the large triangles that occupy_small listed: one workgroup a piece, one
// invocation a strip.
//
// In:   work list
// Host: see occupy_cells.glsl
#include "shaders/tracers/occupancy/occupy_cells.glsl"

layout(local_size_x = kStripsPerPiece) in;
layout(std430, binding = 4) readonly buffer WorkList {
    WorkListHead heads[2];
    uint entries[];
};

void main() {
    uint entry = entries[gl_WorkGroupID.x];
    CellTriangle t = load_triangle(entry >> kPieceBits);
    uint piece = entry & ((1u << kPieceBits) - 1u);
    uint strip = piece * kStripsPerPiece + gl_LocalInvocationIndex;
    if (strip < strip_count(t))
        mark_strip(t, strip);
    close_word();
}
