// SPDX-License-Identifier: MIT
// Levels of the base occupancy map, each the OR of 2 x 2 columns of the level before, side by side
// along x in one texture. Level 0 is the map itself. For shaders and host alike.
#pragma once
#include "shaders/common/cross.h"
#ifdef __cplusplus
namespace romascope::gpu {
#endif

/// Columns of the coarsest level are the OR of 32 x 32, which is one work group's share.
const int kHierarchyLevels = 5;

/// Cells along one side, rounded up to whole columns of the coarsest level.
SHARED_FN int hierarchy_padded(int cells) {
    return (((cells - 1) >> kHierarchyLevels) + 1) << kHierarchyLevels;
}

/// Where level `level` >= 1 begins along x; with kHierarchyLevels + 1, where all end.
SHARED_FN int hierarchy_begin(int level, int padded) { return padded - (padded >> (level - 1)); }

#ifdef __cplusplus
} // namespace romascope::gpu
#endif
