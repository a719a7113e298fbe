// SPDX-License-Identifier: MIT
// Rotates the base occupancy map to every candidate direction (Zeng et al. 2023, Algorithm 1): each
// bit of an aligned map is the base cell at the centre of the aligned cell.
//
// In:   base_map     R32UI, (Nx, Ny, ceil(Nz / 32)): bit b of texel z is cell 32 z + b along z
//       directions   one RomaDirection per map
// Out:  aligned_maps layer = map * ROMA_TEXELS_PER_COLUMN + part; a texel holds up to four words
// Host: ROMA_SIDE, ROMA_WORDS_PER_TEXEL, ROMA_TEXELS_PER_COLUMN, ROMA_FORMAT, ROMA_GROUP_WORDS
#include "shaders/tracers/roma/roma_shared.h"

layout(local_size_x = 8, local_size_y = 8, local_size_z = ROMA_GROUP_WORDS) in;

layout(binding = 0) uniform usampler3D base_map;
layout(ROMA_FORMAT, binding = 0) writeonly uniform uimage2DArray aligned_maps;
layout(std430, binding = 1) readonly buffer Directions { RomaDirection directions[]; };
uniform ivec3 base_size;

#if ROMA_GROUP_WORDS > 1
shared uint words[ROMA_GROUP_WORDS][64];
#endif

bool base_cell(ivec3 cell) {
    if (any(greaterThanEqual(uvec3(cell), uvec3(base_size)))) // also those below 0
        return false;
    uint word = texelFetch(base_map, ivec3(cell.xy, cell.z >> 5), 0).x;
    return ((word >> (cell.z & 31)) & 1u) != 0u;
}

uint aligned_word(RomaDirection map, ivec2 column, int word) {
    ivec3 position = roma_base_position(map, ivec3(column, 32 * word));
    int count = min(ROMA_SIDE - 32 * word, 32);
    uint bits = 0u;
    for (int k = 0; k < count; ++k) {
        if (base_cell(position >> kRomaFractionBits))
            bits |= 1u << k;
        position += map.base_step_w.xyz;
    }
    return bits;
}

void main() {
    ivec2 column = ivec2(gl_GlobalInvocationID.xy);
    int layer = int(gl_WorkGroupID.z);
    RomaDirection map = directions[layer / ROMA_TEXELS_PER_COLUMN];
    int first_word = (layer % ROMA_TEXELS_PER_COLUMN) * ROMA_WORDS_PER_TEXEL;
    uvec4 texel = uvec4(0u);
#if ROMA_GROUP_WORDS > 1
    // One invocation a word; the first of each column gathers its texel.
    int part = int(gl_LocalInvocationID.z);
    uint lane = gl_LocalInvocationID.y * 8u + gl_LocalInvocationID.x;
    words[part][lane] = aligned_word(map, column, first_word + part);
    barrier();
    if (part != 0)
        return;
    for (int i = 0; i < ROMA_GROUP_WORDS; ++i)
        texel[i] = words[i][lane];
#else
    for (int i = 0; i < ROMA_WORDS_PER_TEXEL; ++i)
        texel[i] = aligned_word(map, column, first_word + i);
#endif
    if (all(lessThan(column, ivec2(ROMA_SIDE))))
        imageStore(aligned_maps, ivec3(column, layer), texel);
}
