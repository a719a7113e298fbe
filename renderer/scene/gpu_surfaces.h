// SPDX-License-Identifier: MIT
#pragma once

#include "renderer/gl/objects.h"
#include "renderer/scene/scene.h"

namespace romascope {

/// Where a texture lies in the buffer of all texels.
struct TexturePlace {
    uint32_t first_texel = 0;
    int first_level = 0; ///< above 0: the levels before are left out
    int levels = 0;      ///< that are there; 0: no material has this texture
    bool masks = false;  ///< a masked material has it
};

/// Gives every texture that a material has its place among at most `limit` texels. Where they are
/// too many, the finest levels are left out, the largest first, but never of textures that mask:
/// those decide at full size what is there. Throws Error if the rest does not fit either.
std::vector<TexturePlace> place_textures(const Scene& scene, size_t limit);

/// The scene's materials and textures on the GPU, for any shader: no sampler is needed, all texels
/// are in one buffer.
class GpuSurfaces {
public:
    explicit GpuSurfaces(const Scene& scene);

    /// Binds storage blocks 0 and 1 for shaders/common/material.glsl.
    void bind() const;
    size_t bytes() const { return materials_.bytes() + texels_.bytes(); }

private:
    Buffer materials_, texels_;
};

} // namespace romascope
