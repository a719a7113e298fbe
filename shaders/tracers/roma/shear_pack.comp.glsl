// SPDX-License-Identifier: MIT
// Packs the base occupancy map anew for the shear: bits along x or y instead of z, slices side by
// side, 32 x 32 bits at a time. See ShearPacking (renderer/tracers/roma/shear.h) for the layout.
//
// In:   base_map R32UI, (Nx, Ny, ceil(Nz / 32)): bit b of texel z is cell 32 z + b along z
//       shear_maps, one ShearMap per direction
// Out:  packed_rows: the words of the packings for slices along x, y, z
//       shear_places: the table of places along p and q
// Host: TRANSPOSE_ROWS_APART 0 or 1 and, for it, TRANSPOSE_BLOCKS 4; base_size, cells; guard, empty
//       cells on each side; first_word of each packing; row_words of rows along x, of those along y;
//       map_count. Dispatched over (others, words of a row, 2 x words along z + 1), see main
#if TRANSPOSE_ROWS_APART
layout(local_size_x = 32, local_size_y = TRANSPOSE_BLOCKS) in;
#define TRANSPOSE_ROW uint
#else
layout(local_size_x = 1, local_size_y = 8) in;
#endif
#include "shaders/tracers/roma/shear_shared.h"
#include "shaders/tracers/roma/transpose.glsl"

layout(binding = 0) uniform usampler3D base_map;
layout(std430, binding = 0) writeonly buffer PackedRows { uint packed_rows[]; };
layout(std430, binding = 1) readonly buffer ShearMaps { ShearMap shear_maps[]; };
layout(std430, binding = 2) writeonly buffer ShearPlaces { uint shear_places[]; };
layout(std140, binding = 5) uniform ShearShared { ShearGrid shear_grid; };
uniform ivec3 base_size;
uniform int guard;
uniform ivec3 first_word;
uniform ivec2 row_words;
uniform int map_count;

/// A block: 32 cells along x (`axis` 0) or y (1) from word `word` of a row on, 32 cells along z, at
/// one place along the other of x and y.
struct Block {
    int axis, other, word, layer;
};

/// Its 32 cells along z at place `row` of the row of cells, before it is transposed.
uint base_word(Block block, int row) {
    int period = base_size[block.axis] + 2 * guard;
    int place = int(uint(32 * block.word + row) % uint(period));
    ivec2 at = block.axis == 0 ? ivec2(place, block.other) : ivec2(block.other, place);
    bool inside = all(lessThan(ivec3(at, 32 * block.layer), base_size));
    return inside ? texelFetch(base_map, ivec3(at, block.layer), 0).x : 0u;
}

/// Word `block.word` of the rows at place 32 * block.layer + `lane` along z.
void store(Block block, int lane, uint bits) {
    int z = 32 * block.layer + lane;
    if (block.word >= row_words[block.axis])
        return;
    if (block.other < base_size[1 - block.axis] && z < base_size.z + 2 * guard)
        packed_rows[first_word[block.axis == 0 ? 1 : 0] +
                    (z * row_words[block.axis] + block.word) * base_size[1 - block.axis] + block.other] = bits;
    if (block.axis == 0 && block.other < base_size.y + 2 * guard && z < base_size.z)
        packed_rows[first_word.z + (block.other * row_words.x + block.word) * base_size.z + z] = bits;
}

/// The last layer of work groups tables the places of columns.
void table_places() {
    uint invocations = gl_WorkGroupSize.x * gl_WorkGroupSize.y;
    uint group = gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x;
    int step = int(gl_NumWorkGroups.x * gl_NumWorkGroups.y * invocations);
    int places = shear_grid.row_words.w;
    int count = 2 * map_count * places;
    for (int i = int(group * invocations + gl_LocalInvocationIndex); i < count; i += step) {
        ShearMap map = shear_maps[i / (2 * places)];
        int place = shear_place_of_entry(i % places, shear_size(shear_grid, map.slope.z).z);
        ShearPlace found = (i / places) % 2 == 0 ? shear_place_along_p(shear_grid, map, place)
                                                 : shear_place_along_q(shear_grid, map, place);
        shear_places[i] = shear_packed(found);
    }
}

void main() {
    if (gl_WorkGroupID.z == gl_NumWorkGroups.z - 1u) {
        table_places();
        return;
    }
    // x: words of a row; y: places along the other axis; z: words along z, for rows along x and y.
    Block block;
    block.axis = int(gl_WorkGroupID.z) & 1;
    block.layer = int(gl_WorkGroupID.z) >> 1;
    block.word = int(gl_WorkGroupID.x);
    block.other = int(gl_GlobalInvocationID.y);
#if TRANSPOSE_ROWS_APART
    int lane = int(gl_LocalInvocationID.x);
    store(block, lane, transposed(base_word(block, lane)));
#else
    uint rows[32];
    for (int row = 0; row < 32; ++row)
        rows[row] = base_word(block, row);
    transpose(rows);
    for (int lane = 0; lane < 32; ++lane)
        store(block, lane, rows[lane]);
#endif
}
