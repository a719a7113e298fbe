// SPDX-License-Identifier: MIT
// Whether two points lie on one surface, as stages that mix values of pixels decide it: by distance
// from the tangent plane, which a slanted surface keeps however steep it is seen, and by normal.
#pragma once
#include "shaders/common/cross.h"
#ifdef __cplusplus
namespace romascope::gpu {
#endif

/// How far one of two points lies from the other's tangent plane, whichever is more. Normals are of
/// unit length.
SHARED_FN float plane_distance(vec3 a, vec3 normal_a, vec3 b, vec3 normal_b) {
    vec3 way = b - a;
    return max(abs(dot(way, normal_a)), abs(dot(way, normal_b)));
}

/// 1 for points of one plane, falling smoothly to 0 at either limit and 0 from there on, and for
/// what is not a number. `cosine`: between the normals; `cosine_limit` below 1.
SHARED_FN float edge_weight(float distance, float distance_limit, float cosine,
                            float cosine_limit) {
    float off = distance / distance_limit;
    float turn = (1.0f - cosine) / (1.0f - cosine_limit); // nearly the square of the angle's share
    if (!(off < 1.0f) || !(turn < 1.0f))
        return 0.0f;
    float flat_part = 1.0f - off * off;
    float turn_part = 1.0f - max(turn, 0.0f);
    return flat_part * flat_part * turn_part * turn_part;
}

#ifdef __cplusplus
} // namespace romascope::gpu
#endif
