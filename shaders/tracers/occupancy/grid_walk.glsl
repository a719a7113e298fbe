// SPDX-License-Identifier: MIT
// The end of a tracer that walks through the base occupancy map: its two functions, from how far a
// walk comes.
//
// Gives: tracer_any_hit, tracer_closest_hit (metres from the surface, negative for a miss)
// Needs: float GRID_WALK(GridRay): where the ray enters an occupied cell, in cells along it, or -1
//        GRID_ESCAPE: cells
#include "shaders/tracers/occupancy/grid_ray.glsl"

bool tracer_any_hit(vec3 point, vec3 normal, vec3 direction, float t_max) {
    return GRID_WALK(grid_leaving_ray(point, normal, direction, t_max, GRID_ESCAPE)) >= 0.0;
}

float tracer_closest_hit(vec3 point, vec3 normal, vec3 direction, float t_max) {
    GridRay ray = grid_leaving_ray(point, normal, direction, t_max, GRID_ESCAPE);
    float t = GRID_WALK(ray);
    return t < 0.0 ? -1.0 : grid_distance(ray, t, t_max);
}
