// SPDX-License-Identifier: MIT
// Where a cell lies and how far what is added to it may: what decides whether a change is within
// its reach.
#pragma once
#include "shaders/reuse/spatial_hash/cell_key.h"
#ifdef __cplusplus
namespace romascope::gpu {
#endif

SHARED_FN vec3 cell_centre(CellKey key, float inverse_smallest) {
    EXACT float size = power_of_two(key.level) / inverse_smallest;
    EXACT vec3 centre = (vec3(key.cell) + 0.5f) * size;
    return centre;
}

/// How far from its centre points lie at most whose rays a cell takes, in cells: half its diagonal,
/// and as far as they are moved for the lookup, along the normal and across. `jitter`: cells.
SHARED_FN float cell_radius(float jitter) {
    return 0.8660255f + sqrt(kCellBias * kCellBias + 2.0f * jitter * jitter);
}

#ifdef __cplusplus
} // namespace romascope::gpu
#endif
