// SPDX-License-Identifier: MIT
// Fills a list of pixels.
//
// Out:  pixel_list, R32UI (pixel_list.h), at image unit 2
// Host: storage block 2: its head
#include "shaders/estimators/pixel_list.h"

layout(r32ui, binding = 2) writeonly uniform uimage2D pixel_list;
layout(std430, binding = 2) buffer ListHead { PixelListHead list_head; };

/// Room for `count` more pixels, at least one: the first place of it. For a work group at a time.
uint extend_list(uint count) {
    uint first = atomicAdd(list_head.pixel_count, count);
    atomicMax(list_head.groups_y, (first + count + kListRow - 1u) / kListRow);
    return first;
}

void list_pixel(uint place, ivec2 pixel) {
    uint width = uint(imageSize(pixel_list).x);
    imageStore(pixel_list, ivec2(int(place % width), int(place / width)), uvec4(packed_pixel(pixel)));
}
