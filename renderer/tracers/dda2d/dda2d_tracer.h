// SPDX-License-Identifier: MIT
#pragma once

#include "renderer/tracers/dda2d/hierarchy.h"
#include "renderer/tracers/occupancy/grid_tracer.h"
#include "renderer/tracers/occupancy/leaving_knobs.h"

namespace romascope {

inline const Knob<bool> kDda2dHierarchy{
    {.key = "dda2d.hierarchy",
     .unit = "",
     .help = "Skip empty columns of up to 32 x 32 cells by coarser levels of the map, which are "
             "made anew every frame; the hits are the same.",
     .source = "Thiedemann et al. 2011, section 4.2"},
    true};
inline const Knob<double> kDda2dNormalOffset = normal_offset_knob(
    "dda2d.normal_offset", "fewest wrong rays, see docs/user/error-split.md", 1.0);
inline const Knob<int> kDda2dEscape =
    escape_knob("dda2d.escape", "fewest wrong rays, see docs/user/error-split.md", 2);

std::vector<const KnobBase*> dda2d_knobs();

/// Rays from texel to texel through the base occupancy map, with a test of a range of bits in each
/// (Thiedemann et al. 2011). The same hits as DdaTracer.
class Dda2dTracer final : public GridTracer {
public:
    Dda2dTracer()
        : GridTracer("tracers/dda2d/dda2d_tracer.glsl", kDda2dNormalOffset, kDda2dEscape,
                     {&kDda2dHierarchy}) {}
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
