// SPDX-License-Identifier: MIT
// The pixels at which an estimator traces, one after another in a picture of the frame's size that
// is filled row by row. Whoever makes the list also writes how many work groups go over it, so that
// passes over a short list cost little. Their order is any: nothing may depend on it.
#pragma once
#include "shaders/common/cross.h"
#ifdef __cplusplus
namespace romascope::gpu {
#endif

const uint kListGroup = 64u; ///< invocations of a work group, one to a pixel
/// Work groups in a row of a dispatch, as their number is limited.
const uint kListGroupsInX = 256u;
const uint kListRow = kListGroup * kListGroupsInX;

/// Begins with the numbers of work groups of an indirect dispatch.
struct PixelListHead {
    uint groups_x; ///< kListGroupsInX
    uint groups_y;
    uint groups_z; ///< 1
    uint pixel_count;
};

SHARED_FN uint packed_pixel(ivec2 pixel) { return uint(pixel.x) | (uint(pixel.y) << 16); }
SHARED_FN ivec2 unpacked_pixel(uint word) { return ivec2(int(word & 0xFFFFu), int(word >> 16)); }

#ifdef __cplusplus
} // namespace romascope::gpu
#endif
