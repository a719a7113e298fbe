// SPDX-License-Identifier: MIT
#pragma once

#include "renderer/passes/frame_context.h"
#include "renderer/passes/view_uniforms.h"

namespace romascope {

/// What the camera sees at each pixel. Row 0 is the top of the picture. Backs of materials that
/// are not double-sided and what masks leave out are looked through.
class GBuffer {
public:
    /// Draws the scene; makes the textures anew where the size changed. `with_motion`: and how far
    /// each surface has come since GpuScene::remember_positions, which must have been called.
    void draw(const FrameContext& frame, const View& view, bool with_motion = false);

    const Texture& base_color() const { return base_color_; } ///< sRGB8
    const Texture& emission() const { return emission_; }     ///< R11G11B10F
    const Texture& depth() const { return depth_; }           ///< see bind_surface
    const Texture& normal() const { return normal_; }         ///< see bind_surface
    /// RGBA32F, metres in the world; without texels if the last draw was without.
    const Texture& motion() const { return motion_; }
    StructureBytes bytes() const;

    /// Binds depth (D32F, near / distance, 0: nothing) and normal (R32UI, octahedral) where
    /// shaders/common/surface.glsl reads them.
    void bind_surface() const;

    /// `detail`: the scene has texture coordinates or vertex colours; `masked`: for triangles with
    /// an alpha mask, which has the detail, too; `motion`: as draw is asked for.
    static ShaderVariant variant(bool detail, bool masked, bool motion = false);

private:
    void resize(glm::ivec2 size, bool with_motion);
    ProgramSlot program_, masked_program_;
    Texture depth_, normal_, base_color_, emission_, motion_;
    Framebuffer framebuffer_;
};

} // namespace romascope
