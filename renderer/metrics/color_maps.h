// SPDX-License-Identifier: MIT
#pragma once

#include "renderer/image/image.h"

namespace romascope {

/// A 1-channel map as colours of "magma": 0 is black, `scale` and above is pale yellow. The result
/// is linear, and encoded to an 8-bit PNG has exactly the map's 256 colours. `scale` > 0.
Image magma_picture(const Image& map, float scale = 1);

/// A signed 1-channel map as blue (-scale and below), white (0), red (scale and above), straight
/// in sRGB between them. The result is linear. `scale` > 0.
Image diverging_picture(const Image& map, float scale);

} // namespace romascope
