// SPDX-License-Identifier: MIT
// What the deformation of moving vertices is told about each of their parts.
#pragma once
#include "shaders/common/cross.h"
#ifdef __cplusplus
namespace romascope::gpu {
#endif

/// Moving vertices to a row of invocations: a dispatch may have no more than 65535 groups across.
const uint kDeformRow = 1u << 20;

/// Consecutive vertices that move by the same rule. Laid out for std430.
struct DeformPart {
    uint first_vertex; ///< counted from the first moving one
    uint vertex_count;
    uint first_matrix;    ///< of the palette: one, or one per joint
    uint first_influence; ///< `influence_sets` for each vertex in turn
    uint influence_sets;  ///< 0: rigid
    uint first_delta;     ///< for each target in turn, one for each vertex
    uint target_count;
    uint first_weight; ///< of the targets
};

#ifdef __cplusplus
static_assert(sizeof(DeformPart) == 32);
} // namespace romascope::gpu
#endif
