// SPDX-License-Identifier: MIT
// The visible surface at a pixel, from the G-buffer.
//
// In:   gbuffer_depth (reversed, infinite far plane: 0 is the background), gbuffer_normal
// Host: uniforms eye, view_forward, view_right, view_down: the direction through the picture at
//       (x, y) in [-1, 1]^2, y down, is forward + x right + y down; near_plane; picture_offset:
//       sub-pixel jitter in pixels
#include "shaders/common/octahedral.glsl"

layout(binding = 0) uniform sampler2D gbuffer_depth;
layout(binding = 1) uniform usampler2D gbuffer_normal;
uniform vec3 eye;
uniform vec3 view_forward;
uniform vec3 view_right;
uniform vec3 view_down;
uniform float near_plane;
uniform vec2 picture_offset;
uniform ivec2 picture_size;

struct Surface {
    bool background;
    vec3 position;
    vec3 normal;
};

vec3 view_ray(ivec2 pixel) {
    vec2 place = (vec2(pixel) + 0.5 + picture_offset) / vec2(picture_size) * 2.0 - 1.0;
    return view_forward + place.x * view_right + place.y * view_down;
}

Surface surface_at(ivec2 pixel) {
    Surface surface;
    float depth = texelFetch(gbuffer_depth, pixel, 0).x;
    surface.background = depth <= 0.0;
    surface.position = eye + view_ray(pixel) * (near_plane / max(depth, 1e-30));
    surface.normal = decode_direction(texelFetch(gbuffer_normal, pixel, 0).x);
    return surface;
}
