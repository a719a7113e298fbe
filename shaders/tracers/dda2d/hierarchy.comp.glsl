// SPDX-License-Identifier: MIT
// All levels of the hierarchy in one go: a work group takes 32 x 32 columns of a layer of words.
//
// In:   base_map R32UI, (Nx, Ny, ceil(Nz / 32))
// Out:  levels R32UI, as hierarchy_levels.h has them
// Host: base_size: Nx, Ny, ceil(Nz / 32)
#include "shaders/tracers/dda2d/hierarchy_levels.h"

layout(local_size_x = 16, local_size_y = 16) in;
layout(binding = 0) uniform usampler3D base_map;
layout(r32ui, binding = 0) writeonly uniform uimage3D levels;
uniform ivec3 base_size;

shared uint tile[16][16];

uint base_word(ivec2 column) {
    return all(lessThan(column, base_size.xy)) ? texelFetch(base_map, ivec3(column, gl_WorkGroupID.z), 0).x : 0u;
}

void main() {
    ivec2 place = ivec2(gl_LocalInvocationID.xy);
    ivec2 first = 2 * ivec2(gl_GlobalInvocationID.xy);
    uint word = base_word(first) | base_word(first + ivec2(1, 0)) | base_word(first + ivec2(0, 1)) |
                base_word(first + ivec2(1, 1));
    int padded = hierarchy_padded(base_size.x);
    for (int level = 1; level <= kHierarchyLevels; ++level) {
        int side = 32 >> level; // columns of this level in the group's share
        bool mine = all(lessThan(place, ivec2(side)));
        if (level > 1) {
            if (mine)
                word = tile[2 * place.y][2 * place.x] | tile[2 * place.y][2 * place.x + 1] |
                       tile[2 * place.y + 1][2 * place.x] | tile[2 * place.y + 1][2 * place.x + 1];
            barrier();
        }
        if (mine) {
            tile[place.y][place.x] = word;
            ivec2 column = ivec2(gl_WorkGroupID.xy) * side + place;
            imageStore(levels, ivec3(hierarchy_begin(level, padded) + column.x, column.y, gl_WorkGroupID.z), uvec4(word));
        }
        barrier();
    }
}
