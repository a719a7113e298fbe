// SPDX-License-Identifier: MIT
// Where a visible surface was in the previous frame, and what was seen there.
//
// In:   previous_depth, previous_normal: as the G-buffer had them; with MOTION gbuffer_motion: how far
//       the surface has come since, metres
// Host: MOTION 0 or 1; previous_eye: relative to eye; previous_corner, previous_step_x,
//       previous_step_y, previous_near: as in surface.glsl, of the previous view; previous_x,
//       previous_y, previous_forward: what v is relative to the previous eye is at the pixel
//       (v . x, v . y) / (v . forward), counted from the first pixel's centre, as if that view had
//       been shifted by as much as this one; plane_limit: metres for a surface one unit deep;
//       normal_limit: a cosine
#include "shaders/reuse/edges.h"
#include "shaders/reuse/from_eye.glsl"

layout(binding = 2) uniform sampler2D previous_depth;
layout(binding = 3) uniform usampler2D previous_normal;
#if MOTION
layout(binding = 4) uniform sampler2D gbuffer_motion;
#endif
uniform vec3 previous_eye;
uniform vec3 previous_corner;
uniform vec3 previous_step_x;
uniform vec3 previous_step_y;
uniform float previous_near;
uniform vec3 previous_x;
uniform vec3 previous_y;
uniform vec3 previous_forward;
uniform float plane_limit;
uniform float normal_limit;

struct Before {
    bool background;
    vec3 position; ///< relative to the previous eye; background: a direction
    vec3 normal;
    float depth;
    vec2 place; ///< in pixels, (0, 0) the first one's centre
    bool seen;  ///< the place is before the camera; whether in the picture is not said
};

Before before(ivec2 pixel) {
    Before b;
    float depth = depth_of(pixel);
    b.background = depth <= 0.0;
    b.normal = normal_of(pixel);
    if (b.background) {
        b.position = view_ray(pixel);
    } else {
        b.position = depth * view_ray(pixel) - previous_eye;
#if MOTION
        b.position -= texelFetch(gbuffer_motion, pixel, 0).xyz;
#endif
    }
    b.depth = dot(b.position, previous_forward);
    b.seen = b.depth > 0.0;
    vec2 place = vec2(dot(b.position, previous_x), dot(b.position, previous_y)) / b.depth;
    // Rounding must not blur what stands still, nor overflow what is far outside.
    vec2 steps = round(place * 256.0) / 256.0;
    b.seen = b.seen && all(lessThan(abs(place), vec2(1e6)));
    b.place = b.seen ? steps : vec2(-2.0);
    return b;
}

/// Whether a pixel of the previous frame showed this surface.
bool showed(Before b, ivec2 pixel) {
    if (!is_in_picture(pixel))
        return false;
    float stored = texelFetch(previous_depth, pixel, 0).x;
    if (b.background || stored <= 0.0)
        return b.background && stored <= 0.0;
    vec3 position = (previous_near / stored) *
                    (previous_corner + float(pixel.x) * previous_step_x + float(pixel.y) * previous_step_y);
    vec3 normal = decode_direction(texelFetch(previous_normal, pixel, 0).x);
    float distance = plane_distance(b.position, b.normal, position, normal);
    return edge_weight(distance, plane_limit * b.depth, dot(b.normal, normal), normal_limit) > 0.0;
}
