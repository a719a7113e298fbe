// SPDX-License-Identifier: MIT
// Shears the base occupancy map towards every candidate direction as shear.comp.glsl does, with few
// large invocations and no barriers, as a software renderer likes it: each does 32 x 32 bits. 32
// cells of a row come with one funnel shift of two words; 32 slices of them, transposed, are the
// words of 32 columns.
//
// In:   packed_rows  the base map's packings, from shear_pack.comp.glsl
//       shear_maps   one ShearMap per direction
// Out:  aligned_maps texel ROMA_TEXELS_PER_COLUMN * (column.y * columns.x + column.x) + part of a map
//                    has up to four words of a column
// Host: SHEAR_TAPS, ROMA_WORDS_PER_TEXEL, ROMA_TEXELS_PER_COLUMN, ROMA_FORMAT, TRANSPOSE_ROWS_APART
//       0; dispatched over (columns / 32, columns, maps * ROMA_TEXELS_PER_COLUMN)
#include "shaders/tracers/roma/shear_shared.h"
#include "shaders/tracers/roma/transpose.glsl"

layout(local_size_x = 1, local_size_y = 8) in;
layout(ROMA_FORMAT, binding = 0) writeonly uniform uimageBuffer aligned_maps;
layout(binding = 0) uniform usamplerBuffer packed_rows; // a storage block would be loaded lane by lane
layout(std140, binding = 5) uniform ShearShared { ShearGrid shear_grid; };
layout(std430, binding = 1) readonly buffer ShearMaps { ShearMap shear_maps[]; };

/// In slice `slice`, the cells of the 32 columns from `first` on; those beyond the last column are
/// the first again. `size`: columns along p and q, slices.
uint cells_of_slice(ShearMap map, ivec3 size, ivec2 first, int slice) {
    if (slice >= size.z)
        return 0u;
    int m = map.slope.z;
    uint cells = 0u;
    for (int tap = 0; tap < SHEAR_TAPS; ++tap) {
        ivec2 place = shear_wrapped_column(shear_grid, m, first + shear_tap(map.slope.xy, slice, tap, SHEAR_TAPS));
        int word = place.y * shear_grid.row_words[m] + (place.x >> 5);
        int at = shear_grid.first_word[m] + word * size.z + slice;
        int shift = place.x & 31;
        uint low = texelFetch(packed_rows, at).x, high = texelFetch(packed_rows, at + size.z).x;
        cells |= (low >> shift) | ((high << 1) << (31 - shift));
    }
    return cells;
}

void main() {
    int layer = int(gl_WorkGroupID.z);
    int part = layer % ROMA_TEXELS_PER_COLUMN;
    ShearMap map = shear_maps[layer / ROMA_TEXELS_PER_COLUMN];
    ivec3 size = shear_size(shear_grid, map.slope.z);
    ivec2 first = ivec2(32 * int(gl_WorkGroupID.x), int(gl_GlobalInvocationID.y));
    if (any(greaterThanEqual(first, size.xy)))
        return;
    int first_slice = 32 * ROMA_WORDS_PER_TEXEL * part;
    uvec4 texels[32];
    for (int word = 0; word < ROMA_WORDS_PER_TEXEL; ++word) {
        uint rows[32];
        for (int row = 0; row < 32; ++row)
            rows[row] = cells_of_slice(map, size, first, first_slice + 32 * word + row);
        transpose(rows);
        for (int lane = 0; lane < 32; ++lane)
            texels[lane][word] = rows[lane];
    }
    for (int lane = 0; lane < min(32, size.x - first.x); ++lane)
        imageStore(aligned_maps, shear_texel(map, size.x, first + ivec2(lane, 0), part, ROMA_TEXELS_PER_COLUMN), texels[lane]);
}
