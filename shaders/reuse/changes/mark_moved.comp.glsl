// SPDX-License-Identifier: MIT
// Marks the boxes of triangles that moved, where they were and where they are. One invocation a
// triangle.
//
// In:   positions; indices; followed: the moving vertices as they were when they were last found to
//       have moved
// Out:  moved_boxes: a word 1 if some triangle is too large to be marked, one if any moved, then rows
//       of bits
// Host: see change_grid.glsl, followed_vertices.glsl; triangle_count
#include "shaders/reuse/changes/change_grid.glsl"
#include "shaders/reuse/changes/followed_vertices.glsl"
#include "shaders/tracers/occupancy/triangle_cells.h"
#include "shaders/tracers/occupancy/work_list.h"

layout(local_size_x = 64) in;
layout(std430, binding = 2) readonly buffer Indices { uint indices[]; };
layout(std430, binding = 3) buffer MovedBoxes {
    uint all_moved;
    uint any_moved;
    uint moved_boxes[];
};
uniform uint triangle_count;

/// Turns of loops that do something: half of the 65,535 after which software ends an invocation, as
/// it counts the one that leaves a loop as well.
int turns_left = 30000;

void mark(ivec3 box) {
    int row = box.z * kMarks * grid_size.y + box.y;
    atomicOr(moved_boxes[row * row_words(grid_size) + (box.x >> 5)], 1u << (box.x & 31));
}

void mark_column(CellTriangle t, int u, int v) {
    CellRange column = cells_of_column(t, u, v, true);
    for (int w = column.first; w <= column.last && turns_left > 0; ++w) {
        --turns_left;
        ivec3 cell = ivec3(u, v, w);
        if (t.kind == kCellsBox || occupancy_of_cell(t, cell, true) != 0)
            mark(cell_xyz(cell, t.axis));
    }
}

void mark_row(CellTriangle t, int u) {
    CellRange row = cells_of_row(t, u, t.first.y, t.last.y);
    for (int v = row.first; v <= row.last && turns_left > 0; ++v) {
        --turns_left;
        mark_column(t, u, v);
    }
}

void mark_triangle(vec3 corners[3]) {
    float boxes_per_metre = float(kMarks) * blocks_per_metre;
    vec3 p = (corners[0] - grid_origin) * boxes_per_metre;
    vec3 q = (corners[1] - grid_origin) * boxes_per_metre;
    vec3 r = (corners[2] - grid_origin) * boxes_per_metre;
    int apex = apex_of(p, q, r);
    CellTriangle t = cell_triangle(apex == 0 ? p : apex == 1 ? q : r, apex == 0 ? q : apex == 1 ? r : p,
                                   apex == 0 ? r : apex == 1 ? p : q, kMarks * grid_size, true);
    if (t.kind == kCellsNone)
        return;
    for (int u = t.first.x; u <= t.last.x && turns_left > 0; ++u) {
        --turns_left;
        mark_row(t, u);
    }
}

void main() {
    uint triangle = gl_GlobalInvocationID.y * kTriangleRow + gl_GlobalInvocationID.x;
    if (triangle >= triangle_count)
        return;
    vec3 now[3];
    vec3 before[3];
    bool moved = false;
    for (uint i = 0u; i < 3u; ++i) {
        uint vertex = indices[3u * triangle + i];
        now[i] = position_of(vertex);
        before[i] = vertex < first_vertex ? now[i] : followed_position(vertex);
        moved = moved || has_moved(before[i], now[i], tolerance);
    }
    if (!moved)
        return;
    any_moved = 1u;
    mark_triangle(before);
    mark_triangle(now);
    if (turns_left <= 0)
        all_moved = 1u;
}
