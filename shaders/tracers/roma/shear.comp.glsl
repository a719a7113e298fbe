// SPDX-License-Identifier: MIT
// Shears the base occupancy map towards every candidate direction, and tables the places of
// columns, all in one dispatch. The base map has its bits along z.
//
// Slices along x and y: an invocation has a slice, and turns a row of it, which lies along p = z, by
// as many bits as it is moved. 32 slices of 32 columns, transposed, are the words of those columns.
// A work group has a row of columns.
//
// Slices along z: words have their bits along the slices already, so that a word of a column takes
// one bit from each of 32 words. An invocation has a column, a work group those of one row, to which
// where the rows of the base map begin is common. One for each word of a column takes longer: more
// work groups.
//
// In:   base_words   see base_map.h
//       shear_maps   one ShearMap per direction
// Out:  aligned_maps texel ROMA_TEXELS_PER_COLUMN * (column.y * columns.x + column.x) + part of a map
//                    has up to four words of a column
//       shear_places, see shear_table.glsl
// Host: SHEAR_TAPS, ROMA_WORDS_PER_TEXEL, ROMA_TEXELS_PER_COLUMN, ROMA_FORMAT, TRANSPOSE_ROWS_APART
//       1; base_size, cells; dispatched over (work groups of a map and part, maps *
//       ROMA_TEXELS_PER_COLUMN + 1), see main
#include "shaders/tracers/occupancy/base_map.h"
#include "shaders/tracers/roma/shear_shared.h"
#include "shaders/tracers/roma/shear_table.glsl"

layout(local_size_x = 32, local_size_y = ROMA_WORDS_PER_TEXEL) in;
#define TRANSPOSE_BLOCKS ROMA_WORDS_PER_TEXEL
#define TRANSPOSE_ROW uvec4
#include "shaders/tracers/roma/transpose.glsl"

layout(ROMA_FORMAT, binding = 0) writeonly uniform uimageBuffer aligned_maps;
layout(std430, binding = 0) readonly buffer BaseMap { uint base_words[]; };
uniform ivec3 base_size;

const int kInvocations = 32 * ROMA_WORDS_PER_TEXEL; ///< of a work group

// Loads are not put behind conditions, which would have each wait for the one before.

/// A word of the base map, with nothing around it.
uint base_word(ivec2 at, int word) {
    int last = (base_size.z - 1) >> 5;
    bool inside = word <= last;
#if SHEAR_TAPS > 1
    inside = inside && all(lessThan(at, base_size.xy)); // not in the guard
    at = min(at, base_size.xy - 1);
#endif
    uint cells = base_words[base_place(base_size, at.x, at.y, min(word, last))];
    return inside ? cells : 0u;
}

/// Of the longest row along z, the guard's cells included.
const int kRowWords = ROMA_WORDS_PER_TEXEL * ROMA_TEXELS_PER_COLUMN + (SHEAR_TAPS > 1 ? 1 : 0);

#define MOVE_DOWN(span)                                                                                                \
    for (int i = 0; i < kRowWords; ++i)                                                                                \
        row[i] = (bits & (32 * span)) == 0 ? row[i] : i + span < kRowWords ? row[min(i + span, kRowWords - 1)] : 0u;
#define MOVE_UP(span)                                                                                                  \
    for (int i = kRowWords - 1; i >= 0; --i)                                                                           \
        row[i] = (bits & (32 * span)) == 0 ? row[i] : i >= span ? row[max(i - span, 0)] : 0u;

/// The cells of a row from `bits` on.
void move_down(inout uint row[kRowWords], int bits) {
    if (kRowWords > 8)
        MOVE_DOWN(8)
    if (kRowWords > 4)
        MOVE_DOWN(4)
    if (kRowWords > 2)
        MOVE_DOWN(2)
    if (kRowWords > 1)
        MOVE_DOWN(1)
    int shift = bits & 31;
    for (int i = 0; i < kRowWords; ++i)
        row[i] = (row[i] >> shift) | (i + 1 < kRowWords ? (row[min(i + 1, kRowWords - 1)] << 1) << (31 - shift) : 0u);
}

/// `bits` empty cells, then a row.
void move_up(inout uint row[kRowWords], int bits) {
    if (kRowWords > 8)
        MOVE_UP(8)
    if (kRowWords > 4)
        MOVE_UP(4)
    if (kRowWords > 2)
        MOVE_UP(2)
    if (kRowWords > 1)
        MOVE_UP(1)
    int shift = bits & 31;
    for (int i = kRowWords - 1; i >= 0; --i)
        row[i] = (row[i] << shift) | (i > 0 ? (row[max(i - 1, 0)] >> 1) >> (31 - shift) : 0u);
}

/// Adds the cells of the columns of row `row` in slice `slice`, along x or y.
void add_slice(ShearMap map, ivec3 size, int row, int slice, inout uint cells[kRowWords]) {
    int m = map.slope.z;
    for (int tap = 0; tap < SHEAR_TAPS; ++tap) {
        ivec2 place = shear_wrapped_column(shear_grid, m, ivec2(0, row) + shear_tap(map.slope.xy, slice, tap, SHEAR_TAPS));
        ivec2 at = m == 0 ? ivec2(slice, place.y) : ivec2(place.y, slice);
        uint later[kRowWords], again[kRowWords];
        for (int i = 0; i < kRowWords; ++i)
            later[i] = again[i] = base_word(at, i);
        move_down(later, place.x);
        move_up(again, size.x - place.x); // as far as the row has words: then it is the same again
        for (int i = 0; i < kRowWords; ++i)
            cells[i] |= later[i] | again[i];
    }
}

