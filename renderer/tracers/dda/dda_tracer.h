// SPDX-License-Identifier: MIT
#pragma once

#include "renderer/tracers/occupancy/grid_tracer.h"

namespace romascope {

inline const Knob<double> kDdaNormalOffset{
    {.key = "dda.normal_offset",
     .unit = "cells",
     .help = "How far a ray starts off its surface, along the normal.",
     .source = "as roma.normal_offset"},
    1.5,
    0.0,
    8.0};
inline const Knob<int> kDdaEscape{
    {.key = "dda.escape",
     .unit = "cells",
     .help = "How many occupied cells a ray may pass at its very start, where it leaves its own "
             "surface.",
     .source = "as roma.escape"},
    0,
    0,
    4};

std::vector<const KnobBase*> dda_knobs();

/// Rays from cell to cell through the base occupancy map (Amanatides and Woo 1987): the exact
/// answer for its cells.
class DdaTracer final : public GridTracer {
public:
    std::string shader_file() const override { return "tracers/dda/dda_tracer.glsl"; }
    std::vector<ShaderDefine> shader_defines(const Settings& settings) const override;
};

std::unique_ptr<Tracer> make_dda_tracer();

} // namespace romascope
