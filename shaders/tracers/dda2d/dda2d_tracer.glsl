// SPDX-License-Identifier: MIT
// Tracer: from texel to texel of the base occupancy map; in each, the cells that the ray passes
// along z are tested at once (Thiedemann et al. 2011, Voxel-based Global Illumination). A texel is
// 32 cells high here, so rays also go from one to the next above. With the hierarchy a ray skips
// columns of up to 32 x 32 cells; where one is occupied at the ray's height, it goes down a level.
//
// Gives: tracer_any_hit, tracer_closest_hit (metres from the surface, negative for a miss)
// In:    grid_ray.glsl; hierarchy, R32UI, as hierarchy_levels.h has it
// Host:  DDA2D_ESCAPE, cells; DDA2D_HIERARCHY 0 or 1
#include "shaders/common/bits.h"
#include "shaders/tracers/dda2d/hierarchy_levels.h"
#include "shaders/tracers/occupancy/grid_ray.glsl"

#if DDA2D_HIERARCHY
layout(binding = 5) uniform usampler3D hierarchy;

uint dda2d_word(ivec3 cell, int level) {
    if (level == 0)
        return grid_word(cell);
    int begin = hierarchy_begin(level, hierarchy_padded(grid_size.x));
    return texelFetch(hierarchy, ivec3(begin + (cell.x >> level), cell.y >> level, cell.z >> 5), 0).x;
}
#else
uint dda2d_word(ivec3 cell, int level) { return grid_word(cell); }
#endif

/// Which cells from `first` to `last`, in either order, are occupied, as bits of the word of `first`.
uint dda2d_occupied(uint word, int first, int last) {
    return word & bits_in_range(first >> 5, min(first, last), max(first, last));
}

/// Where the first occupied cell is entered, as t, or -1.
float dda2d_walk(GridRay ray) {
    if (!(ray.t < ray.end))
        return -1.0;
    int level = 0;
    ivec3 words = ivec3(grid_size.xy, (grid_size.z + 31) >> 5);
    // Each turn either leaves a texel, after which it goes up a level at most, or goes down one.
    int limit = 2 * (words.x + words.y + words.z) + kHierarchyLevels;
    for (int i = 0; i < limit; ++i) {
        // Where the ray leaves the column of this level, and the texel along z.
        ivec3 shift = ivec3(level, level, 5);
        ivec3 block = ray.cell >> shift;
        ivec3 plane = (block + ray.ahead) << shift;
        vec3 next = vec3(grid_crossing(ray, 0, plane.x), grid_crossing(ray, 1, plane.y), grid_crossing(ray, 2, plane.z));
        int axis = grid_first(next);
        float t = min(next.x, min(next.y, next.z));
        bool ends = !(t < ray.end);
        // Cells that are entered before the end count, so what is crossed at it comes after.
        t = ends ? ray.end : t;
        int crossed = ends ? -1 : axis;
        int last = crossed == 2 ? plane.z - ray.ahead.z : grid_cell_at(ray, 2, t, crossed);
        uint occupied = dda2d_occupied(dda2d_word(ray.cell, level), ray.cell.z, last);
        if (occupied != 0u && level == 0) {
            int bit = ray.ahead.z == 1 ? findLSB(occupied) : findMSB(occupied);
            int hit = (block.z << 5) + bit;
            return hit == ray.cell.z ? ray.t : grid_crossing(ray, 2, hit + 1 - ray.ahead.z);
        }
        if (occupied != 0u) {
            --level;
            continue;
        }
        if (ends)
            return -1.0;
        ray.t = t;
        ivec3 entered = plane - 1 + ray.ahead;
#if DDA2D_HIERARCHY
        ray.cell.x = axis == 0 ? entered.x : grid_cell_at(ray, 0, t, axis);
        ray.cell.y = axis == 1 ? entered.y : grid_cell_at(ray, 1, t, axis);
        ray.cell.z = axis == 2 ? entered.z : last;
        // A wider column where a new one begins.
        if (level < kHierarchyLevels && (block.xy >> 1) != (ray.cell.xy >> (level + 1)))
            ++level;
#else
        ray.cell = ivec3(axis == 0 ? entered.x : ray.cell.x, axis == 1 ? entered.y : ray.cell.y,
                         axis == 2 ? entered.z : last);
#endif
    }
    return -1.0;
}

#define GRID_WALK dda2d_walk
#define GRID_ESCAPE DDA2D_ESCAPE
#include "shaders/tracers/occupancy/grid_walk.glsl"
