// SPDX-License-Identifier: MIT
#include "renderer/scene/surface_mask.h"

#include "shaders/common/surface_texture.h"

namespace romascope {

static_assert(static_cast<uint32_t>(TextureWrap::repeat) == gpu::kWrapRepeat &&
              static_cast<uint32_t>(TextureWrap::mirror) == gpu::kWrapMirror &&
              static_cast<uint32_t>(TextureWrap::clamp) == gpu::kWrapClamp);

uint32_t texture_rules(const SurfaceTexture& texture, int levels) {
    return static_cast<uint32_t>(levels) |
           static_cast<uint32_t>(texture.wrap_u) << gpu::kWrapUShift |
           static_cast<uint32_t>(texture.wrap_v) << gpu::kWrapVShift |
           (texture.nearest ? gpu::kNearestBit : 0u);
}

float texture_alpha(const SurfaceTexture& texture, glm::vec2 uv) {
    const gpu::TexelSquare square = gpu::texel_square(uv, texture.size, texture_rules(texture, 1));
    const auto alpha = [&](int x, int y) {
        const size_t row = static_cast<size_t>(y) * static_cast<size_t>(texture.size.x);
        return static_cast<float>(texture.texels[row + static_cast<size_t>(x)] >> 24);
    };
    const glm::ivec4& at = square.texels;
    return gpu::bilinear_alpha(
        {alpha(at.x, at.y), alpha(at.z, at.y), alpha(at.x, at.w), alpha(at.z, at.w)},
        square.weight);
}

bool surface_is_there(const Material& material, const SurfaceTexture* texture, glm::vec2 uv,
                      float vertex_alpha) {
    return gpu::passes_mask(texture ? texture_alpha(*texture, uv) : 255.0f, material.alpha,
                            vertex_alpha, material.alpha_cutoff);
}

} // namespace romascope
