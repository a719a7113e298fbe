// SPDX-License-Identifier: MIT
#pragma once

#include "renderer/base/memory.h"
#include "renderer/scene/gltf/document.h"
#include "renderer/scene/scene.h"

#include <optional>

namespace romascope::gltf {

/// Decodes textures[index] of the model. What it takes comes from the budget; what stays taken are
/// its texels. None if the texture has no picture that can be read here: its source is missing, as
/// where only an extension names one.
/// Throws Error (kBadInput) "ELEMENT: reason" for a picture that is neither PNG nor JPEG, too
/// large, cut off or damaged.
std::optional<SurfaceTexture> read_texture(const Document& document, int index,
                                           MemoryBudget& budget);

} // namespace romascope::gltf
