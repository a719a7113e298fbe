// SPDX-License-Identifier: MIT
#pragma once

#include "renderer/tracers/occupancy/occupancy_slice.h"
#include "renderer/tracers/tracer.h"

namespace romascope {

/// What tracers have in common that look at the base occupancy map itself: the map, and the
/// uniforms of shaders/tracers/occupancy/grid_ray.glsl.
class GridTracer : public Tracer {
public:
    std::string shader_file() const override { return shader_file_; }
    std::vector<ShaderDefine> shader_defines(const Settings& settings) const override {
        return romascope::shader_defines(settings, knobs_);
    }
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

protected:
    /// Its GLSL file, and the knobs that this is compiled with.
    GridTracer(std::string shader_file, std::vector<const KnobBase*> knobs)
        : shader_file_(std::move(shader_file)), knobs_(std::move(knobs)) {}

private:
    std::string shader_file_;
    std::vector<const KnobBase*> knobs_;
    OccupancyMap occupancy_;
    OccupancySlice slice_;
    const Texture* base_ = nullptr;
    OccupancyGrid grid_;
};

} // namespace romascope
