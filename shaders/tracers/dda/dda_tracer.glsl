// SPDX-License-Identifier: MIT
// Tracer: from cell to cell through the base occupancy map (Amanatides and Woo 1987, A Fast Voxel
// Traversal Algorithm for Ray Tracing). Exact about the cells. The word of 32 cells along z is kept
// until the ray leaves it.
//
// Gives: tracer_any_hit, tracer_closest_hit (metres from the surface, negative for a miss)
// In:    grid_ray.glsl
// Host:  DDA_ESCAPE, cells
#include "shaders/tracers/occupancy/grid_ray.glsl"

/// Where the first occupied cell is entered, as t, or -1.
float dda_walk(GridRay ray) {
    if (!(ray.t < ray.end))
        return -1.0;
    vec3 next = grid_next(ray);
    uint word = grid_word(ray.cell);
    int limit = grid_size.x + grid_size.y + grid_size.z;
    for (int i = 0; i < limit; ++i) {
        if (grid_bit(word, ray.cell))
            return ray.t;
        ray.t = min(next.x, min(next.y, next.z));
        if (!(ray.t < ray.end))
            return -1.0;
        ivec3 before = ray.cell;
        if (next.x == ray.t) {
            ray.cell.x += ray.turn.x;
            next.x = grid_crossing(ray, 0, ray.cell.x + ray.ahead.x);
        } else if (next.y == ray.t) {
            ray.cell.y += ray.turn.y;
            next.y = grid_crossing(ray, 1, ray.cell.y + ray.ahead.y);
        } else {
            ray.cell.z += ray.turn.z;
            next.z = grid_crossing(ray, 2, ray.cell.z + ray.ahead.z);
        }
        if (before.xy != ray.cell.xy || ((before.z ^ ray.cell.z) & ~31) != 0)
            word = grid_word(ray.cell);
    }
    return -1.0;
}

#define GRID_WALK dda_walk
#define GRID_ESCAPE DDA_ESCAPE
#include "shaders/tracers/occupancy/grid_walk.glsl"
