// SPDX-License-Identifier: MIT
// Rays through the base occupancy map, for tracers that look at its own cells. All of them decide by
// the same numbers which cells a ray passes, and in which order: plane i of an axis is crossed at
// grid_crossing(), planes that are crossed at once in the order x, y, z.
//
// Lengths and t are in cells. t is 0 at the start, which has been moved off the surface.
//
// Vectors are taken apart by constant places only: others cost NVIDIA's GPUs a way through memory.
//
// In: base_map, R32UI: bit b of texel z is cell 32 z + b along z; uniforms grid_origin: lower corner,
//     metres; metres_per_cell; grid_size, cells; grid_offset: how far rays start off their surface,
//     along its normal, cells

layout(binding = 4) uniform usampler3D base_map;
uniform vec3 grid_origin;
uniform float metres_per_cell;
uniform ivec3 grid_size;
uniform float grid_offset;

struct GridRay {
    vec3 start;
    vec3 direction;
    vec3 per_cell; ///< t from plane to plane, with the sign of the direction
    ivec3 turn;    ///< 1 or -1: which way cells follow each other
    ivec3 ahead;   ///< 1 or 0: the plane ahead of cell c is c + ahead, the one behind it c + 1 - ahead
    ivec3 cell;    ///< where the ray is
    float t;       ///< where it entered that cell, or 0
    float end;     ///< cells that are entered before it count; every one before it is in the grid
    float moved;   ///< how far the start is from the surface, along the ray
    bool inside;   ///< the start lies in the grid
};

float grid_crossing(GridRay ray, int axis, int plane) {
    precise float t = (float(plane) - ray.start[axis]) * ray.per_cell[axis];
    return t;
}

/// Whether a plane of `axis` that is crossed at `own` comes before one of axis `crossed` at `t`.
bool grid_passes(float own, int axis, float t, int crossed) {
    return own < t || (own == t && axis < crossed);
}

/// The cell along `axis` when the ray is at `t` and has just crossed a plane of axis `crossed`.
int grid_cell_at(GridRay ray, int axis, float t, int crossed) {
    // Rounding can be off by one.
    int cell = int(floor(ray.start[axis] + t * ray.direction[axis]));
    if (grid_passes(grid_crossing(ray, axis, cell + ray.ahead[axis]), axis, t, crossed))
        return cell + ray.turn[axis];
    float behind = grid_crossing(ray, axis, cell + 1 - ray.ahead[axis]);
    bool after_start = behind > 0.0; // else it is a face of the first cell
    if (after_start && !grid_passes(behind, axis, t, crossed))
        return cell - ray.turn[axis];
    return cell;
}

uint grid_word(ivec3 cell) { return texelFetch(base_map, ivec3(cell.xy, cell.z >> 5), 0).x; }

bool grid_bit(uint word, ivec3 cell) { return ((word >> (cell.z & 31)) & 1u) != 0u; }

/// `point`: a surface point, metres. `t_max`: metres from the surface. No cell counts (t >= end) if
/// the ray misses the grid.
GridRay grid_ray(vec3 point, vec3 normal, vec3 direction, float t_max) {
    GridRay ray;
    precise vec3 start = (point - grid_origin) / metres_per_cell + grid_offset * normal;
    ray.start = start;
    ray.direction = direction;
    ray.ahead = ivec3(greaterThanEqual(direction, vec3(0.0)));
    ray.turn = 2 * ray.ahead - 1;
    ray.per_cell = vec3(ray.turn) / max(abs(direction), vec3(1e-20));
    ray.moved = grid_offset * dot(normal, direction);
    ray.t = 0.0;
    // Points far away are no integers.
    ray.cell = ivec3(floor(clamp(start, vec3(-1.0), vec3(grid_size))));
    ray.inside = all(greaterThanEqual(ray.cell, ivec3(0))) && all(lessThan(ray.cell, grid_size));
    ivec3 last = ray.ahead * grid_size; // the planes through which rays leave the grid
    ray.end = min(grid_crossing(ray, 0, last.x), min(grid_crossing(ray, 1, last.y), grid_crossing(ray, 2, last.z)));
    ray.end = min(ray.end, t_max / metres_per_cell - ray.moved);
    if (!ray.inside) {
        ivec3 first = grid_size - last;
        vec3 entries = vec3(grid_crossing(ray, 0, first.x), grid_crossing(ray, 1, first.y), grid_crossing(ray, 2, first.z));
        ray.t = max(max(entries.x, entries.y), max(entries.z, 0.0));
        int axis = entries.z == ray.t ? 2 : entries.y == ray.t ? 1 : 0;
        if (ray.t < ray.end) {
            ivec3 inner = first - 1 + ray.ahead;
            ray.cell.x = axis == 0 ? inner.x : grid_cell_at(ray, 0, ray.t, axis);
            ray.cell.y = axis == 1 ? inner.y : grid_cell_at(ray, 1, ray.t, axis);
            ray.cell.z = axis == 2 ? inner.z : grid_cell_at(ray, 2, ray.t, axis);
            ray.cell = clamp(ray.cell, ivec3(0), grid_size - 1);
        }
    }
    return ray;
}

/// Where the ray crosses the planes ahead of its cell.
vec3 grid_next(GridRay ray) {
    ivec3 plane = ray.cell + ray.ahead;
    return vec3(grid_crossing(ray, 0, plane.x), grid_crossing(ray, 1, plane.y), grid_crossing(ray, 2, plane.z));
}

/// The axis whose plane is crossed first.
int grid_first(vec3 next) { return next.x <= next.y && next.x <= next.z ? 0 : next.y <= next.z ? 1 : 2; }

/// Moves the ray past the occupied cells at its very start, at most `limit`: those of its own
/// surface.
void grid_escape(inout GridRay ray, int limit) {
    if (!ray.inside)
        return;
    for (int i = 0; i < limit && ray.t < ray.end; ++i) {
        if (!grid_bit(grid_word(ray.cell), ray.cell))
            return;
        vec3 next = grid_next(ray);
        int axis = grid_first(next);
        ray.t = min(next.x, min(next.y, next.z));
        ray.cell += ray.turn * ivec3(axis == 0, axis == 1, axis == 2);
    }
}

/// A ray that leaves its own surface: moved along the normal, then past cells.
GridRay grid_leaving_ray(vec3 point, vec3 normal, vec3 direction, float t_max, int escape) {
    GridRay ray = grid_ray(point, normal, direction, t_max);
    grid_escape(ray, escape);
    return ray;
}

/// Distance from the surface to where the ray is at `t`, metres, within [0, t_max].
float grid_distance(GridRay ray, float t, float t_max) { return clamp((t + ray.moved) * metres_per_cell, 0.0, t_max); }
