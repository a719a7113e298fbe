// SPDX-License-Identifier: MIT
// The cells of a pixel that traces, in two words: the one of its size with flags, and the next
// larger one with its weight.
#pragma once
#include "shaders/common/cross.h"
#include "shaders/reuse/spatial_hash/search.h"
#ifdef __cplusplus
namespace romascope::gpu {
#endif

// Flags of the first word.
const uint kCellTakes = 1u << 31;   ///< the pixel's rays are added to its cell
const uint kLargerTakes = 1u << 30; ///< and to the larger one
const uint kCellStale = 1u << 29;   ///< what the cell holds is no longer so
const uint kLargerStale = 1u << 28; ///< nor what the larger one holds
const uint kSlotBits = 0x1FFFFFFu;  ///< of either word: slot + 1, or 0 for none
const uint kWeightShift = 25u;
const float kFullWeight = 127.0f;

/// A weight as it is packed.
SHARED_FN float rounded_weight(float weight) {
    return float(int(weight * kFullWeight + 0.5f)) * (1.0f / kFullWeight);
}
SHARED_FN uint packed_slot(uint slot) { return slot == kNoSlot ? 0u : slot + 1u; }
SHARED_FN uint packed_larger(uint slot, float weight) {
    return packed_slot(slot) | (uint(weight * kFullWeight + 0.5f) << kWeightShift);
}
/// kNoSlot for none.
SHARED_FN uint unpacked_slot(uint word) { return (word & kSlotBits) - 1u; }
SHARED_FN float larger_weight(uint word) {
    return float(word >> kWeightShift) * (1.0f / kFullWeight);
}

#ifdef __cplusplus
} // namespace romascope::gpu
#endif
