// SPDX-License-Identifier: MIT
#pragma once

#include "renderer/passes/frame_context.h"
#include "renderer/passes/view_uniforms.h"

namespace romascope {

/// What the camera sees at each pixel. Row 0 is the top of the picture. Backs of materials that
/// are not double-sided and what masks leave out are looked through.
class GBuffer {
public:
    /// Draws the scene; makes the textures anew where the size changed.
    void draw(const FrameContext& frame, const View& view);

    const Texture& base_color() const { return base_color_; } ///< sRGB8
    const Texture& emission() const { return emission_; }     ///< R11G11B10F
    StructureBytes bytes() const;

    /// Binds depth (D32F, near / distance, 0: nothing) and normal (R32UI, octahedral) where
    /// shaders/common/surface.glsl reads them.
    void bind_surface() const;

    /// `detail`: the scene has texture coordinates or vertex colours; `masked`: for triangles with
    /// an alpha mask, which has the detail, too.
    static ShaderVariant variant(bool detail, bool masked);

private:
    void resize(glm::ivec2 size);
    ProgramSlot program_, masked_program_;
    Texture depth_, normal_, base_color_, emission_;
    Framebuffer framebuffer_;
};

} // namespace romascope
