// SPDX-License-Identifier: MIT
// The stratum of a direction, found without a search: the inverse of the concentric mapping of the
// square to the disc (Shirley and Chiu 1997), with the disc lifted to the hemisphere about +z so
// that equal areas stay equal (Zeng et al. 2023, sections 4.1 and 4.2).
#pragma once
#include "shaders/common/exact_math.h"
#ifdef __cplusplus
namespace romascope::gpu {
#endif

/// Point of the square [-1, 1]^2 for a unit direction with z >= 0.
SHARED_FN vec2 square_from_hemisphere(vec3 direction) {
    float ax = direction.x < 0.0f ? -direction.x : direction.x;
    float ay = direction.y < 0.0f ? -direction.y : direction.y;
    EXACT float height = 1.0f - direction.z;
    EXACT float radius = exact_sqrt(max(height, 0.0f));
    float larger = max(ax, ay);
    float smaller = min(ax, ay);
    // At the pole the ratio has no meaning and the radius is 0 to rounding.
    EXACT float ratio = larger > 1e-18f ? min(smaller * exact_reciprocal(larger), 1.0f) : 0.0f;
    EXACT float across = radius * exact_atan_over_quarter_pi(ratio);
    float a = ax >= ay ? radius : across;
    float b = ax >= ay ? across : radius;
    return vec2(direction.x < 0.0f ? -a : a, direction.y < 0.0f ? -b : b);
}

/// Index (row by row) of the stratum among side * side, for any unit direction: one below the
/// horizon z = 0 shares the stratum of its opposite.
SHARED_FN int stratum_of_direction(vec3 direction, int side) {
    vec3 upper = direction.z < 0.0f ? -direction : direction;
    vec2 square = square_from_hemisphere(upper);
    EXACT float x = (square.x * 0.5f + 0.5f) * float(side);
    EXACT float y = (square.y * 0.5f + 0.5f) * float(side);
    int column = clamp(int(floor(x)), 0, side - 1);
    int row = clamp(int(floor(y)), 0, side - 1);
    return row * side + column;
}

#ifdef __cplusplus
} // namespace romascope::gpu
#endif
