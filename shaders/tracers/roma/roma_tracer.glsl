// SPDX-License-Identifier: MIT
// Tracer: rays through ray-aligned occupancy maps (Zeng et al. 2023, Algorithm 2). A ray is snapped
// to the candidate of its stratum, or the estimator chooses among the candidates itself; then it
// takes constant time. Or it keeps its direction, see unsnapped.glsl.
//
// Gives: tracer_any_hit, tracer_closest_hit (metres from the surface, negative for a miss); for the
//        candidate in a place of its order, turned to the side of the normal: tracer_candidate,
//        tracer_candidate_any_hit, tracer_candidate_closest_hit; for views: aligned_map_size,
//        aligned_map_word
// In:    rotated_maps.glsl or sheared_maps.glsl
// Host:  ROMA_SHEAR 0 or 1, ROMA_ANGULAR_RESOLUTION, ROMA_WORDS_PER_TEXEL, ROMA_TEXELS_PER_COLUMN,
//        ROMA_ESCAPE, ROMA_SNAP 0 or 1; without it ROMA_ITERATIONS
#include "shaders/tracers/roma/concentric.h"
#include "shaders/tracers/roma/walk.h" // before the choice: a file is taken once, in either branch
#define TRACER_CANDIDATE_COUNT (ROMA_ANGULAR_RESOLUTION * ROMA_ANGULAR_RESOLUTION)
#define ROMA_WORDS (ROMA_WORDS_PER_TEXEL * ROMA_TEXELS_PER_COLUMN)

layout(std140, binding = 4) uniform RomaCandidates {
    vec4 roma_centre; ///< of the scene, metres; w unused
    /// Candidates in an order in which neighbours have similar directions; xyz: unit direction, whose
    /// opposite can be traced as well; w: the map.
    vec4 roma_candidates[TRACER_CANDIDATE_COUNT];
};

#if ROMA_SHEAR
#include "shaders/tracers/roma/sheared_maps.glsl"
#else
#include "shaders/tracers/roma/rotated_maps.glsl"
#endif

vec3 tracer_candidate(int place) { return roma_candidates[place].xyz; }

/// The words of a column.
void roma_load(int map, ivec2 column, out uint words[ROMA_WORDS]) {
    ROMA_PLACE place = roma_place(map, column);
    for (int part = 0; part < ROMA_TEXELS_PER_COLUMN; ++part) {
        uvec4 texel = roma_texel(map, place, part);
        for (int i = 0; i < ROMA_WORDS_PER_TEXEL; ++i)
            words[part * ROMA_WORDS_PER_TEXEL + i] = texel[i];
    }
}

#if ROMA_ESCAPE
/// Occupied cells at the very start of a ray, at most `limit`.
int roma_run_in(uint words[ROMA_WORDS], RomaSpan span, bool forward, int limit) {
    int at = span.start >> 5;
    if (limit == 1) {
        uint bit = 1u << (span.start & 31), found = 0u;
        for (int word = 0; word < ROMA_WORDS; ++word)
            found |= word == at ? words[word] & bit : 0u;
        return found != 0u ? 1 : 0;
    }
    int after = forward ? at + 1 : at - 1;
    uint here = 0u, next = 0u;
    for (int word = 0; word < ROMA_WORDS; ++word) {
        here = word == at ? words[word] : here;
        next = word == after ? words[word] : next;
    }
    return roma_run(here, next, span.start, forward, limit);
}
#endif

/// Leaves the cells of a span.
void roma_cut(inout uint words[ROMA_WORDS], RomaSpan span, bool forward, bool unbounded) {
    for (int word = 0; word < ROMA_WORDS; ++word)
        words[word] &= roma_mask(word, span, forward, unbounded);
}

/// The words of a snapped ray's column, cut to the cells it passes.
void roma_column(int map, RomaRay ray, bool unbounded, out uint words[ROMA_WORDS]) {
    roma_load(map, ray.span.column, words);
    RomaSpan span = ray.span;
#if ROMA_ESCAPE
    // The first cell is skipped, occupied or not; only if it is may others be.
    int run = 1 + (ROMA_ESCAPE > 1 ? roma_run_in(words, span, ray.forward, ROMA_ESCAPE - 1) : 0);
    span = roma_escaped(span, run, ray.forward);
#endif
    roma_cut(words, span, ray.forward, unbounded);
}

/// The first occupied cell on a ray's way, or -1.
int roma_first_cell(uint words[ROMA_WORDS], bool forward) {
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
    return cell;
}

bool roma_any_hit(int map, bool forward, vec3 point, vec3 normal, float t_max) {
    RomaRay ray = roma_ray_in(map, forward, point, normal, t_max);
    if (roma_passes_none(ray.span))
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
    if (roma_passes_none(ray.span))
        return -1.0;
    uint words[ROMA_WORDS];
    roma_column(map, ray, t_max >= kRomaUnbounded, words);
    int cell = roma_first_cell(words, forward);
    if (cell < 0)
        return -1.0;
    return roma_hit_distance(cell, ray.surface, forward) * roma_metres_per_slice(map);
}

bool tracer_candidate_any_hit(int place, vec3 point, vec3 normal, float t_max) {
    int map = int(roma_candidates[place].w);
    return roma_any_hit(map, roma_forward_in(map, normal), point, normal, t_max);
}

float tracer_candidate_closest_hit(int place, vec3 point, vec3 normal, float t_max) {
    int map = int(roma_candidates[place].w);
    return roma_closest_hit(map, roma_forward_in(map, normal), point, normal, t_max);
}

#if ROMA_SNAP
bool tracer_any_hit(vec3 point, vec3 normal, vec3 direction, float t_max) {
    int map = stratum_of_direction(direction, ROMA_ANGULAR_RESOLUTION);
    return roma_any_hit(map, roma_forward_in(map, direction), point, normal, t_max);
}

float tracer_closest_hit(vec3 point, vec3 normal, vec3 direction, float t_max) {
    int map = stratum_of_direction(direction, ROMA_ANGULAR_RESOLUTION);
    return roma_closest_hit(map, roma_forward_in(map, direction), point, normal, t_max);
}
#else
#include "shaders/tracers/roma/unsnapped.glsl"

bool tracer_any_hit(vec3 point, vec3 normal, vec3 direction, float t_max) {
    return roma_unsnapped_hit(point, normal, direction, t_max) >= 0.0;
}

float tracer_closest_hit(vec3 point, vec3 normal, vec3 direction, float t_max) {
    return roma_unsnapped_hit(point, normal, direction, t_max);
}
#endif
