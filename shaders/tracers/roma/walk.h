// SPDX-License-Identifier: MIT
// Rays that keep their own direction in an aligned map: they pass from column to column, by the
// slope that is left between them and the map's direction. For the shaders and their CPU twin.
//
// A ray's way is measured in slices of the map that it has travelled since its start.
#pragma once
#include "shaders/common/exact_math.h"
#include "shaders/tracers/roma/span.h"
#ifdef __cplusplus
namespace romascope::gpu {
#endif

/// A ray on its way, in a column.
struct RomaWalk {
    ivec2 column;
    ivec2 turn;    ///< to the next column along u, v: -1 or 1
    vec2 next;     ///< where on its way it crosses to that one
    vec2 pace;     ///< slices from one column to the next
    float entered; ///< where it came into this column
    float leaves;  ///< where it has left the grid
    float ends;    ///< where its reach ends; infinite, if it has none
    float start;   ///< w of its start, or -w if it goes towards earlier slices: rises on its way
    float surface; ///< that of the surface point
    float metres_per_slice;
    bool forward; ///< towards later slices
};

/// 1 / x for any x; where that is too large it is 1e9, which no way is as long as.
SHARED_FN float roma_reciprocal(float x) {
    float size = abs(x);
    float inverse = size > 1e-9f ? exact_reciprocal(size) : 1e9f;
    return x < 0.0f ? -inverse : inverse;
}

/// Where a way that starts at `start` and gains `step` per slice lies between 0 and `size`, a cell
/// more on each side: from x to y, and nowhere if that is no way.
SHARED_FN vec2 roma_way_inside(vec3 start, vec3 step, vec3 size) {
    vec2 way = vec2(0.0f, 1e9f);
    for (int axis = 0; axis < 3; ++axis) {
        EXACT float to_low = (-1.0f - start[axis]) * roma_reciprocal(step[axis]);
        EXACT float to_high = (size[axis] + 1.0f - start[axis]) * roma_reciprocal(step[axis]);
        way = vec2(max(way.x, min(to_low, to_high)), min(way.y, max(to_low, to_high)));
    }
    return way;
}

/// `start`, `surface`: aligned coordinates of the ray's start and, third alone, of the surface
/// point; `direction`: in aligned coordinates, per metre; `inside`: where it is in the grid.
SHARED_FN RomaWalk roma_walk(vec3 start, float surface, vec3 direction, vec2 inside, float t_max) {
    RomaWalk walk;
    walk.forward = direction.z >= 0.0f;
    float sign = walk.forward ? 1.0f : -1.0f;
    walk.start = sign * start.z;
    walk.surface = sign * surface;
    walk.metres_per_slice = abs(roma_reciprocal(direction.z));
    EXACT float reach = t_max < kRomaUnbounded ? t_max * abs(direction.z) : t_max;
    EXACT float ends = walk.surface + reach - walk.start;
    walk.ends = ends;
    walk.entered = inside.x;
    walk.leaves = inside.y;
    for (int axis = 0; axis < 2; ++axis) {
        EXACT float slope = direction[axis] * walk.metres_per_slice;
        EXACT float place = start[axis] + slope * inside.x;
        place = roma_within(place, -1e6f, 1e6f);
        float cell = floor(place);
        float pace = abs(roma_reciprocal(slope));
        EXACT float border = inside.x + (slope < 0.0f ? place - cell : cell + 1.0f - place) * pace;
        walk.column[axis] = int(cell);
        walk.turn[axis] = slope < 0.0f ? -1 : 1;
        walk.next[axis] = border;
        walk.pace[axis] = pace;
    }
    return walk;
}

/// Where the ray goes over to the next column.
SHARED_FN float roma_walk_border(RomaWalk walk) { return min(walk.next.x, walk.next.y); }

SHARED_FN RomaWalk roma_walk_on(RomaWalk walk) {
    int axis = walk.next.x <= walk.next.y ? 0 : 1;
    walk.entered = walk.next[axis];
    walk.column[axis] += walk.turn[axis];
    EXACT float next = walk.next[axis] + walk.pace[axis];
    walk.next[axis] = next;
    return walk;
}

/// The cells of its column that the ray passes up to a place on its way.
SHARED_FN RomaSpan roma_walk_span(RomaWalk walk, float until, int count) {
    EXACT float from = walk.start + walk.entered;
    EXACT float to = walk.start + until;
    // Clamped before they become integers, which infinities and far points could not.
    float limit = float(count + 2);
    int first = int(floor(roma_within(from, -limit, limit)));
    int last = int(ceil(roma_within(to, -limit, limit))) - 1;
    RomaSpan span;
    span.column = walk.column;
    span.start = walk.forward ? first : -first - 1;
    span.first = max(walk.forward ? first : -last - 1, 0);
    span.last = min(walk.forward ? last : -first - 1, count - 1);
    return span;
}

/// Where on its way the ray enters a cell of its column.
SHARED_FN float roma_walk_entry(RomaWalk walk, int cell) {
    EXACT float face = float(walk.forward ? cell : -cell - 1) - walk.start;
    return max(face, walk.entered);
}

/// Metres from the surface to there, not below 0.
SHARED_FN float roma_walk_distance(RomaWalk walk, float entry) {
    EXACT float distance = (walk.start + entry - walk.surface) * walk.metres_per_slice;
    return max(distance, 0.0f);
}

/// Columns that a ray crosses per metre, in a map where it has this direction: the map to take is
/// the one with the fewest.
SHARED_FN float roma_crossings(vec3 direction) {
    EXACT float crossings = abs(direction.x) + abs(direction.y);
    return crossings;
}

#ifdef __cplusplus
} // namespace romascope::gpu
#endif
