// SPDX-License-Identifier: MIT
// View: one aligned map, looking along its rays. A slice at right angles to them, white: occupied,
// black: empty; or of each column the share of its cells that are occupied, as grey. Blue: outside
// the map. Columns along the map's first axis lie to the right, those along its second up.
//
// In:   "tracer.glsl": aligned_map_size, aligned_map_word
// Out:  picture RGBA32F
// Host: map: which one; columns 0 or 1: show the columns; picture_size, slice
#include "tracer.glsl"
#include "shaders/tracers/cells.glsl"

layout(local_size_x = 16, local_size_y = 16) in;
layout(rgba32f, binding = 0) writeonly uniform image2D picture;
uniform int map;
uniform int columns;

float share_of_column(ivec2 column, int cells) {
    int words = (cells + 31) / 32;
    int count = 0;
    for (int word = 0; word < words; ++word)
        count += bitCount(aligned_map_word(map, column, word));
    return float(count) / float(cells);
}

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(pixel, picture_size)))
        return;
    ivec3 size = aligned_map_size(map);
    ivec2 place = cell_at(pixel, size.xy);
    vec3 color = kOutsideColor;
    if (place.x >= 0) {
        ivec2 column = ivec2(place.x, size.y - 1 - place.y);
        int cell = chosen_slice(size.z);
        uint word = aligned_map_word(map, column, cell >> 5);
        color = vec3(columns != 0 ? share_of_column(column, size.z) : float((word >> (cell & 31)) & 1u));
    }
    imageStore(picture, pixel, vec4(color, 1.0));
}
