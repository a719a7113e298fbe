// SPDX-License-Identifier: MIT
// What roma_tracer.glsl needs to know of maps that were aligned by shear.
//
// In:   aligned_maps and shear_maps as shear.comp.glsl has them; shear_places, see shear_shared.h
// Host: ROMA_WORDS_PER_TEXEL, ROMA_TEXELS_PER_COLUMN
#include "shaders/tracers/roma/shear_shared.h"

layout(binding = 4) uniform usamplerBuffer aligned_maps;
layout(binding = 5) uniform usamplerBuffer shear_places;
layout(std140, binding = 5) uniform ShearShared { ShearGrid shear_grid; };
layout(std430, binding = 4) readonly buffer ShearMaps { ShearMap shear_maps[]; };

/// The cells of a span that its column has, and where that is: roma_place. For columns that
/// shear_column gives.
RomaSpan roma_inside(int map, RomaSpan span) {
    int first = shear_maps[map].rays.x;
    ivec2 entries = ivec2(first, first + shear_grid.row_words.w) + span.column;
    return shear_cut(span, texelFetch(shear_places, entries.x).xy, texelFetch(shear_places, entries.y).xy);
}

/// Likewise for any.
RomaSpan roma_bounded(int map, RomaSpan span) {
    int least = -shear_farthest(shear_maps[map].rays.y);
    span.column = clamp(span.column, least, least + shear_grid.row_words.w - 1);
    return roma_inside(map, span);
}

/// `point`: metres.
RomaRay roma_ray_in(int map, bool forward, vec3 point, vec3 normal, float t_max) {
    RomaRay ray = shear_ray(shear_grid, shear_maps[map], forward, point, normal, t_max);
    ray.span = roma_inside(map, ray.span);
    return ray;
}

RomaWalk roma_walk_in(int map, vec3 point, vec3 normal, vec3 direction, float t_max) {
    return shear_walk(shear_grid, shear_maps[map], point, normal, direction, t_max);
}

float roma_crossings_in(int map, vec3 direction) {
    return roma_crossings(shear_aligned(shear_maps[map], direction));
}

/// Whether a ray passes no cell: masks of both ends leave none for it, which takes less than to ask.
bool roma_passes_none(RomaSpan span) { return false; }

int roma_slice_count(int map) { return shear_maps[map].rays.y; }

bool roma_forward_in(int map, vec3 direction) { return shear_is_forward(shear_maps[map], direction); }

float roma_metres_per_slice(int map) { return shear_maps[map].scale.w; }

/// Where the texels of the column of a span are that has been cut to it.
#define ROMA_PLACE int
int roma_place(int map, ivec2 column) { return column.x; }

uvec4 roma_texel(int map, int place, int part) { return texelFetch(aligned_maps, place + part); }

/// The column's interval in the grid bounds every ray at both ends. Two half masks take less than
/// bits_in_range, which looks at the order of the ends besides.
uint roma_mask(int word, RomaSpan span, bool forward, bool unbounded) {
    return bits_from(word, span.first, false) & bits_from(word, span.last + 1, true);
}

ivec3 aligned_map_size(int map) { return shear_size(shear_grid, shear_maps[map].slope.z); }

uint aligned_map_word(int map, ivec2 column, int word) {
    int place = shear_texel(shear_maps[map], aligned_map_size(map).x, column, 0, ROMA_TEXELS_PER_COLUMN);
    return roma_texel(map, place, word / ROMA_WORDS_PER_TEXEL)[word % ROMA_WORDS_PER_TEXEL];
}
