// SPDX-License-Identifier: MIT
#pragma once

#include "renderer/gl/program.h"
#include "renderer/passes/frame_context.h"
#include "renderer/tracers/occupancy/bit_grid.h"

namespace romascope {

enum class OccupancyAxes { all, z };

inline const Knob<int> kOccupancyResolution{
    {.key = "occupancy.resolution",
     .unit = "cells",
     .help = "Cells of the occupancy map along the longest side of the scene.",
     .source = "Zeng et al. 2023, section 6"},
    128,
    32,
    256};
inline const Knob<double> kOccupancyJitter{
    {.key = "occupancy.jitter",
     .unit = "cells",
     .help = "How far the occupancy map is shifted at random from frame to frame.",
     .source = "Zeng et al. 2023, section 4.3: objects are jittered for each map"},
    1.0,
    0.0,
    1.0};
inline const Knob<OccupancyAxes> kOccupancyAxes{
    {.key = "occupancy.axes",
     .unit = "",
     .help = "Directions the scene is rasterised along: all three, or z alone, which leaves holes "
             "in steep surfaces.",
     .source = "Zeng et al. 2023, section 6"},
    OccupancyAxes::all,
    {"all", "z"}};

std::vector<const KnobBase*> occupancy_knobs();

/// The base occupancy map: one bit per cell of a grid around the scene, set where the scene is,
/// whichever side of it; what a mask leaves out at the cell's centre does not count.
/// Rasterised once per axis and joined with image atomics (Zeng et al. 2023, section 6; Eisemann
/// and Décoret 2006). Memory depends on the resolution alone.
class OccupancyMap {
public:
    void build(const FrameContext& frame);

    const OccupancyGrid& grid() const { return grid_; }
    /// R32UI, (size.x, size.y, ceil(size.z / 32)).
    const Texture& texture() const { return texture_; }
    StructureBytes bytes() const { return {"occupancy map", texture_.bytes()}; }
    /// What `bytes()` can come to at most under these settings: for a scene like a cube.
    static size_t bytes_needed(const Settings& settings);
    /// Copies the map to the CPU, for tests and for views.
    BitGrid download() const;

    /// `masked`: for triangles with an alpha mask.
    static ShaderVariant variant(bool masked);

private:
    ProgramSlot program_, masked_program_;
    OccupancyGrid grid_;
    Texture texture_;
    Framebuffer framebuffer_;
    int framebuffer_side_ = 0;
};

} // namespace romascope
