// SPDX-License-Identifier: MIT
#pragma once

#include "renderer/gl/program.h"
#include "renderer/passes/frame_context.h"
#include "renderer/tracers/occupancy/base_map.h"
#include "renderer/tracers/occupancy/occupancy_knobs.h"

namespace romascope {

/// Finds the cells of each triangle in compute, as triangle_cells.h says: small triangles in place,
/// large ones cut into pieces by way of a list, so that no invocation works long. Either one
/// invocation does a small triangle, or those of a work group share the columns of several.
/// The same cells whatever the order of triangles, and the same as `voxelize_on_cpu`.
///
/// A mask is looked up once for each cell and line: thin where the line through the cell's centre
/// meets the triangle, like the rasteriser; conservative where that along the axis that the
/// triangle faces most does, or beside the triangle at the edge.
class ComputeBuilder {
public:
    /// Whether the scene is not too large for this driver's texel buffers and storage blocks, by
    /// which triangles are found: see beyond_compute().
    static bool takes(const GpuScene& scene);

    /// Adds the scene's cells to `map`.
    void build(const FrameContext& frame, const OccupancyGrid& grid, const BaseMap& map);

    size_t bytes() const { return work_list_.bytes(); }
    /// What bytes() are once built.
    static size_t bytes_needed();
    static std::vector<ShaderVariant> variants();

private:
    struct Programs {
        ProgramSlot small, large;
    };
    void run(const FrameContext& frame, const OccupancyGrid& grid, BaseStore store, bool masked,
             size_t first, size_t count);

    Programs plain_, masked_;
    Buffer work_list_; ///< two WorkListHead, entries
    size_t head_ = 0;  ///< which of them is in use
};

} // namespace romascope
