// SPDX-License-Identifier: MIT
// Vertices of the scene, in world space, to clip space.
//
// Host: SURFACE_DETAIL 0 or 1: the scene has texture coordinates or vertex colours; MOTION 0 or 1:
//       where vertices were before is known
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in uint material;
uniform mat4 view_projection; ///< of points relative to `eye`, which keeps precision far from 0
uniform vec3 eye;
out vec3 from_eye;
#if MOTION
layout(location = 5) in vec3 previous_position;
out vec3 moved;
#endif
out vec3 world_normal;
flat out uint material_index;
#if SURFACE_DETAIL
layout(location = 3) in vec2 texcoord;
layout(location = 4) in vec4 color;
out vec2 surface_uv;
out vec4 surface_vertex_color;
#endif

void main() {
    from_eye = position - eye;
#if MOTION
    moved = position - previous_position;
#endif
    world_normal = normal;
    material_index = material;
#if SURFACE_DETAIL
    surface_uv = texcoord;
    surface_vertex_color = color;
#endif
    gl_Position = view_projection * vec4(from_eye, 1.0);
}
