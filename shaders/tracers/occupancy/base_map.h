// SPDX-License-Identifier: MIT
// Where the words of the base occupancy map lie in a buffer: bit b of word w of column (x, y) is
// cell (x, y, 32 w + b).
#pragma once
#include "shaders/common/cross.h"
#ifdef __cplusplus
namespace romascope::gpu {
#endif

/// `size`: of the grid, cells.
SHARED_FN int base_place(ivec3 size, int x, int y, int word) {
    return (word * size.y + y) * size.x + x;
}

#ifdef __cplusplus
} // namespace romascope::gpu
#endif
