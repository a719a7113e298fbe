// SPDX-License-Identifier: MIT
#pragma once

#include "renderer/gl/program.h"
#include "renderer/passes/frame_context.h"
#include "renderer/tracers/occupancy/base_map.h"

namespace romascope {

/// Rasterises the scene once per axis, a pixel to a cell, and joins what it hits with image atomics
/// (Zeng et al. 2023, section 6; Eisemann and Décoret 2006). A cell is set where the surface is at
/// the cell's centre seen along an axis, and where the mask leaves it there.
class RasterBuilder {
public:
    /// Adds the scene's cells to `map`.
    void build(const FrameContext& frame, const OccupancyGrid& grid, const BaseMap& map);

    static std::vector<ShaderVariant> variants();

private:
    ProgramSlot program_, masked_program_;
    Framebuffer framebuffer_;
    int framebuffer_side_ = 0;
};

} // namespace romascope
