// SPDX-License-Identifier: MIT
#pragma once

#include "renderer/scene/scene.h"

namespace romascope {

/// Alpha of a texture at (u, v), in [0, 255]: between the four texels around it, at full size. The
/// same bits as in shaders (shaders/common/material.glsl).
float texture_alpha(const SurfaceTexture& texture, glm::vec2 uv);

/// Whether the surface is there, or masked out. `texture`: the material's, null if it has none.
bool surface_is_there(const Material& material, const SurfaceTexture* texture, glm::vec2 uv,
                      float vertex_alpha);

/// How shaders are told to look a texture up: MaterialRecord::texture_rules.
uint32_t texture_rules(const SurfaceTexture& texture, int levels);

} // namespace romascope
