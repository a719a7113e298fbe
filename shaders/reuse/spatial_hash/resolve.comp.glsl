// SPDX-License-Identifier: MIT
// Reads the visibility of each pixel that traced from its cells. A pixel without any keeps what its
// own rays saw.
//
// In:   the list of pixels; pixel_cells; the table, with this frame's samples
// Out:  visibility, R16
// Host: see table.glsl and listed_pixels.glsl
#include "shaders/estimators/listed_pixels.glsl"
#include "shaders/reuse/spatial_hash/pixel_cells.h"
#include "shaders/reuse/spatial_hash/table.glsl"

layout(binding = 0) uniform usampler2D pixel_cells;
layout(r16, binding = 0) writeonly uniform image2D visibility;

/// Hits and samples in the slot of a packed word, which is in use; zeros for none.
vec2 sums_of(uint word) {
    uint slot = unpacked_slot(word);
    if (slot == kNoSlot)
        return vec2(0.0);
    uvec2 sums = hash_sums[slot];
    return vec2(sums.x, sums.y & kSamplesMask);
}

void main() {
    ivec2 pixel;
    if (!next_listed(pixel))
        return;
    uvec2 words = texelFetch(pixel_cells, pixel, 0).xy;
    float hits = blended_hits(sums_of(words.x), sums_of(words.y), larger_weight(words.y));
    if (hits >= 0.0)
        imageStore(visibility, pixel, vec4(1.0 - hits));
}
