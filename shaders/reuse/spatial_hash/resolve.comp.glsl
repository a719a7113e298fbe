// SPDX-License-Identifier: MIT
// Reads each pixel's visibility from its cells. A pixel without any keeps what its own rays saw.
//
// In:   pixel_cells; the table, with this frame's samples
// Out:  visibility, R16; background is 1
// Host: see table.glsl; picture_size
#include "shaders/reuse/spatial_hash/pixel_cells.h"
#include "shaders/reuse/spatial_hash/table.glsl"

layout(local_size_x = 16, local_size_y = 8) in;
layout(binding = 0) uniform usampler2D pixel_cells;
layout(r16, binding = 0) writeonly uniform image2D visibility;
uniform ivec2 picture_size;

/// Hits and samples in the slot of a packed word; zeros for none.
vec2 sums_of(uint word) {
    uint slot = unpacked_slot(word);
    if (slot == kNoSlot)
        return vec2(0.0);
    Cell cell = load_cell(slot);
    return vec2(cell_hits(cell), cell_samples(cell));
}

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(pixel, picture_size)))
        return;
    uvec2 words = texelFetch(pixel_cells, pixel, 0).xy;
    float hits = 0.0;
    if ((words.x & kSeesSurface) != 0u)
        hits = blended_hits(sums_of(words.x), sums_of(words.y), larger_weight(words.y));
    if (hits >= 0.0)
        imageStore(visibility, pixel, vec4(1.0 - hits));
}
