// SPDX-License-Identifier: MIT
// The picture to look at: lit by one sun, or by the scene's lights, and by a sky, ambient occlusion
// multiplied in; or one of the intermediate results.
//
// In:   the G-buffer, base colour, emission, visibility (R16)
// Out:  picture RGBA32F, linear
// Host: FRAME_VIEW and FRAME_VIEW_*; LIT_HIGHLIGHTS and LIT_HIGHLIGHTS_*; sun_strength, sky_strength;
//       sun_direction: unit, towards the sun; sun_shines 0 or 1; light_count; storage block 0:
//       LightRecord, their colours exposed so that an irradiance of 1 is as strong as the sun's;
//       depth_range: where depth is black, metres
#include "shaders/common/surface.glsl"
#include "shaders/passes/light.h"

layout(local_size_x = 16, local_size_y = 16) in;
layout(binding = 2) uniform sampler2D gbuffer_base_color;
layout(binding = 3) uniform sampler2D gbuffer_emission;
layout(binding = 4) uniform sampler2D visibility;
layout(rgba32f, binding = 0) writeonly uniform image2D picture;
uniform vec3 sun_direction;
uniform float sun_strength;
uniform float sky_strength;
uniform int sun_shines;
uniform int light_count;
uniform float depth_range;
layout(std430, binding = 0) readonly buffer Lights { LightRecord lights[]; };

const vec3 kSunColor = vec3(1.0, 0.93, 0.8);
const vec3 kZenithColor = vec3(0.36, 0.52, 0.82);
const vec3 kHorizonColor = vec3(0.78, 0.84, 0.92);
const vec3 kGroundColor = vec3(0.36, 0.33, 0.30);

/// Radiance of the sky in a direction, y up.
vec3 sky(vec3 direction) {
    float up = direction.y;
    vec3 above = mix(kHorizonColor, kZenithColor, sqrt(max(up, 0.0)));
    return mix(above, kGroundColor, smoothstep(0.0, 0.1, -up));
}

/// What the sky gives to a surface that sees a hemisphere of it.
vec3 sky_light(vec3 normal) {
    return mix(kGroundColor, 0.5 * (kHorizonColor + kZenithColor), 0.5 + 0.5 * normal.y);
}

vec3 lit(ivec2 pixel, Surface surface) {
    if (surface.background)
        return sky_strength * sky(normalize(view_ray(pixel)));
    vec3 base = texelFetch(gbuffer_base_color, pixel, 0).rgb;
    vec3 emission = texelFetch(gbuffer_emission, pixel, 0).rgb;
    vec3 direct = sun_shines != 0 ? kSunColor * max(dot(surface.normal, sun_direction), 0.0) : vec3(0.0);
    for (int i = 0; i < light_count; ++i)
        direct += light_irradiance(lights[i], surface.position, surface.normal);
    vec3 light = sun_strength * direct + sky_strength * sky_light(surface.normal);
    return base * light * texelFetch(visibility, pixel, 0).x + emission;
}

/// Identity up to 0.3, from there on bent, with the same slope, towards 1.
vec3 with_soft_highlights(vec3 color) {
    const float knee = 0.3;
    vec3 bent = 1.0 - (1.0 - knee) * exp((knee - color) / (1.0 - knee));
    return mix(color, bent, greaterThan(color, vec3(knee)));
}

/// Grey whose 8 bits fall evenly from the camera to depth_range; blue where nothing is.
vec3 depth_color(ivec2 pixel, Surface surface) {
    if (surface.background)
        return vec3(0.02, 0.05, 0.2);
    float depth = near_plane / texelFetch(gbuffer_depth, pixel, 0).x;
    float grey = clamp(1.0 - depth / depth_range, 0.0, 1.0);
    return vec3(grey <= 0.04045 ? grey / 12.92 : pow((grey + 0.055) / 1.055, 2.4));
}

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(pixel, picture_size)))
        return;
    Surface surface = surface_at(pixel);
#if FRAME_VIEW == FRAME_VIEW_LIT
    vec3 color = lit(pixel, surface);
#if LIT_HIGHLIGHTS == LIT_HIGHLIGHTS_SOFT
    color = with_soft_highlights(color);
#endif
#elif FRAME_VIEW == FRAME_VIEW_DEPTH
    vec3 color = depth_color(pixel, surface);
#elif FRAME_VIEW == FRAME_VIEW_NORMAL
    vec3 color = surface.background ? vec3(0.0) : surface.normal * 0.5 + 0.5;
#elif FRAME_VIEW == FRAME_VIEW_BASE_COLOR
    vec3 color = surface.background ? vec3(0.0) : texelFetch(gbuffer_base_color, pixel, 0).rgb;
#endif
    imageStore(picture, pixel, vec4(color, 1.0));
}
