// SPDX-License-Identifier: MIT
// Tracer: a fixed number of cells looked up along the segment that a ray passes in the base
// occupancy map (Reinbothe et al. 2009, Hybrid Ambient Occlusion). Its cost is the same for every
// ray; between two samples it sees nothing.
//
// Gives: tracer_any_hit, tracer_closest_hit (metres from the surface, negative for a miss)
// In:    grid_ray.glsl
// Host:  SAMPLES_ESCAPE, cells; SAMPLES_COUNT
#include "shaders/tracers/occupancy/grid_ray.glsl"

/// The cell in the middle of part `i` of the segment.
ivec3 samples_cell(GridRay ray, int i) {
    // Any-hit and closest-hit are to look at the same cells.
    precise float t = ray.t + (float(i) + 0.5) / float(SAMPLES_COUNT) * (ray.end - ray.t);
    precise vec3 place = ray.start + t * ray.direction;
    return clamp(ivec3(floor(place)), ivec3(0), grid_size - 1);
}

bool tracer_any_hit(vec3 point, vec3 normal, vec3 direction, float t_max) {
    GridRay ray = grid_leaving_ray(point, normal, direction, t_max, SAMPLES_ESCAPE);
    if (!(ray.t < ray.end))
        return false;
    for (int i = 0; i < SAMPLES_COUNT; ++i) {
        ivec3 cell = samples_cell(ray, i);
        if (grid_bit(grid_word(cell), cell))
            return true;
    }
    return false;
}

float tracer_closest_hit(vec3 point, vec3 normal, vec3 direction, float t_max) {
    GridRay ray = grid_leaving_ray(point, normal, direction, t_max, SAMPLES_ESCAPE);
    if (!(ray.t < ray.end))
        return -1.0;
    for (int i = 0; i < SAMPLES_COUNT; ++i) {
        ivec3 cell = samples_cell(ray, i);
        if (!grid_bit(grid_word(cell), cell))
            continue;
        ivec3 behind = cell + 1 - ray.ahead;
        float t = max(max(ray.t, grid_crossing(ray, 0, behind.x)),
                      max(grid_crossing(ray, 1, behind.y), grid_crossing(ray, 2, behind.z)));
        return grid_distance(ray, t, t_max);
    }
    return -1.0;
}
