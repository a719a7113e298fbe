// SPDX-License-Identifier: MIT
// Empties stale cells, and marks them as used: after the pass that claims, which needs to see their
// last use. All pixels of a stale cell are listed, as it has no samples; once is enough.
//
// In:   the list of pixels; pixel_cells
// Out:  the table; hash_counts
// Host: see table.glsl and listed_pixels.glsl
#include "shaders/estimators/listed_pixels.glsl"
#include "shaders/reuse/spatial_hash/pixel_cells.h"
#include "shaders/reuse/spatial_hash/table.glsl"

layout(binding = 0) uniform usampler2D pixel_cells;
layout(std430, binding = 3) buffer HashCounts { uint hash_counts[]; };

void main() {
    ivec2 pixel;
    if (!next_listed(pixel))
        return;
    uvec2 words = texelFetch(pixel_cells, pixel, 0).xy;
    uint renewals = 0u;
    if ((words.x & kCellStale) != 0u && renew_cell(unpacked_slot(words.x)))
        ++renewals;
    if ((words.x & kLargerStale) != 0u && renew_cell(unpacked_slot(words.y)))
        ++renewals;
    if (renewals > 0u)
        atomicAdd(hash_counts[kCountRenewals], renewals);
}
