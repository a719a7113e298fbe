// SPDX-License-Identifier: MIT
#pragma once

#include "renderer/image/image.h"

namespace romascope {

/// What every metric asks of its two pictures: the same size, at least one pixel, 1 or 3 channels
/// each, no NaN and no infinity. Throws Error (kBadInput) with both sizes, or with the first pixel
/// (x, y from the top left) that is not a number.
void check_comparable(const Image& reference, const Image& test);

/// Channel c of a pixel, where a grey picture has the same value in every channel.
inline float channel_value(const Image& image, size_t pixel, int c) {
    return image.channels == 1 ? image.data[pixel] : image.data[pixel * 3 + static_cast<size_t>(c)];
}

} // namespace romascope
