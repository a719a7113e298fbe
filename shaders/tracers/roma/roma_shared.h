// SPDX-License-Identifier: MIT
// Ray-aligned occupancy maps by rotation (Zeng et al. 2023, Algorithms 1 and 2): what the
// generation and the tracing compute, for the shaders and their CPU twin alike.
//
// An aligned map is a box of side^3 cells around the scene, turned so that its third axis is a
// candidate direction; the cells of a column along that axis are consecutive bits. "Aligned
// coordinates" count its cells from one corner: cell (i, j, k) spans [i, i+1) x [j, j+1) x [k,
// k+1).
#pragma once
#include "shaders/tracers/roma/walk.h"
#ifdef __cplusplus
namespace romascope::gpu {
#endif

/// Fraction bits of the fixed-point base map coordinates. The sign and 11 bits of whole cells are
/// left: corners of a box around 256 cells lie within some 400 cells of the middle.
const int kRomaFractionBits = 20;

/// One aligned map. Laid out for std430.
struct RomaDirection {
    vec4 row_u; ///< xyz: aligned u = side / 2 + dot(row_u.xyz, point - centre), per metre
                ///< w: cells per metre along the candidate direction
    vec4 row_v; ///< xyz: likewise; w: metres per cell along the candidate direction
    vec4 row_w; ///< xyz: likewise, along the candidate direction; w: normal offset in metres
    ivec4
        base_origin; ///< base map coordinates of the centre of aligned cell (0, 0, 0), fixed point
    ivec4 base_step_u; ///< change of those from one aligned cell to the next
    ivec4 base_step_v;
    ivec4 base_step_w;
};

/// Fixed-point base map coordinates of the centre of an aligned cell.
SHARED_FN ivec3 roma_base_position(RomaDirection map, ivec3 cell) {
    return ivec3(map.base_origin) + ivec3(map.base_step_u) * cell.x +
           ivec3(map.base_step_v) * cell.y + ivec3(map.base_step_w) * cell.z;
}

/// Aligned coordinates of a point given in metres from the centre of the box.
SHARED_FN vec3 roma_aligned(RomaDirection map, vec3 point, int side) {
    float half_side = 0.5f * float(side);
    EXACT float u =
        map.row_u.x * point.x + map.row_u.y * point.y + map.row_u.z * point.z + half_side;
    EXACT float v =
        map.row_v.x * point.x + map.row_v.y * point.y + map.row_v.z * point.z + half_side;
    EXACT float w =
        map.row_w.x * point.x + map.row_w.y * point.y + map.row_w.z * point.z + half_side;
    return vec3(u, v, w);
}

/// Leaves the cells of a span that the box has: none, if the column lies beside it.
SHARED_FN RomaSpan roma_in_box(RomaSpan span, int side) {
    span.first = max(span.first, 0);
    span.last = min(span.last, side - 1);
    // As unsigned numbers, those below 0 are beyond the end as well.
    if (uint(span.column.x) >= uint(side) || uint(span.column.y) >= uint(side))
        span.last = span.first - 1;
    return span;
}

/// The cells that a snapped ray passes. `start`: aligned coordinates of the ray's origin, moved off
/// the surface; it may lie outside. The others as for roma_slices.
SHARED_FN RomaSpan roma_span(vec3 start, float surface, float reach, bool forward, int side) {
    RomaSpan span = roma_slices(start.z, surface, reach, forward, side);
    // Clamped before they become integers, which infinities and far points could not.
    float limit = float(side);
    span.column = ivec2(int(floor(roma_within(start.x, -1.0f, limit))),
                        int(floor(roma_within(start.y, -1.0f, limit))));
    return roma_in_box(span, side);
}

/// `point`: the surface point in metres from the centre of the box; `normal`: unit. `t_max`: metres
/// from the surface point, infinity allowed.
SHARED_FN RomaRay roma_ray(RomaDirection map, bool forward, vec3 point, vec3 normal, float t_max,
                           int side) {
    EXACT vec3 moved = point + normal * map.row_w.w;
    EXACT float reach = t_max < kRomaUnbounded ? t_max * map.row_u.w : t_max;
    RomaRay ray;
    ray.surface = roma_aligned(map, point, side).z;
    ray.forward = forward;
    ray.span = roma_span(roma_aligned(map, moved, side), ray.surface, reach, forward, side);
    return ray;
}

/// Whether a direction points to the candidate's side, rather than to its opposite's.
SHARED_FN bool roma_is_forward(RomaDirection map, vec3 direction) {
    EXACT float along =
        direction.x * map.row_w.x + direction.y * map.row_w.y + direction.z * map.row_w.z;
    return along >= 0.0f;
}

/// A direction in aligned coordinates, per metre.
SHARED_FN vec3 roma_turned(RomaDirection map, vec3 direction) {
    EXACT float u =
        map.row_u.x * direction.x + map.row_u.y * direction.y + map.row_u.z * direction.z;
    EXACT float v =
        map.row_v.x * direction.x + map.row_v.y * direction.y + map.row_v.z * direction.z;
    EXACT float w =
        map.row_w.x * direction.x + map.row_w.y * direction.y + map.row_w.z * direction.z;
    return vec3(u, v, w);
}

/// A ray that keeps its direction; the others as for roma_ray.
SHARED_FN RomaWalk roma_walk_in_box(RomaDirection map, vec3 point, vec3 normal, vec3 direction,
                                    float t_max, int side) {
    EXACT vec3 moved = point + normal * map.row_w.w;
    vec3 start = roma_aligned(map, moved, side);
    vec3 turned = roma_turned(map, direction);
    EXACT vec3 step = turned * abs(roma_reciprocal(turned.z));
    vec2 inside = roma_way_inside(start, step, vec3(float(side)));
    return roma_walk(start, roma_aligned(map, point, side).z, turned, inside, t_max);
}

#ifdef __cplusplus
} // namespace romascope::gpu
#endif
