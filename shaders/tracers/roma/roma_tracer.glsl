// SPDX-License-Identifier: MIT
// Tracer: snapped rays through ray-aligned occupancy maps (Zeng et al. 2023, Algorithm 2), in
// constant time. Gives the functions that every tracer gives (shaders/tracers/tracer.md), and, as a
// tracer of a fixed set of directions, the candidates to choose from.
//
// In:   aligned_maps, directions as written by rotate.comp.glsl; Candidates: unit directions
// Host: ROMA_ANGULAR_RESOLUTION, ROMA_SIDE, ROMA_WORDS_PER_TEXEL, ROMA_LAYERS_PER_MAP,
//       ROMA_NORMAL_OFFSET in cells of the aligned maps
#include "shaders/tracers/roma/concentric.h"
#include "shaders/tracers/roma/roma_shared.h"

#define TRACER_HAS_CANDIDATES 1
#define TRACER_CANDIDATE_COUNT (ROMA_ANGULAR_RESOLUTION * ROMA_ANGULAR_RESOLUTION)
#define ROMA_WORDS (ROMA_WORDS_PER_TEXEL * ROMA_LAYERS_PER_MAP)

layout(binding = 4) uniform usampler2DArray aligned_maps;
layout(std430, binding = 4) readonly buffer RomaDirections { RomaDirection roma_directions[]; };
layout(std140, binding = 4) uniform RomaCandidates {
    vec4 roma_centre; ///< xyz: of the cube, metres; w: size of an aligned cell, metres
    vec4 roma_candidates[TRACER_CANDIDATE_COUNT];
};

/// Unit direction of a candidate; its opposite can be traced as well.
vec3 tracer_candidate(int index) { return roma_candidates[index].xyz; }

struct RomaRay {
    int map;
    bool forward;
    float surface; ///< aligned coordinate along the ray of the surface point
    RomaSpan span;
};

RomaRay roma_ray(int map, bool forward, vec3 point, vec3 normal, float t_max) {
    RomaRay ray;
    ray.map = map;
    ray.forward = forward;
    RomaDirection direction = roma_directions[map];
    vec3 relative = point - roma_centre.xyz;
    vec3 start = roma_aligned(direction, relative + normal * (ROMA_NORMAL_OFFSET * roma_centre.w));
    ray.surface = roma_aligned(direction, relative).z;
    ray.span = roma_span(start, ray.surface, t_max / roma_centre.w, forward, ROMA_SIDE);
    return ray;
}

/// The words of the ray's column, cut to the cells it passes.
void roma_column(RomaRay ray, out uint words[ROMA_WORDS]) {
    for (int part = 0; part < ROMA_LAYERS_PER_MAP; ++part) {
        uvec4 texel = texelFetch(aligned_maps, ivec3(ray.span.column, ray.map * ROMA_LAYERS_PER_MAP + part), 0);
        for (int i = 0; i < ROMA_WORDS_PER_TEXEL; ++i) {
            int word = part * ROMA_WORDS_PER_TEXEL + i;
            words[word] = texel[i] & bits_in_range(word, ray.span.first, ray.span.last);
        }
    }
}

bool roma_any_hit(RomaRay ray) {
    if (ray.span.first > ray.span.last)
        return false;
    uint words[ROMA_WORDS];
    roma_column(ray, words);
    uint any_bit = 0u;
    for (int word = 0; word < ROMA_WORDS; ++word)
        any_bit |= words[word];
    return any_bit != 0u;
}

/// Metres from the surface to the first occupied cell, or a negative number.
float roma_closest_hit(RomaRay ray) {
    if (ray.span.first > ray.span.last)
        return -1.0;
    uint words[ROMA_WORDS];
    roma_column(ray, words);
    int cell = -1;
    if (ray.forward) {
        for (int word = ROMA_WORDS - 1; word >= 0; --word)
            if (words[word] != 0u)
                cell = 32 * word + findLSB(words[word]);
    } else {
        for (int word = 0; word < ROMA_WORDS; ++word)
            if (words[word] != 0u)
                cell = 32 * word + findMSB(words[word]);
    }
    return cell < 0 ? -1.0 : roma_hit_distance(cell, ray.surface, ray.forward) * roma_centre.w;
}

bool tracer_candidate_any_hit(int index, bool forward, vec3 point, vec3 normal, float t_max) {
    return roma_any_hit(roma_ray(index, forward, point, normal, t_max));
}

float tracer_candidate_closest_hit(int index, bool forward, vec3 point, vec3 normal, float t_max) {
    return roma_closest_hit(roma_ray(index, forward, point, normal, t_max));
}

/// The candidate that stands for a direction, turned to its side.
RomaRay roma_snapped(vec3 direction, vec3 point, vec3 normal, float t_max) {
    int map = stratum_of_direction(direction, ROMA_ANGULAR_RESOLUTION);
    bool forward = dot(direction, roma_candidates[map].xyz) >= 0.0;
    return roma_ray(map, forward, point, normal, t_max);
}

bool tracer_any_hit(vec3 point, vec3 normal, vec3 direction, float t_max) {
    return roma_any_hit(roma_snapped(direction, point, normal, t_max));
}

float tracer_closest_hit(vec3 point, vec3 normal, vec3 direction, float t_max) {
    return roma_closest_hit(roma_snapped(direction, point, normal, t_max));
}
