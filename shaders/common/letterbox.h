// SPDX-License-Identifier: MIT
// A picture in a frame of other proportions: as large as fits, in the middle.
#pragma once
#include "shaders/common/cross.h"
#ifdef __cplusplus
namespace romascope::gpu {
#endif

/// The largest size with the proportions of `content`, rounded down, that fits in `frame`; at least
/// 1. Both are sizes of up to 2^15, at least 1.
SHARED_FN ivec2 letterbox_size(ivec2 content, ivec2 frame) {
    if (frame.x * content.y <= frame.y * content.x)
        return ivec2(frame.x, max(frame.x * content.y / content.x, 1));
    return ivec2(max(frame.y * content.x / content.y, 1), frame.y);
}

/// Where it begins.
SHARED_FN ivec2 letterbox_corner(ivec2 size, ivec2 frame) { return (frame - size) / 2; }

#ifdef __cplusplus
} // namespace romascope::gpu
#endif
