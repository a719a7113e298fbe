// SPDX-License-Identifier: MIT
// Cells along a ray as bits of 32-bit words: bit b of word w is cell 32 w + b.
#pragma once
#include "shaders/common/cross.h"
#ifdef __cplusplus
namespace romascope::gpu {
#endif

/// Mask of the cells first..last (both included) that lie in word `word`. An empty range, or one
/// that does not touch the word, gives 0. No shift by 32, which both languages leave undefined.
SHARED_FN uint bits_in_range(int word, int first, int last) {
    int low = max(first - 32 * word, 0);
    int high = min(last - 32 * word, 31);
    if (low > high)
        return 0u;
    return (0xFFFFFFFFu << low) & (0xFFFFFFFFu >> (31 - high));
}

/// Mask of the cells from `cell` on, or of those before it, that lie in word `word`.
SHARED_FN uint bits_from(int word, int cell, bool before) {
    int low = max(cell - 32 * word, 0);
    uint from = low > 31 ? 0u : 0xFFFFFFFFu << low;
    return before ? ~from : from;
}

#ifdef __cplusplus
} // namespace romascope::gpu
#endif
