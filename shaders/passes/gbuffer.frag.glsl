// SPDX-License-Identifier: MIT
// What the camera sees: shading normal, base colour, emission; depth is the framebuffer's.
//
// Out:  0 R32UI octahedral normal that faces the camera; 1 sRGB8 base colour; 2 R11G11B10F emission;
//       with MOTION 3 RGBA32F: how far the surface has come since the last frame, metres
// Host: SURFACE_DETAIL 0 or 1: texture and vertex colour count; ALPHA_MASK 0 or 1: what the mask
//       leaves out is not drawn; MOTION 0 or 1
#include "shaders/common/material.glsl"
in vec3 from_eye;
in vec3 world_normal;
flat in uint material_index;
#if SURFACE_DETAIL
in vec2 surface_uv;
in vec4 surface_vertex_color;
#endif
#if MOTION
in vec3 moved;
layout(location = 3) out vec4 out_motion;
#endif
layout(location = 0) out uint out_normal;
layout(location = 1) out vec4 out_base_color;
layout(location = 2) out vec4 out_emission;
#include "shaders/common/octahedral.glsl"

void main() {
    // Derivatives come first: after a discard they are undefined.
    vec3 facing = cross(dFdx(from_eye), dFdy(from_eye));
#if SURFACE_DETAIL
    vec2 uv_dx = dFdx(surface_uv);
    vec2 uv_dy = dFdy(surface_uv);
#endif
#if ALPHA_MASK
    if (!surface_is_there(material_index, surface_uv, surface_vertex_color.a))
        discard;
#endif
    // The side that faces the viewer is the triangle's own; the shading normal follows it.
    if (dot(facing, from_eye) > 0.0)
        facing = -facing;
    float length_squared = dot(world_normal, world_normal);
    vec3 n = length_squared > 0.0 ? world_normal * inversesqrt(length_squared) : normalize(facing);
    out_normal = encode_direction(dot(n, facing) < 0.0 ? -n : n);
#if SURFACE_DETAIL
    vec3 base = surface_color(material_index, surface_uv, uv_dx, uv_dy) * surface_vertex_color.rgb;
#else
    vec3 base = materials[material_index].base_color.rgb;
#endif
    out_base_color = vec4(base, 1.0);
#if MOTION
    out_motion = vec4(moved, 0.0);
#endif
    out_emission = vec4(materials[material_index].emissive.rgb, 1.0);
}
