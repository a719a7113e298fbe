// SPDX-License-Identifier: MIT
// Rays in a ray-aligned occupancy map, however it was aligned: the slices that a snapped ray passes
// in its column, as a range of bits, and the distance of a hit. For the shaders and their CPU twin
// alike.
//
// "Aligned coordinates" (u, v, w) of a map are such that its direction is the third axis: the cells
// of column (i, j) are those at i <= u < i + 1, j <= v < j + 1, and its bit k, slice k, is the cell
// at k <= w < k + 1.
#pragma once
#include "shaders/common/bits.h"
#include "shaders/common/cross.h"
#ifdef __cplusplus
namespace romascope::gpu {
#endif

/// From here on a distance has no end. Tested with a comparison that a compiler can decide where
/// the distance is a constant; then nothing is spent on it.
const float kRomaUnbounded = 3.0e38f;

/// The nearest number to `x` from `low` to `high`, which can become an integer whatever `x` is:
/// `low` for NaN. Not clamp, whose min(max(x, low), high) lets NaN through where max(a, b) is a
/// unless a < b.
SHARED_FN float roma_within(float x, float low, float high) { return min(max(low, x), high); }

/// The cells a snapped ray passes: bits first..last of one column; none if first > last.
struct RomaSpan {
    ivec2 column;
    int first;
    int last;
    int start; ///< the slice that the ray starts in; it may lie outside of the map
};

/// A snapped ray in one aligned map.
struct RomaRay {
    RomaSpan span;
    float surface; ///< third aligned coordinate of the surface point
    bool forward;
};

/// The slices that a ray passes in a map of `count`, its column aside; they may go on beyond the
/// map, until they are cut to a column.
/// `start`: third aligned coordinate of the ray's origin, moved off the surface; it may lie
/// outside. `surface`: that of the surface point itself, from which `reach` counts. `reach`: how
/// far the ray goes, in slices; infinity allowed. A cell counts if the ray enters it before its
/// end. `forward`: towards later slices.
SHARED_FN RomaSpan roma_slices(float start, float surface, float reach, bool forward, int count) {
    RomaSpan span;
    span.column = ivec2(0);
    float limit = float(count);
    // Clamped before they become integers, which infinities and far points could not.
    // A ray that starts on a face between two cells is in the one ahead of it.
    float at = roma_within(start, -1.0f, limit + 1.0f);
    int below = int(floor(forward ? at : -at));
    span.start = forward ? below : -below - 1;
    span.first = forward ? span.start : 0;
    span.last = forward ? count - 1 : span.start;
    if (reach < kRomaUnbounded) {
        EXACT float end = forward ? surface + reach : surface - reach;
        end = roma_within(end, -1.0f, limit + 1.0f);
        if (forward)
            span.last = min(int(ceil(end)) - 1, count - 1);
        else
            span.first = max(int(floor(end)), 0);
    }
    return span;
}

/// How many occupied cells follow each other at the very start of a ray, at most `limit` < 32.
/// `at`: the word of the column that has the start's cell; `next`: the one after it in the ray's
/// direction, or 0.
SHARED_FN int roma_run(uint at, uint next, int start, bool forward, int limit) {
    int bit = start & 31;
    // Turned so that the start is bit 0 and the ray goes upwards.
    if (!forward) {
        at = bitfieldReverse(at);
        next = bitfieldReverse(next);
        bit = 31 - bit;
    }
    uint ahead = (at >> bit) | (bit == 0 ? 0u : next << (32 - bit));
    return findLSB(~(ahead & ((1u << limit) - 1u)));
}

/// Leaves out the first cells of a ray's way; `run` of them, if its start lies on it.
SHARED_FN RomaSpan roma_escaped(RomaSpan span, int run, bool forward) {
    if (forward && span.first == span.start)
        span.first += run;
    else if (!forward && span.last == span.start)
        span.last -= run;
    return span;
}

/// Distance in slices from the surface to where the ray enters the cell, not below 0.
SHARED_FN float roma_hit_distance(int cell, float surface, bool forward) {
    EXACT float distance = forward ? float(cell) - surface : surface - float(cell + 1);
    return max(distance, 0.0f);
}

#ifdef __cplusplus
} // namespace romascope::gpu
#endif
