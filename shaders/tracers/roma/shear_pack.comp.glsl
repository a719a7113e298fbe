// SPDX-License-Identifier: MIT
// Packs the base occupancy map anew for shear_blocks.comp.glsl: rows along z with some of their
// cells repeated, slices side by side, and rows along x for slices along z. See ShearPacking
// (renderer/tracers/roma/shear.h) for the layout. Tables the places of columns besides.
//
// In:   base_map R32UI, see base_map.h
//       shear_maps, one ShearMap per direction
// Out:  packed_rows: the words of the packings for slices along x, y, z
//       shear_places, see shear_table.glsl
// Host: TRANSPOSE_ROWS_APART 0; ROMA_TEXELS_PER_COLUMN; base_size, cells. Dispatched over (words of a row along x, rows,
//       words along z + 2)
layout(local_size_x = 1, local_size_y = 8) in;
#include "shaders/tracers/occupancy/base_map.h"
#include "shaders/tracers/roma/shear_shared.h"
#include "shaders/tracers/roma/shear_table.glsl"
#include "shaders/tracers/roma/transpose.glsl"

layout(binding = 0) uniform usamplerBuffer base_map;
layout(std430, binding = 0) writeonly buffer PackedRows { uint packed_rows[]; };
uniform ivec3 base_size;

uint base_word(ivec2 at, int word) { return texelFetch(base_map, base_place(base_size, at.x, at.y, word)).x; }

/// 32 cells along z from a place on, with nothing around the base map.
uint cells_along_z(ivec2 at, int place) {
    int word = place >> 5, shift = place & 31, words = (base_size.z + 31) >> 5;
    if (any(greaterThanEqual(at, base_size.xy)))
        return 0u;
    uint low = word < words ? base_word(at, word) : 0u;
    uint high = word + 1 < words ? base_word(at, word + 1) : 0u;
    return (low >> shift) | ((high << 1) << (31 - shift));
}

/// Word `word` of the row along z, whose cells repeat.
uint repeated_along_z(ivec2 at, int word) {
    int count = shear_grid.columns.z;
    int place = int(uint(32 * word) % uint(count));
    int filled = 0;
    uint bits = 0u;
    for (int turn = 0; turn < 32; ++turn) {
        if (filled >= 32)
            break;
        bits |= cells_along_z(at, place) << filled;
        filled += count - place;
        place = 0;
    }
    return bits;
}

/// Rows along z, for slices along x and y. One invocation of `count` that share them.
void pack_along_z(int invocation, int count) {
    ivec2 rows = shear_grid.columns.xy;
    int row_words = shear_grid.row_words.x;
    for (int i = invocation; i < rows.x * rows.y; i += count) {
        ivec2 at = ivec2(i % rows.x, i / rows.x);
        for (int word = 0; word < row_words; ++word) {
            uint bits = repeated_along_z(at, word);
            if (at.x < base_size.x)
                packed_rows[shear_grid.first_word.x + (at.y * row_words + word) * base_size.x + at.x] = bits;
            if (at.y < base_size.y)
                packed_rows[shear_grid.first_word.y + (at.x * row_words + word) * base_size.y + at.y] = bits;
        }
    }
}

/// Word `word` of rows along x at 32 slices along z.
void pack_along_x(int word, int y, int layer) {
    if (y >= shear_grid.columns.y)
        return;
    uint rows[32];
    for (int row = 0; row < 32; ++row) {
        ivec2 at = ivec2(int(uint(32 * word + row) % uint(shear_grid.columns.x)), y);
        bool inside = all(lessThan(at, base_size.xy));
        rows[row] = inside ? base_word(at, layer) : 0u;
    }
    transpose(rows);
    int first = shear_grid.first_word.z + (y * shear_grid.row_words.z + word) * base_size.z + 32 * layer;
    for (int lane = 0; lane < min(32, base_size.z - 32 * layer); ++lane)
        packed_rows[first + lane] = rows[lane];
}

void main() {
    int layer = int(gl_WorkGroupID.z), layers = int(gl_NumWorkGroups.z) - 2;
    int word = int(gl_WorkGroupID.x), y = int(gl_GlobalInvocationID.y);
    int words = int(gl_NumWorkGroups.x);
    int invocation = y * words + word, count = int(gl_NumWorkGroups.y * gl_WorkGroupSize.y) * words;
    if (layer == layers)
        pack_along_z(invocation, count);
    else if (layer == layers + 1)
        table_places(invocation, count);
    else
        pack_along_x(word, y, layer);
}
