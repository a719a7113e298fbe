// SPDX-License-Identifier: MIT
#pragma once

#include "renderer/tracers/occupancy/leaving_knobs.h"
#include "renderer/tracers/occupancy/occupancy_slice.h"
#include "renderer/tracers/tracer.h"

#include <optional>

namespace romascope {

/// What tracers have in common that look at the base occupancy map itself: the map, and the
/// uniforms of shaders/tracers/occupancy/grid_ray.glsl.
class GridTracer : public Tracer {
public:
    std::string shader_file() const override { return shader_file_; }
    std::vector<ShaderDefine> shader_defines(const Settings& settings) const override;
    Leaving leaving() const override { return leaving_; }
    void build(const FrameContext& frame) override;
    void bind(const Program& program) const override;
    std::vector<StructureBytes> bytes() const override;
    size_t bytes_needed(const Settings& settings) const override;
    std::vector<ShaderVariant> build_variants(const Settings& settings) const override;
    std::vector<std::string_view> views() const override { return {OccupancySlice::kName}; }
    void draw_view(const FrameContext& frame, std::string_view view,
                   const Texture& picture) override;

    /// From the next build on rays leave their surface so, whatever the settings say: for the exact
    /// answer about rays of another tracer.
    void leave_as(const Leaving& leaving) { given_leaving_ = leaving; }

    /// Traces in a given map from now on: build() without the map's own. Keeps a reference to it.
    virtual void take(const FrameContext& frame, const Texture& base, const OccupancyGrid& grid);

protected:
    /// Its GLSL file; how rays leave their surface; further knobs that the file is compiled with.
    GridTracer(std::string shader_file, const Knob<double>& normal_offset, const Knob<int>& escape,
               std::vector<const KnobBase*> knobs = {})
        : shader_file_(std::move(shader_file)), normal_offset_(normal_offset), escape_(escape),
          knobs_(std::move(knobs)) {
        knobs_.push_back(&escape_);
    }

private:
    std::string shader_file_;
    const Knob<double>& normal_offset_;
    const Knob<int>& escape_;
    std::vector<const KnobBase*> knobs_;
    OccupancyMap occupancy_;
    OccupancySlice slice_;
    const Texture* base_ = nullptr;
    OccupancyGrid grid_;
    std::optional<Leaving> given_leaving_;
    Leaving leaving_;
};

} // namespace romascope
