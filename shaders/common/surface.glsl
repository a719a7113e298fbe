// SPDX-License-Identifier: MIT
// The visible surface at a pixel, from the G-buffer.
//
// In:   gbuffer_depth (reversed, infinite far plane: 0 is the background), gbuffer_normal
// Host: uniforms eye; view_corner, view_step_x, view_step_y: the direction through the centre of
//       pixel (x, y) is corner + x step_x + y step_y, one unit deep; near_plane; picture_size
#include "shaders/common/octahedral.glsl"

layout(binding = 0) uniform sampler2D gbuffer_depth;
layout(binding = 1) uniform usampler2D gbuffer_normal;
uniform vec3 eye;
uniform vec3 view_corner;
uniform vec3 view_step_x;
uniform vec3 view_step_y;
uniform float near_plane;
uniform ivec2 picture_size;

struct Surface {
    bool background;
    vec3 position;
    vec3 normal;
};

vec3 view_ray(ivec2 pixel) {
    return view_corner + float(pixel.x) * view_step_x + float(pixel.y) * view_step_y;
}

Surface surface_at(ivec2 pixel) {
    Surface surface;
    float depth = texelFetch(gbuffer_depth, pixel, 0).x;
    surface.background = depth <= 0.0;
    surface.position = eye + view_ray(pixel) * (near_plane / max(depth, 1e-30));
    surface.normal = decode_direction(texelFetch(gbuffer_normal, pixel, 0).x);
    return surface;
}
