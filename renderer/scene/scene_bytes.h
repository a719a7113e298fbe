// SPDX-License-Identifier: MIT
#pragma once

#include "renderer/scene/scene.h"

#include <cstddef>

namespace romascope {

/// Memory that the elements of a scene's arrays take: geometry, textures, motion. Names and what
/// the arrays keep in reserve are not counted.
size_t scene_bytes(const Scene& scene);

} // namespace romascope
