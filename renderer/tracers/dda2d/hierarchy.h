// SPDX-License-Identifier: MIT
#pragma once

#include "renderer/gl/program.h"
#include "renderer/passes/frame_context.h"

namespace romascope {

/// Coarser levels of the base occupancy map: a column is the OR of 2 x 2 columns of the level
/// before, with all cells along z kept (Thiedemann et al. 2011, section 4.2). Made in compute.
class Hierarchy {
public:
    /// `base`: R32UI, (Nx, Ny, ceil(Nz / 32)).
    void build(const FrameContext& frame, const Texture& base);

    /// R32UI, levels side by side along x: shaders/tracers/dda2d/hierarchy_levels.h.
    const Texture& texture() const { return texture_; }
    size_t bytes() const { return texture_.bytes(); }
    /// Bytes for a base map of this size in texels.
    static size_t bytes_for(glm::ivec3 base);
    static ShaderVariant variant();

private:
    ProgramSlot program_;
    Texture texture_;
};

} // namespace romascope
