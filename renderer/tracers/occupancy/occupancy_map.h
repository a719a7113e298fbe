// SPDX-License-Identifier: MIT
#pragma once

#include "renderer/tracers/occupancy/compute_builder.h"
#include "renderer/tracers/occupancy/raster_builder.h"

namespace romascope {

std::vector<const KnobBase*> occupancy_knobs();

/// The base occupancy map: one bit per cell of a grid around the scene, set where the scene is,
/// whichever side of it and without what masks leave out. Memory depends on the resolution alone.
class OccupancyMap {
public:
    void build(const FrameContext& frame, BaseStore store = BaseStore::texture);

    const OccupancyGrid& grid() const { return grid_; }
    const BaseMap& map() const { return map_; }
    StructureBytes bytes() const { return {"occupancy map", map_.bytes() + compute_.bytes()}; }
    /// What `bytes()` can come to at most under these settings: for a scene like a cube.
    static size_t bytes_needed(const Settings& settings);
    /// Copies the map to the CPU, for tests and for views.
    BitGrid download() const { return map_.download(); }

    /// All programs of the build, whatever the settings.
    static std::vector<ShaderVariant> variants();

private:
    RasterBuilder raster_;
    ComputeBuilder compute_;
    OccupancyGrid grid_;
    BaseMap map_;
};

} // namespace romascope
