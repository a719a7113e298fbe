// SPDX-License-Identifier: MIT
// Turns the scene so that one axis of the occupancy grid looks along the view, with one pixel to a
// cell. Depth does not pass through clip space: nothing is clipped along the view, nothing rounded.
//
// Host: uniforms grid_origin (metres), cells_per_metre, grid_size (cells), axis (0 x, 1 y, 2 z)
layout(location = 0) in vec3 position;
uniform vec3 grid_origin;
uniform float cells_per_metre;
uniform ivec3 grid_size;
uniform int axis;
out float depth_in_cells;

void main() {
    precise vec3 cell = (position - grid_origin) * cells_per_metre;
    ivec3 order = axis == 0 ? ivec3(1, 2, 0) : axis == 1 ? ivec3(2, 0, 1) : ivec3(0, 1, 2);
    vec2 across = vec2(cell[order.x], cell[order.y]);
    vec2 size = vec2(grid_size[order.x], grid_size[order.y]);
    depth_in_cells = cell[order.z];
    gl_Position = vec4(across / size * 2.0 - 1.0, 0.0, 1.0);
}
