// SPDX-License-Identifier: MIT
#pragma once

#include "renderer/tracers/occupancy/occupancy_slice.h"
#include "renderer/tracers/tracer.h"

namespace romascope {

/// What tracers have in common that look at the base occupancy map itself: the map, and the
/// uniforms of shaders/tracers/occupancy/grid_ray.glsl.
class GridTracer : public Tracer {
public:
    void build(const FrameContext& frame) override;
    void bind(const Program& program) const override;
    std::vector<StructureBytes> bytes() const override;
    size_t bytes_needed(const Settings& settings) const override;
    std::vector<ShaderVariant> build_variants(const Settings& settings) const override;
    std::vector<std::string_view> views() const override { return {OccupancySlice::kName}; }
    void draw_view(const FrameContext& frame, std::string_view view,
                   const Texture& picture) override;

    /// Traces in a given map from now on: build() without the map's own. Keeps a reference to it.
    virtual void take(const FrameContext& frame, const Texture& base, const OccupancyGrid& grid);

private:
    OccupancyMap occupancy_;
    OccupancySlice slice_;
    const Texture* base_ = nullptr;
    OccupancyGrid grid_;
};

} // namespace romascope
