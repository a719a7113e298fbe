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

/// The cells of a span that its column has, and the place of that.
RomaSpan roma_bounded(int map, RomaSpan span) {
    ivec3 size = shear_size(shear_grid, shear_maps[map].slope.z);
    int along_p = shear_entry(shear_grid, map, 0, span.column.x, size.x, size.z);
    int along_q = shear_entry(shear_grid, map, 1, span.column.y, size.y, size.z);
    return shear_inside(span, shear_unpacked(texelFetch(shear_places, along_p).x),
                        shear_unpacked(texelFetch(shear_places, along_q).x));
}

/// `point`: metres.
RomaRay roma_ray_in(int map, bool forward, vec3 point, vec3 normal, float t_max) {
    RomaRay ray = shear_ray(shear_grid, shear_maps[map], forward, point, normal, t_max);
    ray.span = roma_bounded(map, ray.span);
    return ray;
}

RomaWalk roma_walk_in(int map, vec3 point, vec3 normal, vec3 direction, float t_max) {
    return shear_walk(shear_grid, shear_maps[map], point, normal, direction, t_max);
}

float roma_crossings_in(int map, vec3 direction) {
    return roma_crossings(shear_turned_direction(shear_maps[map], direction));
}

int roma_slice_count(int map) { return shear_size(shear_grid, shear_maps[map].slope.z).z; }

bool roma_forward_in(int map, vec3 direction) { return shear_is_forward(shear_maps[map], direction); }

float roma_metres_per_slice(int map) { return shear_maps[map].scale.w; }

/// Where the texels of a column are.
#define ROMA_PLACE int
int roma_place(int map, ivec2 column) {
    ShearMap sheared = shear_maps[map];
    int row = shear_turned(shear_grid.columns.xyz, sheared.slope.z).x;
    return shear_texel(sheared, row, column, 0, ROMA_TEXELS_PER_COLUMN);
}

uvec4 roma_texel(int map, int place, int part) { return texelFetch(aligned_maps, place + part); }

/// The column's interval in the grid bounds every ray at both ends.
uint roma_mask(int word, RomaSpan span, bool forward, bool unbounded) {
    return bits_in_range(word, span.first, span.last);
}

ivec3 aligned_map_size(int map) { return shear_size(shear_grid, shear_maps[map].slope.z); }

uint aligned_map_word(int map, ivec2 column, int word) {
    return roma_texel(map, roma_place(map, column), word / ROMA_WORDS_PER_TEXEL)[word % ROMA_WORDS_PER_TEXEL];
}
