// SPDX-License-Identifier: MIT
#pragma once

#include "renderer/gl/program.h"
#include "renderer/passes/frame_context.h"
#include "renderer/tracers/occupancy/bit_grid.h"
#include "renderer/tracers/occupancy/occupancy_knobs.h"

namespace romascope {

/// Finds the cells of each triangle in compute, as triangle_cells.h says: small triangles by one
/// invocation each, large ones cut into strips by way of a list, so that no invocation works long.
/// The same cells whatever the order of triangles, and the same as `voxelize_on_cpu`.
///
/// A mask is looked up once for each cell and line: thin where the line through the cell's centre
/// meets the triangle, like the rasteriser; conservative where that along the axis that the
/// triangle faces most does, or beside the triangle at the edge.
class ComputeBuilder {
public:
    /// False for a scene that is too large for this driver's texel buffers and storage blocks:
    /// triangles are found by their place in buffers.
    static bool takes(const GpuScene& scene);

    /// Adds the scene's cells to `map`.
    void build(const FrameContext& frame, const OccupancyGrid& grid, const Texture& map);

    size_t bytes() const { return work_list_.bytes() + empty_head_.bytes(); }
    /// What bytes() are once built.
    static size_t bytes_needed();
    static std::vector<ShaderVariant> variants();

private:
    struct Programs {
        ProgramSlot small, large;
    };
    void run(const FrameContext& frame, const OccupancyGrid& grid, bool masked, size_t first,
             size_t count);

    Programs plain_, masked_;
    Buffer work_list_;  ///< WorkListHead, entries
    Buffer empty_head_; ///< what the head is before a dispatch
};

} // namespace romascope
