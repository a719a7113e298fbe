// SPDX-License-Identifier: MIT
// Turns the scene so that one axis of the occupancy grid looks along the view, with one pixel to a
// cell. Depth does not pass through clip space: nothing is clipped along the view, nothing rounded.
//
// Host: uniforms grid_origin (metres), cells_per_metre, grid_size (cells), axis (0 x, 1 y, 2 z);
//       ALPHA_MASK 0 or 1: hand on what the mask needs
layout(location = 0) in vec3 position;
uniform vec3 grid_origin;
uniform float cells_per_metre;
uniform ivec3 grid_size;
uniform int axis;
out float depth_in_cells;
#if ALPHA_MASK
layout(location = 2) in uint material;
layout(location = 3) in vec2 texcoord;
layout(location = 4) in vec4 color;
flat out uint material_index;
out vec2 surface_uv;
out float surface_vertex_alpha;
#endif

void main() {
    precise vec3 cell = (position - grid_origin) * cells_per_metre;
    ivec3 order = axis == 0 ? ivec3(1, 2, 0) : axis == 1 ? ivec3(2, 0, 1) : ivec3(0, 1, 2);
    vec2 across = vec2(cell[order.x], cell[order.y]);
    vec2 size = vec2(grid_size[order.x], grid_size[order.y]);
    depth_in_cells = cell[order.z];
#if ALPHA_MASK
    material_index = material;
    surface_uv = texcoord;
    surface_vertex_alpha = color.a;
#endif
    gl_Position = vec4(across / size * 2.0 - 1.0, 0.0, 1.0);
}
