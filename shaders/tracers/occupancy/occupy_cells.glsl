// SPDX-License-Identifier: MIT
// Marks the cells of triangles in the occupancy map, and hands out the strips of large ones.
//
// In:   positions, a texel a vertex; indices, a texel a triangle; with ALPHA_MASK materials,
//       texels, texcoords, colors, vertex_materials too
// Out:  base_map R32UI, see base_map.glsl
// Host: grid_origin (metres), cells_per_metre, grid_size (cells); CONSERVATIVE 0 or 1: coverage;
//       ALPHA_MASK 0 or 1: leave out what the mask leaves out; with it has_texcoords, has_colors
#include "shaders/tracers/occupancy/triangle_cells.h"
#include "shaders/tracers/occupancy/work_list.h"
#if ALPHA_MASK
#include "shaders/common/material.glsl"
layout(std430, binding = 5) readonly buffer Texcoords { vec2 texcoords[]; };
layout(std430, binding = 6) readonly buffer Colors { uint colors[]; };
layout(std430, binding = 7) readonly buffer VertexMaterials { uint vertex_materials[]; };
uniform bool has_texcoords;
uniform bool has_colors;
#endif
layout(binding = 0) uniform samplerBuffer positions;
layout(binding = 1) uniform usamplerBuffer indices;
uniform vec3 grid_origin;
uniform float cells_per_metre;
uniform ivec3 grid_size;
#include "shaders/tracers/occupancy/base_map.glsl"
layout(r32ui, binding = 0) uniform BASE_MAP_IMAGE base_map;

const bool kConservative = CONSERVATIVE != 0;

#if ALPHA_MASK
MaterialRecord mask_material = MaterialRecord(vec4(0.0), vec4(0.0), 0u, 0u, 0u, 0u);
vec3 mask_at[3] = vec3[3](vec3(0.0), vec3(0.0), vec3(0.0)); // u, v, alpha of the corners

vec3 mask_point(uint vertex) {
    vec3 point = vec3(0.0, 0.0, 1.0);
    if (has_texcoords)
        point.xy = texcoords[vertex];
    if (has_colors)
        point.z = float(colors[vertex] >> 24) * (1.0 / 255.0);
    return point;
}

bool there(CellTriangle t, ivec3 cell, int axis) {
    vec3 point = blend_corners(mask_at[0], mask_at[1], mask_at[2], corner_weights(t, cell, axis));
    return surface_is_there(mask_material, point.xy, point.z);
}
#endif

vec3 cell_position(uint vertex) {
    precise vec3 cell = (texelFetch(positions, int(vertex)).xyz - grid_origin) * cells_per_metre;
    return cell;
}

CellTriangle load_triangle(uint triangle) {
    uvec3 vertex = texelFetch(indices, int(triangle)).xyz;
    vec3 p = cell_position(vertex.x);
    vec3 q = cell_position(vertex.y);
    vec3 r = cell_position(vertex.z);
    int apex = apex_of(p, q, r);
#if ALPHA_MASK
    uvec3 turned = apex == 0 ? vertex : apex == 1 ? vertex.yzx : vertex.zxy;
    mask_material = materials[vertex_materials[vertex.x]];
    mask_at[0] = mask_point(turned.x);
    mask_at[1] = mask_point(turned.y);
    mask_at[2] = mask_point(turned.z);
#endif
    return cell_triangle(apex == 0 ? p : apex == 1 ? q : r, apex == 0 ? q : apex == 1 ? r : p,
                         apex == 0 ? r : apex == 1 ? p : q, grid_size, kConservative);
}

bool occupied(CellTriangle t, ivec3 cell) {
    int lines = 1;
    if (t.kind == kCellsTest)
        lines = occupancy_of_cell(t, cell, kConservative);
#if ALPHA_MASK
    // Looked up in a loop that most cells leave at once: software goes through both sides of an if.
    bool found = false;
    for (int i = 0; i < 3 && lines != 0; ++i) {
        int axis = kConservative ? 2 : findLSB(lines);
        found = found || there(t, cell, axis);
        lines = found ? 0 : lines & (lines - 1);
    }
    return found;
#else
    return lines != 0;
#endif
}

// Cells of one word are gathered and stored together.
BASE_MAP_PLACE open_word = BASE_MAP_PLACE(-1);
uint open_bits = 0u;

void close_word() {
    if (open_bits != 0u)
        imageAtomicOr(base_map, open_word, open_bits);
    open_bits = 0u;
}

void mark(ivec3 cell) {
    BASE_MAP_PLACE word = place_in_base_map(cell);
    if (word != open_word) {
        close_word();
        open_word = word;
    }
    open_bits |= 1u << (cell.z & 31);
}

void mark_column(CellTriangle t, int u, int v) {
    CellRange column = cells_of_column(t, u, v, kConservative);
    for (int w = column.first; w <= column.last; ++w) {
        ivec3 cell = ivec3(u, v, w);
        if (occupied(t, cell))
            mark(cell_xyz(cell, t.axis));
    }
}

void mark_row(CellTriangle t, int u, CellRange row) {
    for (int v = row.first; v <= row.last; ++v)
        mark_column(t, u, v);
}

/// Strips of 32 columns along v, aligned to words, row by row of u.
uint strip_count(CellTriangle t) {
    return uint(t.last.x - t.first.x + 1) * uint((t.last.y >> 5) - (t.first.y >> 5) + 1);
}

void mark_strip(CellTriangle t, uint strip) {
    uint rows = uint(t.last.x - t.first.x + 1);
    int u = t.first.x + int(strip % rows);
    int block = (t.first.y >> 5) + int(strip / rows);
    mark_row(t, u, cells_of_row(t, u, max(t.first.y, 32 * block), min(t.last.y, 32 * block + 31)));
}

/// Columns that a triangle spans, row by row of u; none of one that has no cells.
uint column_count(CellTriangle t) {
    return t.kind == kCellsNone ? 0u : uint(t.last.x - t.first.x + 1) * uint(t.last.y - t.first.y + 1);
}

uint piece_count(uint columns) {
    return min((columns + kColumnsPerPiece - 1u) / kColumnsPerPiece, kMostPieces);
}

void mark_column(CellTriangle t, uint column) {
    uint row = uint(t.last.y - t.first.y + 1);
    mark_column(t, t.first.x + int(column / row), t.first.y + int(column % row));
}
