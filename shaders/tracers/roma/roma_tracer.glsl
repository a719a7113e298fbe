// SPDX-License-Identifier: MIT
// Tracer: snapped rays through ray-aligned occupancy maps (Zeng et al. 2023, Algorithm 2), in
// constant time. A ray is snapped to the candidate of its stratum, or the estimator chooses among
// the candidates itself.
//
// Gives: tracer_any_hit, tracer_closest_hit (metres from the surface, negative for a miss); for the
//        candidate in a place of its order, turned to the side of the normal: tracer_candidate,
//        tracer_candidate_any_hit, tracer_candidate_closest_hit; for views: aligned_map_size,
//        aligned_map_word
// In:    aligned_maps and directions as rotate.comp.glsl has them
// Host:  ROMA_ANGULAR_RESOLUTION, ROMA_SIDE, ROMA_WORDS_PER_TEXEL, ROMA_LAYERS_PER_MAP
#include "shaders/tracers/roma/concentric.h"
#include "shaders/tracers/roma/roma_shared.h"

#define TRACER_CANDIDATE_COUNT (ROMA_ANGULAR_RESOLUTION * ROMA_ANGULAR_RESOLUTION)
#define ROMA_WORDS (ROMA_WORDS_PER_TEXEL * ROMA_LAYERS_PER_MAP)

layout(binding = 4) uniform usampler2DArray aligned_maps;
layout(std430, binding = 4) readonly buffer RomaDirections { RomaDirection roma_directions[]; };
layout(std140, binding = 4) uniform RomaCandidates {
    vec4 roma_centre; ///< of the scene, metres; w unused
    /// Candidates in an order in which neighbours have similar directions; xyz: unit direction, whose
    /// opposite can be traced as well; w: the map.
    vec4 roma_candidates[TRACER_CANDIDATE_COUNT];
};

ivec3 aligned_map_size(int map) { return ivec3(ROMA_SIDE); }

uint aligned_map_word(int map, ivec2 column, int word) {
    ivec3 place = ivec3(column, map * ROMA_LAYERS_PER_MAP + word / ROMA_WORDS_PER_TEXEL);
    return texelFetch(aligned_maps, place, 0)[word % ROMA_WORDS_PER_TEXEL];
}

vec3 tracer_candidate(int place) { return roma_candidates[place].xyz; }

RomaRay roma_ray_in(int map, bool forward, vec3 point, vec3 normal, float t_max) {
    precise vec3 relative = point - roma_centre.xyz;
    return roma_ray(roma_directions[map], forward, relative, normal, t_max, ROMA_SIDE);
}

/// The words of the ray's column, cut to the cells it passes. A ray without an end passes all cells
/// on one side of its start, which takes half a mask.
void roma_column(int map, RomaRay ray, bool unbounded, out uint words[ROMA_WORDS]) {
    RomaSpan span = ray.span;
    int border = ray.forward ? span.first : span.last + 1;
    for (int part = 0; part < ROMA_LAYERS_PER_MAP; ++part) {
        ivec3 place = ivec3(span.column, map * ROMA_LAYERS_PER_MAP + part);
        uvec4 texel = texelFetch(aligned_maps, place, 0);
        for (int i = 0; i < ROMA_WORDS_PER_TEXEL; ++i) {
            int word = part * ROMA_WORDS_PER_TEXEL + i;
            words[word] = texel[i] & (unbounded ? bits_from(word, border, !ray.forward)
                                                : bits_in_range(word, span.first, span.last));
        }
    }
}

bool roma_any_hit(int map, bool forward, vec3 point, vec3 normal, float t_max) {
    RomaRay ray = roma_ray_in(map, forward, point, normal, t_max);
    if (ray.span.first > ray.span.last)
        return false;
    uint words[ROMA_WORDS];
    roma_column(map, ray, t_max >= kRomaUnbounded, words);
    uint occupied = 0u;
    for (int word = 0; word < ROMA_WORDS; ++word)
        occupied |= words[word];
    return occupied != 0u;
}

float roma_closest_hit(int map, bool forward, vec3 point, vec3 normal, float t_max) {
    RomaRay ray = roma_ray_in(map, forward, point, normal, t_max);
    if (ray.span.first > ray.span.last)
        return -1.0;
    uint words[ROMA_WORDS];
    roma_column(map, ray, t_max >= kRomaUnbounded, words);
    int cell = -1;
    if (forward) {
        for (int word = ROMA_WORDS - 1; word >= 0; --word)
            if (words[word] != 0u)
                cell = 32 * word + findLSB(words[word]);
    } else {
        for (int word = 0; word < ROMA_WORDS; ++word)
            if (words[word] != 0u)
                cell = 32 * word + findMSB(words[word]);
    }
    if (cell < 0)
        return -1.0;
    return roma_hit_distance(cell, ray.surface, forward) * roma_directions[map].row_v.w;
}

bool tracer_candidate_any_hit(int place, vec3 point, vec3 normal, float t_max) {
    int map = int(roma_candidates[place].w);
    return roma_any_hit(map, roma_is_forward(roma_directions[map], normal), point, normal, t_max);
}

float tracer_candidate_closest_hit(int place, vec3 point, vec3 normal, float t_max) {
    int map = int(roma_candidates[place].w);
    bool forward = roma_is_forward(roma_directions[map], normal);
    return roma_closest_hit(map, forward, point, normal, t_max);
}

bool tracer_any_hit(vec3 point, vec3 normal, vec3 direction, float t_max) {
    int map = stratum_of_direction(direction, ROMA_ANGULAR_RESOLUTION);
    bool forward = roma_is_forward(roma_directions[map], direction);
    return roma_any_hit(map, forward, point, normal, t_max);
}

float tracer_closest_hit(vec3 point, vec3 normal, vec3 direction, float t_max) {
    int map = stratum_of_direction(direction, ROMA_ANGULAR_RESOLUTION);
    bool forward = roma_is_forward(roma_directions[map], direction);
    return roma_closest_hit(map, forward, point, normal, t_max);
}
