// SPDX-License-Identifier: MIT
// Adds the rays of each pixel that traced some to the cells that take them.
//
// In:   the list of pixels; pixel_cells; visibility: the share of the pixel's rays that met nothing
// Out:  the table
// Host: see table.glsl and listed_pixels.glsl; AO_RAYS
#include "shaders/estimators/listed_pixels.glsl"
#include "shaders/reuse/spatial_hash/pixel_cells.h"
#include "shaders/reuse/spatial_hash/table.glsl"

layout(binding = 0) uniform usampler2D pixel_cells;
layout(binding = 1) uniform sampler2D visibility;

void main() {
    ivec2 pixel;
    if (!next_listed(pixel))
        return;
    uvec2 words = texelFetch(pixel_cells, pixel, 0).xy;
    float free = texelFetch(visibility, pixel, 0).x * float(AO_RAYS);
    uint hits = uint(AO_RAYS) - uint(free + 0.5);
    if ((words.x & kCellTakes) != 0u)
        add_to_cell(unpacked_slot(words.x), hits, uint(AO_RAYS));
    if ((words.x & kLargerTakes) != 0u)
        add_to_cell(unpacked_slot(words.y), hits, uint(AO_RAYS));
}
