// SPDX-License-Identifier: MIT
// What roma_tracer.glsl needs to know of maps that were aligned by rotation.
//
// In:   aligned_maps and roma_directions as rotate.comp.glsl has them; roma_centre of all boxes, metres
// Host: ROMA_SIDE, ROMA_WORDS_PER_TEXEL, ROMA_TEXELS_PER_COLUMN
#include "shaders/tracers/roma/roma_shared.h"

layout(binding = 4) uniform usampler2DArray aligned_maps;
layout(std430, binding = 4) readonly buffer RomaDirections { RomaDirection roma_directions[]; };

/// `point`: metres.
RomaRay roma_ray_in(int map, bool forward, vec3 point, vec3 normal, float t_max) {
    precise vec3 relative = point - roma_centre.xyz;
    return roma_ray(roma_directions[map], forward, relative, normal, t_max, ROMA_SIDE);
}

RomaWalk roma_walk_in(int map, vec3 point, vec3 normal, vec3 direction, float t_max) {
    precise vec3 relative = point - roma_centre.xyz;
    return roma_walk_in_box(roma_directions[map], relative, normal, direction, t_max, ROMA_SIDE);
}

float roma_crossings_in(int map, vec3 direction) {
    return roma_crossings(roma_turned(roma_directions[map], direction));
}

/// The cells of a span that its column has.
RomaSpan roma_bounded(int map, RomaSpan span) {
    return roma_in_box(span, ROMA_SIDE);
}

/// Whether a ray passes no cell. Half a mask would have some for it.
bool roma_passes_none(RomaSpan span) { return span.first > span.last; }

int roma_slice_count(int map) { return ROMA_SIDE; }

bool roma_forward_in(int map, vec3 direction) { return roma_is_forward(roma_directions[map], direction); }

float roma_metres_per_slice(int map) { return roma_directions[map].row_v.w; }

/// Where the texels of a column are.
#define ROMA_PLACE ivec2
ivec2 roma_place(int map, ivec2 column) { return column; }

uvec4 roma_texel(int map, ivec2 column, int part) {
    return texelFetch(aligned_maps, ivec3(column, map * ROMA_TEXELS_PER_COLUMN + part), 0);
}

/// A ray without an end passes all cells on one side of its start, which takes half a mask.
uint roma_mask(int word, RomaSpan span, bool forward, bool unbounded) {
    return unbounded ? bits_from(word, forward ? span.first : span.last + 1, !forward)
                     : bits_in_range(word, span.first, span.last);
}

ivec3 aligned_map_size(int map) { return ivec3(ROMA_SIDE); }

uint aligned_map_word(int map, ivec2 column, int word) {
    return roma_texel(map, column, word / ROMA_WORDS_PER_TEXEL)[word % ROMA_WORDS_PER_TEXEL];
}
