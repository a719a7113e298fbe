// SPDX-License-Identifier: MIT
// A pass over a list of pixels: work groups of kListGroup in one dimension.
//
// In:   pixel_list, R32UI (pixel_list.h)
// Host: storage block 2: its head; an indirect dispatch by that
#include "shaders/estimators/pixel_list.h"

layout(local_size_x = kListGroup) in;
layout(binding = 2) uniform usampler2D pixel_list;
layout(std430, binding = 2) readonly buffer ListHead { PixelListHead list_head; };

/// False if this invocation has no pixel. What lies beyond the list's end is fetched as well, so that
/// one load need not wait for the other.
bool next_listed(out ivec2 pixel) {
    uint place = gl_WorkGroupID.y * kListRow + gl_WorkGroupID.x * kListGroup + gl_LocalInvocationIndex;
    uint width = uint(textureSize(pixel_list, 0).x);
    pixel = unpacked_pixel(texelFetch(pixel_list, ivec2(int(place % width), int(place / width)), 0).x);
    return place < list_head.pixel_count;
}
