// SPDX-License-Identifier: MIT
#pragma once

#include "renderer/tracers/dda2d/hierarchy.h"
#include "renderer/tracers/occupancy/grid_tracer.h"

namespace romascope {

inline const Knob<bool> kDda2dHierarchy{
    {.key = "dda2d.hierarchy",
     .unit = "",
     .help = "Skip empty columns of up to 32 x 32 cells by coarser levels of the map, which are "
             "made anew every frame; the hits are the same.",
     .source = "Thiedemann et al. 2011, section 4.2"},
    true};
inline const Knob<double> kDda2dNormalOffset{
    {.key = "dda2d.normal_offset",
     .unit = "cells",
     .help = "How far a ray starts off its surface, along the normal.",
     .source = "as roma.normal_offset"},
    1.5,
    0.0,
    8.0};
inline const Knob<int> kDda2dEscape{
    {.key = "dda2d.escape",
     .unit = "cells",
     .help = "How many occupied cells a ray may pass at its very start, where it leaves its own "
             "surface.",
     .source = "as roma.escape"},
    0,
    0,
    4};

std::vector<const KnobBase*> dda2d_knobs();

/// Rays from texel to texel through the base occupancy map, with a test of a range of bits in each
/// (Thiedemann et al. 2011). The same hits as DdaTracer.
class Dda2dTracer final : public GridTracer {
public:
    std::string shader_file() const override { return "tracers/dda2d/dda2d_tracer.glsl"; }
    std::vector<ShaderDefine> shader_defines(const Settings& settings) const override;
    void bind(const Program& program) const override;
    std::vector<StructureBytes> bytes() const override;
    size_t bytes_needed(const Settings& settings) const override;
    std::vector<ShaderVariant> build_variants(const Settings& settings) const override;
    void take(const FrameContext& frame, const Texture& base, const OccupancyGrid& grid) override;

    const Hierarchy& hierarchy() const { return hierarchy_; } ///< for tests

private:
    Hierarchy hierarchy_; ///< empty if the settings want none
};

std::unique_ptr<Tracer> make_dda2d_tracer();

} // namespace romascope