shared uint exchanged[4][ROMA_WORDS_PER_TEXEL][32];

/// Row `row` of the columns of a map with slices along x or y; part `part` of them.
void shear_row(ShearMap map, ivec3 size, int row, int part) {
    int lane = int(gl_LocalInvocationID.x), word = int(gl_LocalInvocationID.y);
    int slice = 32 * (ROMA_WORDS_PER_TEXEL * part + word) + lane;
    uint cells[kRowWords];
    for (int i = 0; i < kRowWords; ++i)
        cells[i] = 0u;
    if (slice < size.z)
        add_slice(map, size, row, slice, cells);
    for (int chunk = 0; 4 * chunk < kRowWords; ++chunk) {
        int first = 128 * chunk;
        if (first >= size.x)
            break;
        uvec4 four = uvec4(0u);
        for (int i = 0; i < 4; ++i)
            four[i] = 4 * chunk + i < kRowWords ? cells[min(4 * chunk + i, kRowWords - 1)] : 0u;
        uvec4 columns = transposed(four);
        for (int i = 0; i < 4; ++i)
            exchanged[i][word][lane] = columns[i];
        barrier();
        for (int i = word; i < 4; i += ROMA_WORDS_PER_TEXEL) {
            uvec4 texel = uvec4(0u);
            for (int k = 0; k < ROMA_WORDS_PER_TEXEL; ++k)
                texel[k] = exchanged[i][k][lane];
            ivec2 column = ivec2(first + 32 * i + lane, row);
            if (column.x < size.x)
                imageStore(aligned_maps, shear_texel(map, size.x, column, part, ROMA_TEXELS_PER_COLUMN), texel);
        }
    }
}

/// Of each slice of a part, where the first column of a row has its cell: x, and the first word of
/// its row in a layer of base words, below 0 for the guard.
shared ivec2 places[SHEAR_TAPS][kInvocations];

/// The word of column `column` of that row whose slices along z are those of layer `layer` of base
/// words; `first_place`: of its slices in `places`.
uint word_of_column(ivec3 size, uint column, int layer, int first_place) {
    uint first_word = uint(layer * base_size.y * base_size.x);
    uint bits = 0u;
    for (int k = 0; k < 32; ++k) {
        for (int tap = 0; tap < SHEAR_TAPS; ++tap) {
            ivec2 place = places[tap][first_place + k];
            uint x = column + uint(place.x);
            x = min(x, x - uint(size.x)); // wrapped: the lesser, as one below 0 is a large one
#if SHEAR_TAPS > 1
            bool inside = x < uint(base_size.x) && place.y >= 0;
            bits |= (inside ? base_words[first_word + uint(place.y) + x] : 0u) & (1u << k);
#else
            bits |= base_words[first_word + uint(place.y) + x] & (1u << k);
#endif
        }
    }
    return bits;
}

/// As many columns as invocations of row `row` of a map with slices along z, from `first` on; part
/// `part` of them.
void shear_columns(ShearMap map, ivec3 size, int row, int first, int part) {
    int invocation = int(gl_LocalInvocationIndex);
    for (int tap = 0; tap < SHEAR_TAPS; ++tap) {
        ivec2 moved = shear_tap(map.slope.xy, kInvocations * part + invocation, tap, SHEAR_TAPS);
        ivec2 place = shear_wrapped_column(shear_grid, 2, moved + ivec2(0, row));
        places[tap][invocation] = ivec2(place.x, place.y < base_size.y ? place.y * base_size.x : -1);
    }
    barrier();
    int column = first + invocation;
    if (column >= size.x)
        return;
    uvec4 texel = uvec4(0u);
    for (int word = 0; word < ROMA_WORDS_PER_TEXEL; ++word) {
        int layer = ROMA_WORDS_PER_TEXEL * part + word;
        if (32 * layer >= size.z)
            break;
        texel[word] = word_of_column(size, uint(column), layer, 32 * word);
    }
    imageStore(aligned_maps, shear_texel(map, size.x, ivec2(column, row), part, ROMA_TEXELS_PER_COLUMN), texel);
}

void main() {
    int layer = int(gl_WorkGroupID.y), group = int(gl_WorkGroupID.x);
    if (layer == int(gl_NumWorkGroups.y) - 1) {
        table_places(group * kInvocations + int(gl_LocalInvocationIndex), int(gl_NumWorkGroups.x) * kInvocations);
        return;
    }
    int part = layer % ROMA_TEXELS_PER_COLUMN;
    ShearMap map = shear_maps[layer / ROMA_TEXELS_PER_COLUMN];
    ivec3 size = shear_size(shear_grid, map.slope.z);
    if (map.slope.z == 2) {
        int across = (size.x + kInvocations - 1) / kInvocations;
        int row = group / across;
        if (row < size.y)
            shear_columns(map, size, row, kInvocations * (group - row * across), part);
    } else if (group < size.y) {
        shear_row(map, size, group, part);
    }
}
