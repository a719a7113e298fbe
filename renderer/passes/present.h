// SPDX-License-Identifier: MIT
#pragma once

#include "renderer/gl/program.h"
#include "renderer/passes/frame_context.h"

namespace romascope {

/// Makes of a linear picture what a screen shows: the very bytes that write_image puts in a PNG of
/// it, except that a pixel with NaN is magenta.
class Present {
public:
    /// `linear`: R32F, or RGBA32F whose alpha is not looked at. Returns RGBA8 of the same size, row
    /// 0 at the top; valid until the next call.
    const Texture& run(const ShaderLibrary& shaders, PassTimer& timer, const Texture& linear);
    StructureBytes bytes() const { return {"shown picture", picture_.bytes()}; }

    static ShaderVariant variant();

private:
    ProgramSlot program_;
    Buffer thresholds_; ///< std430 float[256]
    Texture picture_;
};

/// Copies a picture whose row 0 is its top to a framebuffer (0: the window's), as large as fits, in
/// the middle, black around it: texel for pixel where the sizes are equal, else interpolated.
/// The framebuffer is not multisampled. A picture without texels leaves all black.
void show(const Texture& picture, GLuint framebuffer, glm::ivec2 framebuffer_size);

} // namespace romascope
