// SPDX-License-Identifier: MIT
// Ambient occlusion: the share of cosine-distributed rays from a surface point that meet nothing
// within the radius (Zeng et al. 2023, equation 1). Background is 1.
//
// In:   the G-buffer; "tracer.glsl", chosen by the host
// Out:  visibility, R16, one value in [0, 1] per pixel and frame: fine enough for any number of rays
// Host: AO_UNBOUNDED 0 or 1, else radius in metres; AO_RAYS; SAMPLE_CANDIDATES 0 or 1; frame; seed_key: the hashed seed;
//       AO_LISTED 0 or 1: only pixels of a list are traced and written (listed_pixels.glsl)
#include "shaders/common/random.h"
#include "shaders/common/surface.glsl"
#include "shaders/common/tangent_frame.glsl"
#include "tracer.glsl"

#if AO_LISTED
#include "shaders/estimators/listed_pixels.glsl"
#else
layout(local_size_x = 16, local_size_y = 8) in;
#endif
layout(r16, binding = 0) writeonly uniform image2D visibility;
uniform uint seed_key;
uniform uint frame;
#if AO_UNBOUNDED
#define RAY_LENGTH uintBitsToFloat(0x7F800000u) // a constant, so that the ray's end costs nothing
#else
uniform float radius;
#define RAY_LENGTH radius
#endif

#if SAMPLE_CANDIDATES
int is_free(int place, Surface surface) {
    return tracer_candidate_any_hit(place, surface.position, surface.normal, RAY_LENGTH) ? 0 : 1;
}

/// Chooses among the tracer's candidates with probability proportional to |n . c|, each turned to
/// the side of the normal: unbiased for the set of candidates, and no ray falls below its surface.
/// All rays of the pixel lie evenly over the summed weights, taken in an order in which neighbours
/// have similar directions; the van der Corput sequence moves them from frame to frame, so that
/// successive frames fill the gaps.
int free_rays(ivec2 pixel, Surface surface) {
    float total = 0.0;
    for (int i = 0; i < TRACER_CANDIDATE_COUNT; ++i)
        total += abs(dot(surface.normal, tracer_candidate(i)));
    float step = total / float(AO_RAYS);
    float shift = unit_float(van_der_corput(frame, pixel_hash(uvec2(pixel), seed_key)));
    int free = 0;
    // The candidates of four rays are looked for in one go.
    for (int first = 0; first < AO_RAYS; first += 4) {
        vec4 targets = step * (vec4(first, first + 1, first + 2, first + 3) + shift);
        ivec4 places = ivec4(0);
        float sum = 0.0;
        for (int i = 0; i < TRACER_CANDIDATE_COUNT - 1; ++i) {
            sum += abs(dot(surface.normal, tracer_candidate(i)));
            places += ivec4(greaterThanEqual(targets, vec4(sum)));
        }
        free += is_free(places.x, surface);
        if (first + 1 < AO_RAYS)
            free += is_free(places.y, surface);
        if (first + 2 < AO_RAYS)
            free += is_free(places.z, surface);
        if (first + 3 < AO_RAYS)
            free += is_free(places.w, surface);
    }
    return free;
}
#else
/// Cosine-distributed unit direction about the normal (Malley: a uniform disc, lifted).
vec3 cosine_direction(vec3 normal, vec2 u) {
    mat2x3 tangents = tangent_frame(normal);
    float angle = 6.28318530718 * u.x;
    vec2 disc = sqrt(u.y) * vec2(cos(angle), sin(angle));
    return disc.x * tangents[0] + disc.y * tangents[1] + sqrt(1.0 - u.y) * normal;
}

int free_rays(ivec2 pixel, Surface surface) {
    uint first = pixel_hash(uvec2(pixel), seed_key);
    uvec2 shift = uvec2(first, pcg_hash(first));
    int free = 0;
    for (int i = 0; i < AO_RAYS; ++i) {
        uvec2 u = r2_sequence(frame * uint(AO_RAYS) + uint(i), shift);
        vec3 direction = cosine_direction(surface.normal, vec2(unit_float(u.x), unit_float(u.y)));
        if (!tracer_any_hit(surface.position, surface.normal, direction, RAY_LENGTH))
            ++free;
    }
    return free;
}
#endif

void main() {
#if AO_LISTED
    ivec2 pixel;
    if (!next_listed(pixel))
        return;
#else
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(pixel, picture_size)))
        return;
#endif
    Surface surface = surface_at(pixel);
    float value = surface.background ? 1.0 : float(free_rays(pixel, surface)) / float(AO_RAYS);
    imageStore(visibility, pixel, vec4(value));
}
