// SPDX-License-Identifier: MIT
// What a slot of the spatial hash holds besides its checksum, 12 bytes in all, and what becomes of
// it at the end of a frame.
//
// Between frames, the word of hits has the frame of last use in its upper 16 bits, and that of
// samples has no flag. A cell in use is flagged and its time taken away, which leaves 32 and 31
// bits for a frame's sums: up to kMaxFrameSamples. Settling brings sums back to 16 bits.
#pragma once
#include "shaders/common/cross.h"
#ifdef __cplusplus
namespace romascope::gpu {
#endif

const uint kInUse = 0x80000000u;           ///< in the word of samples: used in this frame
const uint kSamplesMask = 0x7FFFFFFFu;     ///< the rest of it
const uint kHitsMask = 0xFFFFu;            ///< of the word of hits, where not in use
const uint kMaxSettled = 0xFFFFu;          ///< samples of a cell between frames
const uint kMaxFrameSamples = 0x7FFE0000u; ///< that a frame may add to one cell
/// The largest number of samples at which a cell can be told to take no more: sums that are halved
/// to fit do not fall below.
const int kMaxSampleCap = 32768;
const uint kMaxAge = 0x8000u; ///< frames; older cells stay at it

struct Cell {
    uint checksum; ///< 0: free
    uint hits;
    uint samples;
};

SHARED_FN uint cell_samples(Cell cell) { return cell.samples & kSamplesMask; }

SHARED_FN uint cell_hits(Cell cell) {
    return (cell.samples & kInUse) != 0u ? cell.hits : cell.hits & kHitsMask;
}

/// Frames since last use, modulo 2^16: right at any frame number, as frames count modulo 2^32.
SHARED_FN uint cell_age(Cell cell, uint frame) {
    return (cell.samples & kInUse) != 0u ? 0u : (frame - (cell.hits >> 16)) & 0xFFFFu;
}

/// The words of hits and samples of a cell at use, before anything is added: its sums still have 16
/// bits. Right also if one of the words was read before another invocation stored these, and the
/// other after it.
SHARED_FN uvec2 used_sums(uvec2 sums) { return uvec2(sums.x & kHitsMask, sums.y | kInUse); }

/// A cell after a frame. Sums beyond 16 bits are halved until they fit, both alike. Without use for
/// more than `max_age` frames it is free, all 0; `max_age` of at least kMaxAge: never.
SHARED_FN Cell settled_cell(Cell cell, uint frame, uint max_age) {
    if (cell.checksum == 0u)
        return cell;
    uint now = frame & 0xFFFFu;
    if ((cell.samples & kInUse) != 0u) {
        uint samples = cell.samples & kSamplesMask;
        int shift = max(findMSB(samples) - 15, 0);
        uint half_unit = (1u << uint(shift)) >> 1;
        samples = samples >> uint(shift);
        cell.hits = min((cell.hits + half_unit) >> uint(shift), samples) | (now << 16);
        cell.samples = samples;
        return cell;
    }
    uint age = (now - (cell.hits >> 16)) & 0xFFFFu;
    if (age > max_age && max_age < kMaxAge) {
        cell.checksum = 0u;
        cell.hits = 0u;
        cell.samples = 0u;
    } else if (age > kMaxAge) {
        cell.hits = (cell.hits & kHitsMask) | (((now - kMaxAge) & 0xFFFFu) << 16);
    }
    return cell;
}

/// As many samples as the next larger cell counts for in a cell that has few of its own: what is
/// seen of a new cell begins with what is known around it.
const float kPriorSamples = 16.0f;

/// The share of hits in a cell, by its own samples and those of the next larger one around it.
/// Without samples of either: -1. `weight` of the larger one, 0 to 1.
SHARED_FN float blended_hits(vec2 cell, vec2 larger, float weight) {
    if (larger.y == 0.0f)
        return cell.y == 0.0f ? -1.0f : cell.x / cell.y;
    float prior = larger.x / larger.y;
    float own = (cell.x + kPriorSamples * prior) / (cell.y + kPriorSamples);
    return own + (prior - own) * weight;
}

// What is counted in a frame, as places in a buffer of words.
const int kCountBackground = 0; ///< pixels that see no surface
const int kCountTraced = 1;     ///< pixels that traced rays
const int kCountFailed = 2;     ///< pixels without any cell
const int kCountInsertions = 3; ///< cells that became taken
const int kCountProbes = 4;     ///< the most slots that one search looked at, if more than one
const int kPixelCounts = 5;
const int kCountCells = 5; ///< taken after the frame
const int kCountEvictions = 6;
const int kCountSamples = 7; ///< cells by samples: below 4, 16, 64, 256, 1024, and more
const int kCountAges = 13;   ///< cells by frames since last use: 0, below 2, 4, 8, 16, and more
const int kHistogramBins = 6;
const int kCountRenewals = 19; ///< cells that were emptied, as something moved within their reach
const int kHashCounts = 20;
/// Slots that one invocation settles.
const uint kSettledEach = 8u;

SHARED_FN int samples_bin(uint samples) {
    return min(findMSB(samples | 1u) / 2, kHistogramBins - 1);
}
SHARED_FN int age_bin(uint age) { return min(findMSB(age) + 1, kHistogramBins - 1); }

#ifdef __cplusplus
} // namespace romascope::gpu
#endif
