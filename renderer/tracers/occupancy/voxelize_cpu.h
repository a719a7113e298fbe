// SPDX-License-Identifier: MIT
#pragma once

#include "renderer/scene/scene.h"
#include "renderer/tracers/occupancy/bit_grid.h"
#include "renderer/tracers/occupancy/occupancy_knobs.h"

namespace romascope {

/// The CPU twin of `ComputeBuilder`, bit for bit: the same test of triangle_cells.h for all cells
/// of each triangle's box. The scene as its vertices stand.
BitGrid voxelize_on_cpu(const Scene& scene, const OccupancyGrid& grid, OccupancyCoverage coverage);

} // namespace romascope
